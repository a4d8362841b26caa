# Draws a table, readings.csv of `make readings`: dataset,reading,quantity,ratio,seeds,mean,std. One row for each interpretation,
# one panel for each quantity.
# height: 112 + words(words_reading) * 17
all_panels = ""
do for [ratio in words_ratio] { all_panels = all_panels." accuracy@".ratio }
do for [quantity in "mmd rmse stiffness_r2 damping_r2"] {
  if (place(quantity, words_quantity)) { all_panels = all_panels." ".quantity."@" }
}
names(panel) = panel[1:strstrt(panel, "@") - 1]
ratio_of(panel) = panel[strstrt(panel, "@") + 1:]
heading(panel) = names(panel) eq "accuracy" ? "accuracy ".colon(ratio_of(panel)) : \
  names(panel) eq "mmd" ? "MMD²" : names(panel) eq "rmse" ? "RMSE" : \
  names(panel) eq "stiffness_r2" ? "R² of stiffness" : "R² of damping"
is_r2(panel) = strstrt(panel, "_r2") > 0
count   = words(all_panels)
columns = count
name_width = 0
readings   = ""
do for [reading in words_reading] {
  if (reading ne "published") {
    readings = readings." ".reading
    width = 16 + 5.7 * strlen(reading)
    name_width = width > name_width ? width : name_width
  }
}
edge_left = name_width; edge_right = 14; edge_top = 62; edge_bottom = 50; gap_x = 16; gap_y = 0
load scripts.'/panel_grid.gp'
own_row(down) = place(strcol(2), readings) + down
is(panel)     = strcol(3) eq names(panel) && strcol(4) eq ratio_of(panel) && strcol(2) ne "published"
# A bad R² can be any negative number. Values below the least shown one are triangles at the edge.
least_r2 = -25
# gnuplot omits a point whose expression has an empty field as $7, even in a branch not taken; so use a variable.
of_spread = 7
shown(panel, value) = is_r2(panel) && value < least_r2 ? least_r2 : value
far(panel, value)   = is_r2(panel) && value < least_r2
set label 1 sprintf("Readings of the paper on %s: mean and standard deviation over the seeds", word(words_dataset, 1))
set label 2 "accuracy in percent; dotted: base".(place("stiffness_r2", words_quantity) ? sprintf("; a triangle: below %d", least_r2) : "") font font_11
set multiplot
do for [i = 1:count] {
  panel = word(all_panels, i)
  eval panel_at(i)
  published = NaN; base = NaN
  stats data using (strcol(3) eq names(panel) && strcol(4) eq ratio_of(panel) ? \
    (published = strcol(2) eq "published" ? $6 : published, base = strcol(2) eq "base" ? $6 : base, 0) : 0) nooutput
  stats data using (is(panel) ? shown(panel, $6 - (valid(7) ? column(of_spread) : 0)) : NaN) name "low" nooutput
  stats data using (is(panel) ? $6 + (valid(7) ? column(of_spread) : 0) : NaN) name "high" nooutput
  low  = is_r2(panel) ? least_r2 - 0.5 : names(panel) eq "accuracy" ? low_min - 2 : 0
  high = is_r2(panel) ? 1 : names(panel) eq "accuracy" ? (published > high_max ? published : high_max) + 2 : 1.05 * high_max
  set xrange [low:high]
  set yrange [words(readings) + 0.6:0.4]
  set ytics () scale 0 font font_10 noenhanced
  do for [n = 1:words(readings)] { set ytics add ((is_leftmost(i) ? word(readings, n) : "") n) }
  set xtics step(high - low) font font_10 offset 0, 0.4
  if (high - low <= 2) { set xtics high - low > 0.8 ? 0.5 : 0.2 font font_10 offset 0, 0.4 }
  set title heading(panel) font font_11 offset 0, -0.6
  unset arrow
  if (published == published) {
    set arrow 1 from published, graph 0 to published, graph 1 nohead dashtype 2 linewidth 1.4 linecolor rgb colour(2)
    set label 6 "paper" at published, graph 1 offset -0.3, -0.6 right font font_10 textcolor rgb colour(2)
  } else { unset label 6 }
  if (is_r2(panel)) { set arrow 2 from 0, graph 0 to 0, graph 1 nohead linecolor rgb 0x777777 }
  set arrow 3 from shown(panel, base), graph 0 to shown(panel, base), graph 1 nohead linewidth 0.8 dashtype 3 linecolor rgb 0x777777
  plot data using (is(panel) && !far(panel, $6) ? $6 : NaN):(own_row(0)):(valid(7) ? column(of_spread) : 0) \
         with xerrorbars pointtype 7 pointsize 0.5 linewidth 1.4 linecolor rgb colour(1), \
       data using (is(panel) && far(panel, $6) ? least_r2 : NaN):(own_row(0)) \
         with points pointtype 9 pointsize 0.6 linecolor rgb colour(2)
  eval headings_done
}
unset multiplot
