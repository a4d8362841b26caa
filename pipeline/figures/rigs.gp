# Draws a table, rigs.csv: the joined tables of `make transfer` (transfer.gp) behind a column `part`, the group. A panel
# for each group that tests another speed, accuracy by the ratio of speeds. Coloured: the method that is subtracted from
# the others, the best other method in the mean, and the best classifier of `none` without training; grey: all others.
# Accuracies start at a multiple of 10 below all that is drawn.
# rows by: part
# height: 146 + 300 * panels(words(words_part), 2)
edge_left = 64; edge_right = 16; edge_top = 84; edge_bottom = 62; gap_x = 24; gap_y = 72

parts = ""
do for [p in words_part] {
  undefine change_*
  stats rows_of(p) using (valid(3) ? abs(log($3)) : NaN) name "change" nooutput
  if (exists("change_max") && change_max > 0.05) { parts = parts." ".p }
}
count = words(parts); columns = count < 2 ? 1 : 2
load scripts.'/panel_grid.gp'
set label 1 "Accuracy at a speed other than that of the known faults"
set label 4 "marks: mean over the seeds and its 95 % interval; numbers: mean over the data sets of a group; grey: all other methods" \
  at screen 0.5, 1 - 36.0 / height center font font_11 textcolor rgb 0x555555
set label 2 "tested speed divided by the speed at which faults are known"
set label 3 "accuracy, percent"

title_of(group) = group eq "speeds" ? "HIT-SM" : group eq "uestc-speeds" ? "UESTC, nominal speeds" : \
                  group eq "uestc-true-speeds" ? "UESTC, true speeds" : group
low = 100
do for [p in parts] {
  undefine drawn_*
  stats rows_of(p) using (strcol(10) eq "mean" && $7 == 1 && valid(3) ? \
    (valid(13) && (strcol(5) eq "against" || strcol(4) eq "none") ? $13 : $11) : NaN) \
    name "drawn" nooutput
  if (exists("drawn_min") && drawn_min < low) { low = drawn_min }
}
low = 10 * floor(low / 10.0)

recorded(m) = strcol(4) eq m && $7 == 1 && strcol(10) eq "mean"
bar(c)      = strcol(6) eq c && (strcol(5) eq "bar" || (strcol(4) eq "none" && $7 == 1)) && strcol(10) eq "mean"
spot(n)     = valid(n) ? log(column(n)) / log(2) : NaN
end(n)      = valid(n) ? column(n) : $11
array round_ratios[9] = [0.5, 0.6, 0.7, 0.85, 1, 1.2, 1.4, 1.7, 2]

set multiplot
do for [i = 1:count] {
  group = word(parts, i)
  rows  = rows_of(group)
  eval panel_at(i)
  against = ""; own_mean = -1; best = ""; best_mean = -1; bar_best = ""; bar_mean = -1; against_by = ""; best_by = ""
  there = ""
  stats rows using (strcol(2) eq "mean" && strcol(10) eq "mean" ? ( \
    strcol(5) eq "against" && $7 == 1 ? (against = strcol(4), against_by = strcol(6), own_mean = $11) : 0, \
    $7 == 1 && strcol(5) ne "ceiling" ? (there = there." ".strcol(4)) : 0, \
    strcol(5) eq "method" && $7 == 1 && strcol(4) ne "none" && $11 > best_mean ? (best = strcol(4), best_by = strcol(6), best_mean = $11) : 0, \
    strcol(4) eq "none" && (strcol(5) eq "bar" || $7 == 1) && $11 > bar_mean ? (bar_best = strcol(6), bar_mean = $11) : 0, 0) : 0) nooutput
  named(m, by, mean) = m eq "" ? "" : sprintf("%s by %s %.1f", m, by, mean)
  others = ""
  do for [m in there] { if (m ne against && m ne best && m ne "none") { others = others." ".m } }
  set xrange [-1.12:1.12]; set yrange [low:100 + 0.04 * (100 - low)]
  set xtics () scale 0.5 font font_11
  do for [n = 1:9] { set xtics add (sprintf("%.3g", round_ratios[n]) log(round_ratios[n]) / log(2)) }
  set ytics low, (low < 40 ? 20 : 10), 100 font font_11
  if (is_leftmost(i)) { set format y "%g" } else { set format y "" }
  set title title_of(group) noenhanced font font_12 offset 0, -0.4
  set key bottom left reverse Left samplen 1.5 spacing 1 font font_10 noenhanced
  plot for [m in others] rows using (recorded(m) && strcol(5) ne "ceiling" ? spot(3) : NaN):11 smooth unique \
         with lines linewidth 0.8 linecolor rgb 0xC8C8C8, \
       rows using (strcol(5) eq "ceiling" && $7 == 1 && strcol(10) eq "mean" ? spot(3) : NaN):11 smooth unique \
         with lines linewidth 1.6 dashtype 2 linecolor rgb ceiling_colour title "oracle, the ceiling", \
       rows using (bar(bar_best) ? spot(3) : NaN):11 smooth unique with lines linewidth 1.2 dashtype 3 linecolor rgb colour(3), \
       rows using (recorded(best) ? spot(3) : NaN):11 smooth unique with lines linewidth 1.2 linecolor rgb colour(1), \
       rows using (recorded(against) ? spot(3) : NaN):11 smooth unique with lines linewidth 2 linecolor rgb colour(2), \
       rows using (bar(bar_best) ? spot(3) : NaN):11:(end(13)):(end(14)) with yerrorbars pointtype mark(3) pointsize 0.7 \
         linecolor rgb colour(3) title named(bar_best eq "" ? "" : "none", bar_best, bar_mean), \
       rows using (recorded(best) ? spot(3) : NaN):11:(end(13)):(end(14)) with yerrorbars pointtype mark(1) pointsize 0.7 \
         linecolor rgb colour(1) title named(best, best_by, best_mean).(best eq "" ? "" : ", best other method"), \
       rows using (recorded(against) ? spot(3) : NaN):11:(end(13)):(end(14)) with yerrorbars pointtype mark(2) pointsize 0.9 linewidth 1.5 \
         linecolor rgb colour(2) title named(against, against_by, own_mean)
  eval headings_done
  unset label 4
}
unset multiplot
