# Effect of each part of a method: setting,instead_of,ratio,classifier,seed,difference,low,high,whole. One panel for
# each ratio, one row for each setting.
# height: 110 + panels(words(words_ratio), 3) * (words(words_setting) * 20 + 40)
count   = words(words_ratio)
columns = count < 3 ? count : 3
name_width = 0
array names[words(words_setting)]
do for [n = 1:words(words_setting)] {
  setting = word(words_setting, n)
  equals  = strstrt(setting, "=")
  has     = ""
  stats data using (strcol(1) eq setting ? (has = strcol(2), 0) : 0) nooutput
  names[n] = sprintf("%s: %s → %s", setting[1:equals - 1], has, setting[equals + 1:])
  width = 18 + 7 * strlen(names[n])
  name_width = width > name_width ? width : name_width
}
edge_left = name_width; edge_right = 14; edge_top = 78; edge_bottom = 72; gap_x = 18; gap_y = 40
load scripts.'/panel_grid.gp'
own_row(down) = place(strcol(1), words_setting) + down
is(seed)      = strcol(3) eq ratio && (strcol(5) eq "mean") == (seed eq "mean")
# gnuplot omits a point whose expression has an empty field as $7, even in a branch not taken; so use a variable.
of_low = 7; of_high = 8
low(difference)  = valid(7) ? column(of_low) : difference
high(difference) = valid(8) ? column(of_high) : difference
# If the interval includes zero or is missing, the seeds do not show an effect of the part.
unsure = 0x777777
tint(mean) = valid(7) && column(of_low) * column(of_high) > 0 ? colour(1) : unsure

# One scale for all panels, with room for the mean as a number at the right.
stats data using (low($6)) name "low" nooutput
stats data using (high($6)) name "high" nooutput
least = low_min < 0 ? low_min : 0
most  = high_max > 0 ? high_max : 0
span  = most > least ? most - least : 1
set label 1 sprintf("Effect of each part of %s: accuracy with one setting moved minus that of the unchanged method", part)
set label 2 "points of accuracy by ".word(words_classifier, 1).sees_d(word(words_classifier, 1)).", paired by seed" at screen 0.5, 36.0 / height
set label 4 "blue: the 95 % interval of the mean lies on one side of zero" at screen 0.5, 14.0 / height center \
  textcolor rgb 0x555555 font font_12
set multiplot
do for [i = 1:count] {
  ratio = word(words_ratio, i)
  eval panel_at(i)
  whole = NaN
  stats data using (strcol(3) eq ratio && whole != whole ? (whole = $9, 0) : 0) nooutput
  set yrange [words(words_setting) + 0.6:0.4]
  set ytics () scale 0 font font_12 noenhanced
  do for [n = 1:words(words_setting)] { set ytics add ((is_leftmost(i) ? names[n] : "") n) }
  set xrange [least - 0.04 * span:most + 0.16 * span]
  set x2range [0:1]
  set xtics step(span) font font_11 offset 0, 0.4
  set format x is_lowest(i) ? "%g" : ""
  set title sprintf("at %s; the unchanged method has %.1f %%", colon(ratio), whole) font font_12 offset 0, 0.3
  set arrow 1 from 0, graph 0 to 0, graph 1 nohead linecolor rgb 0x333333 back
  set label 5 "← worse  " at 0, graph 1 offset 0, 0.5 right font font_10 textcolor rgb 0x555555
  set label 6 "  better →" at 0, graph 1 offset 0, 0.5 left font font_10 textcolor rgb 0x555555
  plot data using (is("each") ? $6 : NaN):(own_row(0.28)) \
         with points pointtype 7 pointsize 0.4 linecolor rgb dots(1), \
       data using (is("mean") ? $6 : NaN):(own_row(0)):(low($6)):(high($6)):(tint($6)) \
         with xerrorbars pointtype 7 pointsize 0.6 linewidth 1.6 linecolor rgb variable, \
       data using (is("mean") ? 0.985 : NaN):(own_row(0)):(sprintf("%+.1f", $6)):(tint($6)) \
         axes x2y1 with labels right font font_11 textcolor rgb variable
  eval headings_done
  unset label 4
}
unset multiplot
