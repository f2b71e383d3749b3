# Sourced by bench.sh: how fast caches are simulated, in this thread's processor time.
if wanted cache; then
  while read -r name value unit; do
    case $name in
      4way_best_*) row "cache: $name" "$value" "$unit" ">=" 300 ;;
      4way_portable_*) row "cache: $name" "$value" "$unit" ">=" 60 ;;
      16way_avx2_*) row "cache: $name" "$value" "$unit" ">=" 120 ;;
      16way_avx512_*) row "cache: $name" "$value" "$unit" ">=" 300 ;;
      powers_*) row "cache: $name" "$value" "$unit" ">=" 50 ;;
      every_*) row "cache: $name" "$value" "$unit" ">=" 18 ;;
      frame_curve_*) row "cache: $name" "$value" "$unit" ;;
      frame_*) row "cache: $name" "$value" "$unit" "<=" 0.2 ;;
      *) row "cache: $name" "$value" "$unit" ;;
    esac
  done < <(build/release/bench/bench_cache configs/profiles)
fi
