# Inferred (k, c) against true ones:
# method,parameter,truth_low,truth_high,windows,inferred_p10,inferred_p50,inferred_p90,r2. One column for each method,
# one row for each parameter.
# height: 700
columns = words(words_method)
count   = 2 * columns
edge_left = 74; edge_right = 20; edge_top = 84; edge_bottom = 56; gap_x = columns > 3 ? 40 : 56; gap_y = 104
load scripts.'/panel_grid.gp'
is_own(any) = strcol(1) eq method && strcol(2) eq parameter
set label 1 "Stiffness and damping of windows that the models have not seen, inferred against true"
set multiplot
do for [i = 1:count] {
  method    = word(words_method, (i - 1) % columns + 1)
  parameter = i <= columns ? "stiffness" : "damping"
  unit      = i <= columns ? 1e6 : 1.0
  unit_name = i <= columns ? "MN/m" : "N·s/m"
  eval panel_at(i)
  r2 = NaN
  stats data using (is_own(0) ? (r2 = $9, $3 / unit) : NaN) name "low" nooutput
  stats data using (is_own(0) ? $4 / unit : NaN) name "high" nooutput
  set title sprintf("%s\nR² = %.2f", method, r2) noenhanced font font_12 offset 0, -0.4
  set label 4 "true ".parameter.", ".unit_name at graph 0.5, graph 0 offset 0, -2.2 center font font_11
  if (is_leftmost(i)) {
    set label 5 "inferred ".parameter.", ".unit_name at screen 0.018, top_of(i) - 0.5 * panel_height / height \
      rotate by 90 center font font_11
  } else { unset label 5 }
  set xrange [low_min:high_max]
  set xtics step(high_max - low_min) * (columns > 3 ? 2 : 1) font font_11 offset 0, 0.4
  set ytics font font_11
  plot "+" using 1:1 with lines dashtype 2 linecolor rgb 0x777777, \
       data using (is_own(0) ? ($3 + $4) / 2 / unit : NaN):($7 / unit):($3 / unit):($4 / unit):($6 / unit):($8 / unit) \
         with xyerrorbars pointtype 7 pointsize 0.5 linewidth 1.1 linecolor rgb colour(1)
  eval headings_done
}
unset multiplot
