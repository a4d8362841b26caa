# Figs 9 and 10: method,kind,class,k_n_per_m,c_ns_per_m,k_to_n_per_m,c_to_ns_per_m,windows. Each method has a joint
# histogram with its windows, and marginals above and next to it.
# height: 40 + panels(words(words_method), 2) * (words(words_method) < 3 ? 530 : 357)
columns   = words(words_method) < 2 ? 1 : 2
rows      = panels(words(words_method), columns)
simulated = strstrt(words_kind, "true")
is(kind)  = strcol(1) eq m && strcol(2) eq kind
is_bin(kind) = is(kind) && $8 > 0
mid(a, b) = (a + b) / 2.0
shade(n)  = int(225 - 110.0 * n / bins_max) * 0x10101
k(column_number) = column(column_number) / 1e8
# Distance of ticks: gives two to five of them, so that their labels do not overlap.
power_of_ten(span) = 10 ** floor(log10(span / 2))
tic(span) = span <= 0 ? 1 : span / 2 / power_of_ten(span) < 2 ? power_of_ten(span) : \
  span / 2 / power_of_ten(span) < 5 ? 2 * power_of_ten(span) : 5 * power_of_ten(span)

# The blocks of the methods are between the heading and a margin at the bottom. A block has the joint histogram, and the
# marginals above and next to it.
block_height = (1 - 40.0 / height) / rows
low_x = 0.17; high_x = 0.76; low_y = 0.17; high_y = 0.72
place_x(part) = left + part / columns
place_y(part) = bottom + part * block_height

set multiplot
set label 1 "The digital twin space: stiffness and damping" at screen 0.02, 1 - 16.0 / height
do for [i = 1:words(words_method)] {
  m = word(words_method, i)
  left   = ((i - 1) % columns) * 1.0 / columns
  bottom = 10.0 / height + block_height * (rows - 1 - (i - 1) / columns)
  set autoscale  # otherwise stats is restricted to the ranges of the previous block
  stats data using (is("bin") ? $8 : NaN) name "bins" nooutput
  stats data using (strcol(1) eq m && strcol(2) ne "bin" ? k(4) : NaN) name "k_low" nooutput
  stats data using (is("k-bin") ? k(6) : is("true") ? k(4) : NaN) name "k_high" nooutput
  stats data using (strcol(1) eq m && strcol(2) ne "bin" ? $5 : NaN) name "c_low" nooutput
  stats data using (is("c-bin") ? $7 : is("true") ? $5 : NaN) name "c_high" nooutput
  k_margin = 0.05 * (k_high_max - k_low_min)
  c_margin = 0.05 * (c_high_max - c_low_min)

  set lmargin at screen place_x(low_x)
  set rmargin at screen place_x(high_x)
  set bmargin at screen place_y(low_y)
  set tmargin at screen place_y(high_y)
  set xrange [k_low_min - k_margin : k_high_max + k_margin]
  set yrange [c_low_min - c_margin : c_high_max + c_margin]
  set xtics tic(k_high_max - k_low_min)
  set xlabel "k, 10^8 N/m"
  set ylabel "c, N s/m" offset 1,0
  # Reduced width, otherwise three entries would take two lines: gnuplot counts the width of the first block.
  if (i == 1) { set key at screen 0.98, 1 - 6.0 / height right top horizontal width -4 } else { unset key }
  if (simulated) {
    plot data using (is_bin("bin") ? mid(k(4), k(6)) : NaN):(mid($5, $7)):(k(4)):(k(6)):5:7:(shade($8)) \
           with boxxyerror linecolor rgb variable, \
         data using (is("generated") ? k(4) : NaN):5 with points pointtype 7 pointsize 0.2 \
           linecolor rgb colour(1) title "generated", \
         data using (is("known") ? k(4) : NaN):5 with points pointtype 6 pointsize 0.8 linewidth 1.6 \
           linecolor rgb colour(2) title "known", \
         data using (is("true") ? k(4) : NaN):5 with points pointtype 2 pointsize 0.7 linewidth 1.4 \
           linecolor rgb colour(3) title "true"
  } else {
    plot data using (is_bin("bin") ? mid(k(4), k(6)) : NaN):(mid($5, $7)):(k(4)):(k(6)):5:7:(shade($8)) \
           with boxxyerror linecolor rgb variable, \
         data using (is("generated") ? k(4) : NaN):5 with points pointtype 7 pointsize 0.2 \
           linecolor rgb colour(1) title "generated", \
         data using (is("known") ? k(4) : NaN):5 with points pointtype 6 pointsize 0.8 linewidth 1.6 \
           linecolor rgb colour(2) title "known"
  }
  unset label 1

  unset key
  unset xlabel
  unset ylabel
  unset tics
  unset border
  set bmargin at screen place_y(high_y + 0.01)
  set tmargin at screen place_y(high_y + 0.15)
  set yrange [0:*]
  set title m offset 0,-0.6 # as style.gp has it
  plot data using (is_bin("k-bin") ? mid(k(4), k(6)) : NaN):(mid(0, $8)):(k(4)):(k(6)):(0):8 \
         with boxxyerror linecolor rgb 0x9A9A9A
  unset title
  set lmargin at screen place_x(high_x + 0.01)
  set rmargin at screen place_x(high_x + 0.19)
  set bmargin at screen place_y(low_y)
  set tmargin at screen place_y(high_y)
  set xrange [0:*]
  set yrange [c_low_min - c_margin : c_high_max + c_margin]
  plot data using (is_bin("c-bin") ? mid(0, $8) : NaN):(mid($5, $7)):(0):8:5:7 \
         with boxxyerror linecolor rgb 0x9A9A9A
  set border 3
  set xtics nomirror out scale 0.5 textcolor rgb 0x333333 # as style.gp has them
  set ytics nomirror out scale 0.5 textcolor rgb 0x333333
}
unset multiplot
