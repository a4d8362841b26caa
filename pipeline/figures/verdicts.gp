# Draws a table, verdicts.csv of `make verdicts`:
# dataset,judge,method,classifier,ratio,seed,record,class,faulty,grade,named,right,... One row for each judge, one column
# for each record, classes apart; the number of right verdicts on faulty records at the right.
# height: 140 + 24 * words(words_judge)
longest = 0
do for [j in words_judge] { longest = strlen(j) > longest ? strlen(j) : longest }
edge_left = 20 + 6.6 * longest; edge_right = 66; edge_top = 66; edge_bottom = 64; gap_x = 0; gap_y = 0
count = 1; columns = 1
load scripts.'/panel_grid.gp'
own_column(n) = place(strcol(7), words_record) + 1.2 * place(strcol(8), words_class)
own_row(n)    = words(words_judge) + 1 - place(strcol(2), words_judge)
number_of(record) = strstrt(record, "-") > 0 ? record[strstrt(record, "-") + 1:] : ""
last = words(words_record) + 1.2 * words(words_class)

set label 1 "One verdict on each record: ".word(words_dataset, 1)
set label 4 "dot: right; cross: wrong; at the right: right verdicts on faulty records, in the mean over the seeds" \
  at screen 0.5, 1 - 36.0 / height center font font_11 textcolor rgb 0x555555
eval panel_at(1)
set multiplot
do for [i = 1:words(words_judge)] {
  judge = word(words_judge, i)
  stats data using (strcol(2) eq judge && $9 == 1 ? $12 : NaN) name "judged" nooutput
  seeds = 0
  do for [r in words_record] {
    stats data using (seeds = strcol(2) eq judge && strcol(7) eq r && $9 == 1 ? seeds + 1 : seeds, 0) nooutput
    if (seeds > 0) { break }
  }
  set label 10 + i sprintf(judged_sum / seeds == int(judged_sum / seeds) ? "%.0f of %d" : "%.1f of %d", judged_sum / seeds, judged_records / seeds) \
    at graph 1.01, first words(words_judge) + 1 - i font font_11
  set ytics add (judge words(words_judge) + 1 - i) font font_11 noenhanced
}
set xtics ()
do for [r in words_record] {
  stats data using (strcol(7) eq r ? own_column(7) : NaN) name "at" nooutput
  set xtics add (number_of(r) at_min) rotate by 90 right font font_9 noenhanced
}
do for [i = 1:words(words_class)] {
  stats data using (strcol(8) eq word(words_class, i) ? own_column(7) : NaN) name "at" nooutput
  set label 100 + i word(words_class, i) at first (at_min + at_max) / 2, graph 1.03 center font font_11 noenhanced
}
unset key
set xrange [0.5:last + 1]
set yrange [0.4:words(words_judge) + 0.6]
set grid noxtics ytics
plot data using ($12 == 1 ? own_column(7) : NaN):(own_row(2)) with points pointtype 7 pointsize 0.75 linecolor rgb dots(1), \
     data using ($12 == 0 ? own_column(7) : NaN):(own_row(2)) with points pointtype 2 pointsize 0.75 linecolor rgb colour(2)
unset multiplot
