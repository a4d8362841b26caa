# Demsar's critical-difference diagram, one for each ratio: ratio,kind,method,place,rank,rank_to,seeds,friedman_p,
# critical_difference.
# height: 40 + panels(words(words_ratio), 1 + (words(words_ratio) > 2)) * (150 + 17 * panels(words(words_method), 2))
count   = words(words_ratio)
columns = count > 2 ? 2 : 1
edge_left = 8; edge_right = 8; edge_top = 102; edge_bottom = 10; gap_x = 8; gap_y = 78
load scripts.'/panel_grid.gp'
methods   = words(words_method)
left_half = (methods + 1) / 2
is(kind)  = strcol(1) eq ratio && strcol(2) eq kind

# In pixels below the axis: the bars in one block, the names below it, the best of each side at the top.
bars = 0
stats data using (bars = strcol(2) eq "alike" && $4 > bars ? int($4) : bars, 0) nooutput
bar_y(n)  = 8 + (bars > 6 ? 48.0 / bars : 8) * (n - 1)
name_y(n) = bar_y(bars) + 18 + 17 * (n <= left_half ? n - 1 : methods - n + 0.5)  # all at different heights

# In pixels: room for the longest name at each side of the axis.
longest_left = 0; longest_right = 0
stats data using (letters = strlen(strcol(3)), is_left = $4 <= left_half, \
  longest_left  = is_left && letters > longest_left ? letters : longest_left, \
  longest_right = !is_left && letters > longest_right ? letters : longest_right, 0) nooutput
room(letters) = 22 + 6.8 * letters
rank_width    = (panel_width - room(longest_left) - room(longest_right)) / (methods - 1)
ranks(pixels) = pixels / rank_width
side(n)       = n <= left_half ? 1 - ranks(11) : methods + ranks(11)
each          = rank_width < (methods < 10 ? 9 : 16) ? 2 : 1  # numbers every second rank, or each one

set label 1 "Average rank among the methods of the same seed; 1 is the best".by_whom
unset border
unset grid
unset tics
unset key
set multiplot
do for [i = 1:count] {
  ratio = word(words_ratio, i)
  eval panel_at(i)
  p = NaN; critical = NaN; seeds = 0
  stats data using (is("method") ? \
    (p = valid(8) ? $8 : NaN, critical = valid(9) ? $9 : NaN, seeds = int($7), 0) : 0) nooutput
  test = seeds == 1 ? "one seed, no test" : \
         sprintf("Friedman p %s, %d seeds", p < 0.001 ? "< 0.001" : sprintf("= %.2g", p), seeds)
  set xrange [1 - ranks(room(longest_left)):methods + ranks(room(longest_right))]
  set yrange [panel_height:0]
  set label 2 colon(ratio).": ".test at graph 0.5, first -56 center
  unset arrow
  unset label 3
  set arrow from 1, 0 to methods, 0 nohead linecolor rgb 0x333333 front
  do for [n = 1:methods] {
    set arrow from n, 0 to n, -4 nohead linecolor rgb 0x333333 front
  }
  do for [n = 1:methods:each] {
    set label 100 + n sprintf("%d", n) at n, -11 center font font_11 textcolor rgb 0x333333
  }
  if (seeds > 1 && critical <= methods - 1) {
    set arrow from 1, -30 to 1 + critical, -30 heads size screen 0.004, 90 linewidth 1.4 linecolor rgb 0x333333 front
    set label 3 sprintf("CD %.2f", critical) at 1 + critical, -30 offset 0.8, 0 font font_11
  }
  if (seeds > 1 && critical > methods - 1) {
    set label 3 sprintf("CD %.2f: larger than any difference", critical) at 1, -30 font font_11
  }
  plot data using (is("method") ? $5 : NaN):(0):(0):(name_y($4)) \
         with vectors nohead linewidth 0.8 linecolor rgb 0x777777, \
       data using (is("method") ? $5 : NaN):(name_y($4)):(side($4) - $5):(0) \
         with vectors nohead linewidth 0.8 linecolor rgb 0x777777, \
       data using (strcol(1) eq ratio ? $5 : NaN):(bar_y($4)):(is("alike") ? $6 - $5 : 0):(0) \
         with vectors nohead linewidth 4 linecolor rgb colour(1), \
       data using (is("method") && $4 <= left_half ? side($4) : NaN):(name_y($4)):3 \
         with labels right offset -0.5, 0 font font_12 noenhanced, \
       data using (is("method") && $4 > left_half ? side($4) : NaN):(name_y($4)):3 \
         with labels left offset 0.5, 0 font font_12 noenhanced
  unset label 1
}
unset multiplot
