# Sourced by bench.sh: what the watch of a history finds, on nights and pairs of builds that were recorded
# (tests/bench/watch_record.sh; the heads of the two files say where and when), so this machine plays no part. It takes some minutes.
if wanted watch; then
  build/release/bench/bench_watch tests/bench/watch_nights.tsv tests/bench/watch_pairs.tsv 30 >"$folder/watch"
  watched() { sed -n "s/^$1 //p" "$folder/watch"; }
  row "watch: recorded nights" "$(watched nights)" "" ">=" 50
  row "watch: recorded processes of pairs" "$(watched processes)" ""
  row "watch: noise of the median series" "$(watched sigma)" %
  row "watch: nights with a false alarm" "$(watched none_false)" % "<=" 1
  row "watch: the same, all series of one night's noise" "$(watched together_false)" % "<=" 1
  row "watch: suspects a night, of 200 series" "$(watched none_suspects)" ""
  row "watch: 5 % steps named within 2 nights" "$(watched five_fine)" % ">=" 95
  for step in five three two student laplace; do
    case $step in
      student) text="5 %, Student's noise (4)" ;;
      laplace) text="5 %, Laplace's noise" ;;
      five) text="5 %, any series" ;;
      three) text="3 %, any series" ;;
      two) text="2 %, any series" ;;
    esac
    row "watch: $text: named within 2 nights" "$(watched ${step}_named)" %
    row "watch: $text: told in the end" "$(watched ${step}_told)" %
    row "watch: $text: delay of what is told" "$(watched ${step}_delay)" nights
    row "watch: $text: nights with a false alarm" "$(watched ${step}_false)" %
    row "watch: $text: suspects a night" "$(watched ${step}_suspects)" ""
  done
fi
