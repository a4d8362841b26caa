# One fault class in another condition: panel,what,x,y, and one column for each set of windows: those known in one or
# several conditions, those that methods made of them, and the real ones of the tested condition. Each of the three
# panels is one axis with a row for each set; the known ones are apart at the top. A value is drawn at the middle of its
# row, plus its share of the row's height. The words of `what` are the names of the rows, low, high, and the name of the
# line.
# height: 190 + 112 * (words(words_what) - 3)
part = data[strstrt(data, "@") + 1:strlen(data) - 4]
stats data using 0 nooutput
rows  = STATS_columns - 4
names = ""
do for [i = 1:rows] {
  stats data using (name = columnhead(4 + i), 0) every ::::0 nooutput
  names = names." ".name
}
is(panel) = strcol(1) eq panel
of(i)     = column(4 + i)
is_known(i) = word(names, i)[1:5] eq "known"
knowns = sum [i = 1:rows] is_known(i)
gap       = 0.42
above     = 0.2
middle(i) = rows - i + 0.5 + (i <= knowns ? gap : 0)
within_row(part) = part < -0.5 ? -0.5 : part > 0.5 ? 0.5 : part

array conditions[rows]
do for [i = 1:rows] {
  stats data using (is("row") && strcol(2) eq word(names, i) ? (conditions[i] = strcol(4), 0) : NaN) nooutput
}
stats data using (is("line") ? (line = strcol(2), 0) : NaN) nooutput
line = line eq "2BSF" ? "2·BSF" : line

# Real and known windows set the scales of a panel; larger values are cut at the edge of their row.
larger(a, b)  = a > b ? a : b
smaller(a, b) = a < b ? a : b
next_five(x)  = 5 * ceil(x / 5 + 0.2)
range_of(panel) = sprintf("highest = -1e9; lowest = 1e9; do for [i = 1:rows] { if (i <= knowns || i == rows) { ". \
  "stats data using (is('%s') ? of(i) : NaN) name 'set' nooutput; ". \
  "highest = larger(highest, set_max); lowest = smaller(lowest, set_min) } }", panel)
eval range_of("waveform")
loudest = ceil(larger(highest, -lowest))
eval range_of("spectrum")
top_1    = next_five(highest)
height_1 = 50
eval range_of("envelope")
top_2    = next_five(highest)
height_2 = smaller(40, next_five(top_2 - lowest))
# Leave room for a bar above a waveform.
wave(i) = middle(i) - 0.05 + 0.9 * within_row(of(i) / loudest / 2)
level(i, top, height) = middle(i) + within_row(0.5 - (top - of(i)) / height)
stats data using (is("waveform") ? $3 : NaN) name "time" nooutput
stats data using (is("spectrum") ? $3 : NaN) name "frequency" nooutput
stats data using (is("envelope") ? $3 : NaN) name "last_line" nooutput
stats data using (is("line") && $4 == 1 ? of(1) : NaN) name "first_line" nooutput

tint(i)   = i <= knowns ? colour(2) : i == rows ? 0x222222 : colour(1)
behind    = 0xB0B0B0
line_tint = colour(3)
bottom    = 64.0 / height
top       = 1 - 72.0 / height
left(n)   = 0 + word("0.125 0.425 0.715", n)
right(n)  = 0 + word("0.405 0.695 0.985", n)
panel_at(n) = sprintf("set lmargin at screen %f; set rmargin at screen %f", left(n), right(n))
small     = sprintf(",%g", format eq "pdf" ? 7.6 : 11)
grey      = 0x555555
panel_middle(n) = (left(n) + right(n)) / 2
heading(n, first, second) = sprintf("set label 2 \"%s\" at screen %g, %g center; ". \
  "set label 3 \"%s\" at screen %g, %g center textcolor rgb grey font small", \
  first, panel_middle(n), 1 - 44.0 / height, second, panel_middle(n), 1 - 62.0 / height)

