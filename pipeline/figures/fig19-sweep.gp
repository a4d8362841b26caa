# Fig. 19: factor,place,value,centre,ratio,seed,accuracy,low,high. One panel for each factor; the grid's own value is
# shaded.
# height: 60 + panels(words(words_factor), 2) * 270
count   = words(words_factor)
columns = count < 2 ? 1 : 2
ratios  = words(words_ratio)
edge_left = 66; edge_right = 16; edge_top = ratios > 1 ? 84 : 62; edge_bottom = 60; gap_x = 60; gap_y = 84
load scripts.'/panel_grid.gp'
off(n)  = (n - (ratios + 1) / 2.0) * 0.2
is(seed) = strcol(1) eq factor && strcol(5) eq word(words_ratio, n) && (strcol(6) eq "mean") == (seed eq "mean")
listed   = ""
do for [r in words_ratio] { listed = listed.(listed eq "" ? "" : ", ").colon(r) }
stats data using (valid(8) ? $8 : $7) name "low" nooutput
stats data using (valid(9) ? $9 : $7) name "high" nooutput
margin = 0.05 * (high_max - low_min) + 0.5
set label 1 "One setting of PIAE-DT moved, all others as in the grid (shaded), at ".listed
set label 3 "accuracy, percent"
set multiplot
do for [i = 1:count] {
  factor = word(words_factor, i)
  eval panel_at(i)
  set title factor noenhanced
  set xtics () scale 0 font font_11 noenhanced
  values = 0; centre = 0; numbers = 1  # otherwise words, which lines do not connect
  stats data using (strcol(1) eq factor ? \
    (values = $2 > values ? int($2) : values, centre = $4 == 1 ? int($2) : centre, 0) : 0) nooutput
  do for [v = 1:values] {
    text = ""
    stats data using (strcol(1) eq factor && $2 == v ? \
      (text = strcol(3), numbers = numbers && valid(3), 0) : 0) nooutput
    set xtics add (text v)
  }
  set xrange [0.5:values + 0.5]
  set yrange [low_min - margin:high_max + margin]
  set object 1 rectangle from centre - 0.4, graph 0 to centre + 0.4, graph 1 behind \
    fillcolor rgb 0xE8E8E8 fillstyle solid 1 noborder
  plot for [n = 1:ratios] data using (is("each") ? $2 + off(n) : NaN):7 \
         with points pointtype 7 pointsize 0.4 linecolor rgb dots(n), \
       for [n = 1:ratios] data using (is("mean") ? $2 + off(n) : NaN):7 \
         with lines linewidth 0.8 linecolor rgb (numbers ? colour(n) : 0xFF000000), \
       for [n = 1:ratios] data using (is("mean") ? $2 + off(n) : NaN):7:(valid(8) ? $8 : $7):(valid(9) ? $9 : $7) \
         with yerrorbars pointtype mark(n) pointsize 0.7 linewidth 1.6 linecolor rgb colour(n)
  eval headings_done
}
if (ratios > 1) {
  eval key_row
  plot for [n = 1:ratios] NaN with linespoints pointtype mark(n) pointsize 0.8 linewidth 1.2 linecolor rgb colour(n) \
       title colon(word(words_ratio, n))
}
unset multiplot
