# Reliability diagrams: method,ceiling,ratio,kind,score_from,score_to,windows,share,mean_score,accuracy,gap. One panel
# for each method: accuracy by score, the share of windows in each bin as grey bars, and the calibration error.
# height: 130 + panels(words(words_method), 4) * 216
load scripts.'/method_rows.gp'
count   = words(words_method)
columns = 4
edge_left = 62; edge_right = 16; edge_top = 84; edge_bottom = 56; gap_x = 16; gap_y = 34
load scripts.'/panel_grid.gp'
is_bin(least) = strcol(1) eq method && strcol(4) eq "bin" && $7 >= least
set label 1 "How often the classifier is correct, by its own score".by_whom.", at ".colon(word(words_ratio, words(words_ratio)))
set label 2 "score of the predicted class, percent"
set label 3 "accuracy and share of the windows, percent"
set multiplot
do for [i = 1:count] {
  method = word(words_method, i)
  eval panel_at(i)
  error = NaN
  stats data using (strcol(1) eq method && strcol(4) eq "all" ? (error = $11, 0) : 0) nooutput
  set xrange [0:100]
  set yrange [0:100]
  set xtics 0, 20, 80 font font_11 offset 0, 0.4
  set ytics 0, 20, 100 font font_11
  set format x is_lowest(i) ? "%g" : ""
  set format y is_leftmost(i) ? "%g" : ""
  set title named(method) font font_12 noenhanced
  set label 4 sprintf("ECE %.1f %%", error) at graph 0.05, graph 0.92 font font_11 front
  set arrow 1 from 0, 0 to 100, 100 nohead linecolor rgb 0x777777 dashtype 2 front
  plot data using (is_bin(0) ? ($5 + $6) / 2 : NaN):8:($6 - $5) with boxes fillstyle solid 1 noborder \
         linecolor rgb 0xCCCCCC, \
       data using (is_bin(1) ? $9 : NaN):10 with linespoints pointtype 7 pointsize 0.5 linewidth 1.2 \
         linecolor rgb colour(1)
  eval headings_done
}
eval key_row
plot NaN with linespoints pointtype 7 pointsize 0.6 linewidth 1.2 linecolor rgb colour(1) title "accuracy", \
     NaN with boxes fillstyle solid 1 noborder linecolor rgb 0xCCCCCC title "share of windows", \
     NaN with lines dashtype 2 linecolor rgb 0x777777 title "accuracy = score"
unset multiplot
