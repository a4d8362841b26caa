# Accuracy by the cost of the generator: method,group,front,ratio,generator_s,accuracy,low,high,gain,s_per_point. Methods
# are numbered in the picture, from the cheapest; the list at the right gives their names, times and times for a point.
# height: 110 + 18 * (words(words_method) < 24 ? 24 : words(words_method))
list_left = 560
count = 1; columns = 1
edge_left = 60; edge_right = 960 - list_left + 30; edge_top = 40; edge_bottom = 52; gap_x = 0; gap_y = 0
load scripts.'/panel_grid.gp'
stats data using (log10($5)) name "cost" nooutput
stats data using (valid(7) ? $7 : $6) name "low" nooutput
tint(group) = group eq "ours" ? colour(2) : group eq "paper" ? colour(1) : 0x777777

set label 1 "Accuracy by the processor time of a generator, at ".colon(word(words_ratio, words(words_ratio))).by_whom
set label 2 "processor time of training and generating for one seed, seconds" at screen 0.31, 14.0 / height center
set label 3 "accuracy, percent"
eval panel_at(1)
line_y(n) = 1 - (62.0 + 18 * n) / height
set label 4 "method" at screen (list_left + 24.0) / 960, line_y(0) font font_12 textcolor rgb 0x555555
set label 5 "seconds" at screen 810.0 / 960, line_y(0) right font font_12 textcolor rgb 0x555555
set label 6 "seconds a point" at screen 940.0 / 960, line_y(0) right font font_12 textcolor rgb 0x555555
shown(x) = x >= 10 ? sprintf("%.0f", x) : sprintf("%.2g", x)
# $5 / $9 is column 10. Where that is empty, gnuplot reads the previous row's.
do for [n = 1:words(words_method)] {
  name = word(words_method, n)
  stats data using (strcol(1) eq name ? \
    (tone = tint(strcol(2)), seconds = $5, each = $9 > 0 ? $5 / $9 : -1, 0) : 0) nooutput
  set label 10 * n sprintf("%d", n) at screen (list_left + 16.0) / 960, line_y(n) right font font_12 textcolor rgb tone
  set label 10 * n + 1 name at screen (list_left + 24.0) / 960, line_y(n) font font_12 textcolor rgb tone noenhanced
  set label 10 * n + 2 shown(seconds) at screen 810.0 / 960, line_y(n) right font font_12
  set label 10 * n + 3 (each < 0 ? "no gain" : shown(each)) at screen 940.0 / 960, line_y(n) right font font_12
}
set xrange [10 ** (floor(2 * cost_min) / 2.0):10 ** (ceil(2 * cost_max + 0.2) / 2.0)]
set yrange [5 * floor(low_min / 5.0):101]
set format x "%g"
set logscale x
plot data using (strcol(3) eq "1" ? $5 : NaN):6 smooth unique with lines linewidth 1 dashtype 2 linecolor rgb 0x999999, \
     data using 5:6:(valid(7) ? $7 : $6):(valid(8) ? $8 : $6):(tint(strcol(2))) with yerrorbars pointtype 7 pointsize 1.5 linecolor rgb variable, \
     data using 5:6:(sprintf("%d", $0 + 1)) with labels font font_9 textcolor rgb 0xFFFFFF