set multiplot
set border 0
unset grid
unset ytics
set bmargin at screen bottom
set tmargin at screen top
set yrange [0:rows + gap + above]
set style arrow 1 nohead linecolor rgb 0xDDDDDD linewidth 0.6 back
do for [i = 1:rows] {
  set arrow from graph 0, first middle(i) - 0.5 to graph 1, first middle(i) - 0.5 arrowstyle 1
  set arrow from graph 0, first middle(i) + 0.5 to graph 1, first middle(i) + 0.5 arrowstyle 1
}
known_conditions = conditions[1]
do for [i = 2:knowns] { known_conditions = known_conditions." and ".conditions[i] }
set label 1 sprintf("%s: known at %s, tested at %s", part, known_conditions, conditions[rows]) \
  at screen 0.02, 1 - 18.0 / height noenhanced
between = (rows > knowns + 1 ? "made from the known windows above; " : "")."at the bottom, and in grey, real ones"
set label 10 between at graph 0, first rows - knowns + gap / 2 noenhanced textcolor rgb grey font small
row_name(i)      = is_known(i) ? "known" : i == rows ? "real" : word(names, i)
row_condition(i) = conditions[i] eq "" ? "as known" : conditions[i]
do for [i = 1:rows] {
  set label 100 + i at graph -0.03, first middle(i) + 0.1 right noenhanced textcolor rgb tint(i)
  set label 100 + i row_name(i)
  set label 200 + i at graph -0.03, first middle(i) - 0.14 right noenhanced textcolor rgb grey font small
  set label 200 + i row_condition(i)
}

n = 1
eval heading(n, "a window", sprintf("a row is ±%g RMS; bar: one period of the defect", loudest))
eval panel_at(n)
set xrange [0:time_max]
set xlabel "time, ms"
period(i) = is("line") && $4 == 1 ? 1e3 / of(i) : NaN
bar(i)    = middle(i) + 0.45
plot for [i = 1:rows] data using (is("waveform") ? $3 : NaN):(wave(i)) \
       with lines linewidth 0.5 linecolor rgb tint(i), \
     for [i = 1:rows] data using (0.02 * time_max):(bar(i)):(period(i)):(0) \
       with vectors heads size screen 0.004,90 linewidth 1.3 linecolor rgb line_tint
unset label

n = 2
eval heading(n, "amplitude spectrum", sprintf("a row is %g to %g dB; grey: real", top_1 - height_1, top_1))
eval panel_at(n)
set xrange [0:frequency_max / 1e3]
set xlabel "frequency, kHz"
kilohertz(panel) = is(panel) ? $3 / 1e3 : NaN
behind_at(i, top, height) = middle(i) + within_row(0.5 - (top - of(rows)) / height)
plot for [i = 1:rows - 1] data using (kilohertz("spectrum")):(behind_at(i, top_1, height_1)) \
       with lines linewidth 0.8 linecolor rgb behind, \
     for [i = 1:rows] data using (kilohertz("spectrum")):(level(i, top_1, height_1)) \
       with lines linewidth 0.8 linecolor rgb tint(i)
unset label

n = 3
eval heading(n, "envelope spectrum", sprintf("a row is %g to %g dB; lines: %s and harmonics", \
                                          top_2 - height_2, top_2, line))
eval panel_at(n)
set xrange [0:last_line_max]
set xlabel "frequency, Hz"
line_at(i) = is("line") ? of(i) : NaN
# Number as many lines as fit.
distance    = first_line_max / last_line_max * (right(n) - left(n)) * 960  # in pixels
numbered(k) = (int(k) - 1) % ceil(26 / distance) == 0
plot for [i = 1:rows] data using (line_at(i)):(middle(i) - 0.5):(0):(1) \
       with vectors nohead linewidth 0.8 linecolor rgb line_tint, \
     data using (line_at(knowns)):(middle(knowns) - 0.5):(of(knowns + 1) - of(knowns)):(-gap) \
       with vectors nohead dashtype 3 linewidth 0.9 linecolor rgb line_tint, \
     for [i = 1:rows - 1] data using (is("envelope") ? $3 : NaN):(behind_at(i, top_2, height_2)) \
       with lines linewidth 0.8 linecolor rgb behind, \
     for [i = 1:rows] data using (is("envelope") ? $3 : NaN):(level(i, top_2, height_2)) \
       with lines linewidth 0.8 linecolor rgb tint(i), \
     data using (numbered($4) ? line_at(1) : NaN):(rows + gap + 0.11):(sprintf("%g×", $4)) \
       with labels textcolor rgb line_tint font small
unset multiplot
