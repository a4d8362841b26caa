# Each method minus another, paired by seed: method,ceiling,ratio,against,seed,difference,low,high,p,p_holm,least_p. One
# panel for each ratio and one for their mean; one row for each method.
# height: 106 + panels(words(words_ratio), 4) * (words(words_method) * 18 + 36)
load scripts.'/method_rows.gp'
count   = words(words_ratio)
columns = count < 4 ? count : 4
edge_left = name_width; edge_right = 14; edge_top = 62; edge_bottom = 80; gap_x = 18; gap_y = 36
load scripts.'/panel_grid.gp'
seeds    = words(words_seed) - 1
tint(ceiling) = ceiling == 1 ? ceiling_colour : colour(1)
# gnuplot omits a label that uses an empty field as a number, so p is a text.
is_small(p) = p ne "" && real(p) < 0.05
p_text(p) = p eq "" ? " " : real(p) < 0.001 ? "<0.001" : sprintf("%.2g", real(p))
is(seed)  = strcol(3) eq ratio && (strcol(5) eq "mean") == (seed eq "mean")

# One scale for all panels, with room for p at the right.
stats data using (valid(7) ? $7 : $6) name "low" nooutput
stats data using (valid(8) ? $8 : $6) name "high" nooutput
least = low_min < 0 ? low_min : 0
most  = high_max > 0 ? high_max : 0
span  = most > least ? most - least : 1
note  = "One seed alone can be tested for nothing."
if (seeds > 1) {
  stats data using (strcol(5) eq "mean" ? $11 : NaN) name "p" nooutput
  note = p_min <= 0.05 ? "" : sprintf("%d seeds cannot make p smaller than %.2g here: ".\
    "however large a difference is, it is not significant.", seeds, p_min)
}
set label 1 "Accuracy minus that of ".word(words_against, 1).", paired by seed".by_whom
set label 2 "points of accuracy" at screen 0.5, 36.0 / height
set label 4 note at screen 0.5, 14.0 / height center textcolor rgb colour(2)
set multiplot
do for [i = 1:count] {
  ratio = word(words_ratio, i)
  eval panel_at(i)
  names = is_leftmost(i)
  load scripts.'/name_rows.gp'
  set xrange [least - 0.04 * span:most + (seeds > 1 ? 0.34 : 0.04) * span]
  set x2range [0:1]
  set xtics step(span) font font_11 offset 0, 0.4
  set format x is_lowest(i) ? "%g" : ""
  set title ratio eq "mean" ? "mean of ratios" : colon(ratio) offset -3, -0.6
  set arrow 1 from 0, graph 0 to 0, graph 1 nohead linecolor rgb 0x333333 back
  if (seeds > 1) { set label 5 "p (Holm)" at graph 0.985, graph 1 offset 0, 0.5 right \
    font font_10 textcolor rgb 0x555555 }
  plot data using (is("each") ? $6 : NaN):(own_row(0.28)) \
         with points pointtype 7 pointsize 0.4 linecolor rgb dots(1), \
       data using (is("mean") ? $6 : NaN):(own_row(0)):(valid(7) ? $7 : $6):(valid(8) ? $8 : $6):(tint($2)) \
         with xerrorbars pointtype 7 pointsize 0.6 linewidth 1.6 linecolor rgb variable, \
       data using (is("mean") ? 0.985 : NaN):(own_row(0)):(p_text(strcol(10))): \
         (is_small(strcol(10)) ? 0x000000 : 0x777777) \
         axes x2y1 with labels right font font_11 textcolor rgb variable
  eval headings_done
  unset label 4
}
unset multiplot
