# Missed faults and false alarms: method,ceiling,ratio,kind,class,seed,percent. One panel for all faults, for each fault
# class, and for the healthy one; one row for each method.
# height: 76 + panels(words(words_class) + 2, 4) * (words(words_method) * 17 + 36)
load scripts.'/method_rows.gp'
count   = words(words_class) + 2
columns = 4
edge_left = name_width; edge_right = 14; edge_top = 62; edge_bottom = 50; gap_x = 18; gap_y = 36
load scripts.'/panel_grid.gp'
kind_of(i)  = i == 1 ? "all-faults" : i == count ? "healthy" : "fault"
class_of(i) = i == 1 || i == count ? "" : word(words_class, i - 1)
title_of(i) = i == 1 ? "missed, all faults" : i == count ? "false alarms" : "missed, ".class_of(i)
tint_of(i)  = i == count ? 2 : 1
mark_of(i)  = i == count ? 9 : 7
is(seed)    = strcol(4) eq kind_of(i) && strcol(5) eq class_of(i) && (strcol(6) eq "mean") == (seed eq "mean")
stats data using 7 nooutput
most = STATS_max > 0 ? 1.05 * STATS_max : 1
set label 1 "Faults classified as healthy, and healthy windows classified as a fault, at ". \
            colon(word(words_ratio, words(words_ratio)))
set label 2 "percent of the test windows of a class"
set multiplot
do for [i = 1:count] {
  eval panel_at(i)
  names = is_leftmost(i)
  load scripts.'/name_rows.gp'
  set xrange [-0.02 * most:most]
  set xtics step(most) font font_11 offset 0, 0.4
  set format x is_lowest(i) ? "%g" : ""
  set title title_of(i) noenhanced
  plot data using (is("each") ? $7 : NaN):(own_row(0)) \
         with points pointtype 7 pointsize 0.4 linecolor rgb dots(tint_of(i)), \
       data using (is("mean") ? $7 : NaN):(own_row(0)):($2 == 1 ? ceiling_colour : colour(tint_of(i))) \
         with points pointtype mark_of(i) pointsize 0.7 linecolor rgb variable
  eval headings_done
}
unset multiplot
