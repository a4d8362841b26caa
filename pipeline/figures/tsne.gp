# Maps of test windows: method,class,x,y,trustworthiness,kl. One panel for each method, one colour and mark for each
# class; the axes of a map have neither unit nor meaning. Loaded by scripts that have set `heading`.
methods = words(words_method)
columns = methods < 5 ? panels(methods, 2) : 5
rows    = panels(methods, columns)
# The row with a method's two numbers lacks class and place, so it is not drawn.
class_number(name) = name eq "" ? 1 : place(name, words_class)
# The ninth colour is a darker version of the first.
tint(i)   = i > 8 ? (colour(i) >> 1) & 0x7F7F7F : colour(i)
left(n)   = 0.01 + 0.98 * ((n - 1) % columns) / columns
# Heading and key take 113 pixels, the two lines above each panel 46.
maps      = (height - 113.0) / height
bottom(n) = 60.0 / height + maps * (1 - ((n - 1) / columns + 1.0) / rows)
# Selects the rows of one method and the header, so that gnuplot does not read all rows each time.
rows_of(method) = sprintf("< awk -F, 'NR == 1 || $1 == \"%s\"' '%s'", method, data)
# Marks are transparent. Otherwise the last class would hide the others where classes mix.
see_through = 0x60 << 24

set multiplot
set label 1 heading at screen 0.02, 1 - 23.0 / height
set border 15 linecolor rgb 0xCCCCCC
unset tics
unset grid
unset key
set size square
do for [n = 1:methods] {
  method = word(words_method, n)
  one    = rows_of(method)
  stats one using 5 name "trust" nooutput
  stats one using 6 name "kl" nooutput
  stats one using 3 name "x" nooutput
  stats one using 4 name "y" nooutput
  half = 0.52 * (x_max - x_min > y_max - y_min ? x_max - x_min : y_max - y_min)
  set xrange [(x_min + x_max) / 2 - half:(x_min + x_max) / 2 + half]
  set yrange [(y_min + y_max) / 2 - half:(y_min + y_max) / 2 + half]
  set lmargin at screen left(n) + 0.005
  set rmargin at screen left(n) + 0.98 / columns - 0.005
  set bmargin at screen bottom(n) + 0.005
  set tmargin at screen bottom(n) + maps / rows - 46.0 / height
  set title sprintf("%s\n{/*0.75 trustworthiness %.2f, KL %.2f}", method, trust_max, kl_max) offset 0, -0.8
  plot one using 3:4:(mark(class_number(strcol(2)))):(see_through + tint(class_number(strcol(2)))) \
         with points pointtype variable pointsize 0.35 linecolor rgb variable
  unset label 1
  set autoscale
}
# Key of all panels, below them.
unset title
unset border
set size nosquare
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0.005
set tmargin at screen 46.0 / height
set xrange [0:1]
set yrange [0:1]
set key at screen 0.5, 23.0 / height center center horizontal samplen 1
plot for [i = 1:words(words_class)] NaN with points pointtype mark(i) pointsize 0.8 linecolor rgb tint(i) \
       title word(words_class, i)
unset multiplot
