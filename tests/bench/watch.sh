# Sourced by bench.sh: what the watch of a history finds, on nights and pairs of builds that were recorded
# (tests/bench/watch_record.sh; the heads of the two files say where and when), so this machine plays no part. It takes some
# minutes. Named in time is what is told at most two nights after the step, with a date at most two nights off. The bar of
# 95 % is of quiet series, in which 5 % is beyond three times the noise and beyond what one night in twenty is off; the share
# of all stands beside it.
if wanted watch; then
  build/release/bench/bench_watch tests/bench/watch_nights.tsv tests/bench/watch_pairs.tsv 20 >"$folder/watch"
  watched() { sed -n "s/^$1 //p" "$folder/watch"; }
  row "watch: recorded nights" "$(watched nights)" "" ">=" 50
  row "watch: recorded processes of pairs" "$(watched processes)" ""
  row "watch: recorded series" "$(watched series)" ""
  row "watch: of these, quiet ones" "$(watched fine)" ""
  row "watch: noise of the median series" "$(watched sigma)" %
  row "watch: nights with a false alarm" "$(watched none_false)" % "<=" 1
  row "watch: the same, all of one night's noise" "$(watched together_false)" % "<=" 1
  row "watch: suspects a night, of 200 series" "$(watched none_suspects)" ""
  row "watch: processes that measure a suspect" "$(watched none_processes)" ""
  row "watch: 5 % in quiet series, named in time" "$(watched five_fine)" % ">=" 95
  for step in five three two student laplace; do
    case $step in
      five) text="5 %" ;;
      three) text="3 %" ;;
      two) text="2 %" ;;
      student) text="5 % Student" ;;
      laplace) text="5 % Laplace" ;;
    esac
    row "watch: $text: named, quiet series" "$(watched ${step}_fine)" %
    row "watch: $text: named, all $(watched ${step}_steps)" "$(watched ${step}_named)" %
    row "watch: $text: told in the end" "$(watched ${step}_told)" %
    row "watch: $text: delay of what is told" "$(watched ${step}_delay)" nights
    row "watch: $text: nights falsely alarmed" "$(watched ${step}_false)" %
    row "watch: $text: suspects a night" "$(watched ${step}_suspects)" ""
  done
fi
