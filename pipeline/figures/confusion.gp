# Confusion matrices: method,ceiling,ratio,truth,predicted,windows,percent. One panel for each method; blue is correct,
# orange wrong, and cells show shares from 5 % on.
# height: 146 + panels(words(words_method), 4) * 236
load scripts.'/method_rows.gp'
count   = words(words_method)
columns = 4
longest = 6
do for [class in words_predicted] { longest = strlen(class) > longest ? strlen(class) : longest }
edge_left = 40 + 6 * longest; edge_right = 12; edge_top = 62; edge_bottom = 84; gap_x = 12; gap_y = 36
load scripts.'/panel_grid.gp'
classes     = words(words_predicted)
x_of(class) = place(class, words_predicted)
# Mixes a colour with white; `shift` selects one of its three components.
part(c, shift, t)  = int(255 - t * (255 - ((c >> shift) & 255))) << shift
mixed(c, t)        = part(c, 16, t) + part(c, 8, t) + part(c, 0, t)
fill(percent)      = mixed(strcol(4) eq strcol(5) ? colour(1) : colour(2), percent / 100.0)
is_shown(least)    = strcol(1) eq method && $7 >= least
number_font        = classes > 8 ? font_9 : classes > 5 ? font_10 : font_12

set label 1 "Confusion of the classes at ".colon(word(words_ratio, words(words_ratio))). \
            ", percent of each true class over all seeds; next to the names: the accuracy"
set label 2 "predicted class"
set label 3 "true class"
set border 15 linecolor rgb 0xAAAAAA
unset grid
unset key
set multiplot
do for [i = 1:count] {
  method = word(words_method, i)
  eval panel_at(i)
  right = 0.0; all = 0.0
  stats data using (strcol(1) eq method ? \
    (all = all + $6, right = right + (strcol(4) eq strcol(5) ? $6 : 0), 0) : 0) nooutput
  set xrange [0.5:classes + 0.5]
  set yrange [classes + 0.5:0.5]
  set title sprintf("%s  %.1f %%", named(method), 100 * right / all) font font_12 noenhanced
  set xtics () scale 0 rotate by 90 right font font_10 noenhanced
  set ytics () scale 0 font font_10 noenhanced
  do for [n = 1:classes] {
    set xtics add ((is_lowest(i) ? word(words_predicted, n) : "") n)
    set ytics add ((is_leftmost(i) ? word(words_predicted, n) : "") n)
  }
  plot data using (is_shown(0.5) ? x_of(strcol(5)) : NaN):(x_of(strcol(4))):(0.5):(0.5):(fill($7)) \
         with boxxyerror fillstyle solid 1 noborder linecolor rgb variable, \
       data using (is_shown(5) ? x_of(strcol(5)) : NaN):(x_of(strcol(4))):(sprintf("%.0f", $7)): \
         ($7 > 55 ? 0xFFFFFF : 0x000000) \
         with labels center font number_font textcolor rgb variable
  eval headings_done
}
unset multiplot
