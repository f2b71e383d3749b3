# Sourced by bench.sh: what the watch of a history finds, on nights and pairs of builds that were recorded
# (tests/bench/watch_record.sh; the heads of the two files say where and when), so this machine plays no part. It takes some
# minutes. The bars are judged on the nights that the rule was not chosen on, over every recorded series; the first nights, on
# which it was, stand beside them. Named in time is what is told at most two nights after the step, with the sign of the step
# and a date at most two nights off. Quiet is a series in which 5 % is beyond three times the noise and beyond what one night in
# twenty is off: its share is no bar, and says what the rest lacks (a series that costs a twentieth of the fixed pass, `none`,
# is off by more than 10 % in one night of twenty).
if wanted watch; then
  build/release/bench/bench_watch tests/bench/watch_nights.tsv tests/bench/watch_pairs.tsv 20 >"$folder/watch"
  watched() { sed -n "s/^$1 //p" "$folder/watch"; }
  row "watch: recorded nights" "$(watched nights)" "" ">=" 50
  row "watch: of these, the rule was chosen on" "$(watched chosen_nights)" ""
  row "watch: of these, held out" "$(watched held_nights)" ""
  row "watch: recorded processes of pairs" "$(watched processes)" ""
  row "watch: recorded series" "$(watched series)" ""
  row "watch: with a pair that was held out" "$(watched held_paired_series)" ""
  row "watch: noise of the median series" "$(watched held_sigma)" %
  row "watch: 5 %, named in time, all series" "$(watched five_named)" % ">=" 95
  row "watch: nights with a false alarm" "$(watched none_false)" % "<=" 1
  row "watch: the same, all of one night's noise" "$(watched together_false)" %
  row "watch: suspects a night, of 200 series" "$(watched none_suspects)" ""
  row "watch: processes that measure a suspect" "$(watched none_processes)" ""
  row "watch: nights chosen on: false alarms" "$(watched chosen_none_false)" %
  row "watch: nights chosen on: suspects a night" "$(watched chosen_none_suspects)" ""
  row "watch: quiet series of the held-out nights" "$(watched held_quiet_series)" ""
  row "watch: quiet series of nights chosen on" "$(watched chosen_quiet_series)" ""
  for step in five chosen_five three two student laplace; do
    case $step in
      five) text="5 %" ;;
      chosen_five) text="nights chosen on, 5 %" ;;
      three) text="3 %" ;;
      two) text="2 %" ;;
      student) text="5 % Student" ;;
      laplace) text="5 % Laplace" ;;
    esac
    row "watch: $text: named, all $(watched ${step}_steps)" "$(watched ${step}_named)" %
    row "watch: $text: named, quiet" "$(watched ${step}_quiet)" %
    row "watch: $text: told in the end" "$(watched ${step}_told)" %
    row "watch: $text: delay, if told" "$(watched ${step}_delay)" nights
    row "watch: $text: falsely alarmed" "$(watched ${step}_false)" %
    row "watch: $text: suspects" "$(watched ${step}_suspects)" "a night"
  done
fi
