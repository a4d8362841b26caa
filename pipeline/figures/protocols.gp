# Random and blocked splits: method,ceiling,ratio,protocol,seed,accuracy,low,high. One panel for each ratio, one row for
# each method; `none`, which generates nothing, is in every panel.
# height: 116 + panels(words(words_ratio) - (words(words_ratio) > 1 && strstrt(words_ratio, "100to1") > 0), 4) * (words(words_method) * 18 + 36)
load scripts.'/method_rows.gp'
shown = ""
do for [ratio in words_ratio] { if (ratio ne "100to1" || words(words_ratio) == 1) { shown = shown." ".ratio } }
count   = words(shown)
columns = count < 4 ? count : 4
edge_left = name_width; edge_right = 16; edge_top = 86; edge_bottom = 56; gap_x = 18; gap_y = 36
load scripts.'/panel_grid.gp'
protocol_of(n) = word(words_protocol, n)
off(n)     = n == 1 ? -0.13 : 0.13
mark_of(n) = n == 1 ? 7 : 9
is(n)      = strcol(4) eq protocol_of(n) && (strcol(3) eq ratio || strcol(3) eq "100to1")
of_seed(n) = is(n) && strcol(5) ne "mean" ? $6 : NaN
of_mean(n) = is(n) && strcol(5) eq "mean" ? $6 : NaN
stats data using (valid(7) ? $7 : $6) name "low" nooutput
least = low_min > 5 ? low_min - 5 : 0
set label 1 "Accuracy with and without overlap of test and training windows"
set label 2 "accuracy, percent"
set multiplot
do for [i = 1:count] {
  ratio = word(shown, i)
  eval panel_at(i)
  names = is_leftmost(i)
  load scripts.'/name_rows.gp'
  set xrange [least:101]
  set xtics step(101 - least) font font_11 offset 0, 0.4
  set format x is_lowest(i) ? "%g" : ""
  set title colon(ratio)
  plot for [n = 1:2] data using (of_seed(n)):(own_row(2.6 * off(n))) \
         with points pointtype 7 pointsize 0.3 linecolor rgb dots(n), \
       for [n = 1:2] data using (of_mean(n)):(own_row(off(n))):(valid(7) ? $7 : $6):(valid(8) ? $8 : $6) \
         with xerrorbars pointtype mark_of(n) pointsize 0.6 linewidth 1.6 linecolor rgb colour(n)
  eval headings_done
}
eval key_row
plot for [n = 1:2] NaN with linespoints pointtype mark_of(n) pointsize 0.8 linewidth 1.2 linecolor rgb colour(n) \
       title (protocol_of(n) eq "random" ? "random split: windows overlap" : "blocked split: none overlap")
unset multiplot
