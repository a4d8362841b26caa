# Figs 11 and 12, one fault class: panel,what,x,y,real, and one column for each method. Each of the four panels is one
# axis with a row for the real windows and for each method. A value is drawn at the middle of its row, plus its share of
# the row's height.
# height: 860
# rows by: panel
part = data[strstrt(data, "@") + 1:strlen(data) - 4]
stats data using 0 nooutput
rows  = STATS_columns - 4
names = ""
do for [i = 1:rows] {
  stats data using (name = columnhead(4 + i), 0) every ::::0 nooutput
  names = names." ".name
}
of(i)     = column(4 + i)
middle(i) = rows - i + 0.5
within_row(part) = part < -0.5 ? -0.5 : part > 0.5 ? 0.5 : part

# All rows of a panel have the scale of the real windows; larger values are cut at the edge of their row.
two_digits(x) = (unit = 10 ** (floor(log10(x)) - 1), unit * ceil(x / unit))
stats rows_of("waveform") using (abs(of(1))) name "real" nooutput
loudest = two_digits(1.2 * real_max)
wave(i) = middle(i) + within_row(of(i) / loudest / 2)
level(i, top, height) = within_row(0.5 - (top - of(i)) / height)
next_ten(x) = 10 * ceil(x / 10 + 0.2)
stats rows_of("spectrum") using (of(1)) name "real" nooutput
top_1 = next_ten(real_max)
stats rows_of("envelope") using (of(1)) name "real" nooutput
top_2 = next_ten(real_max)
stats rows_of("spectrogram") using (of(1)) name "real" nooutput
top_3 = next_ten(real_max)
height_1 = 60
height_2 = 40
height_3 = 50
stats rows_of("waveform") using 3 name "time" nooutput
stats rows_of("spectrum") using 3 name "frequency" nooutput
stats rows_of("envelope") using 3 name "last_line" nooutput

# Above the windows is a row of names for each type of fault line; `own` is the line of this class.
lines  = "BPFO BPFI 2BSF"
own    = ""
others = ""
is(kind) = strcol(1) eq kind # for rows that may be missing
stats data using (is("own-line") ? (own = strcol(2), 0) : 0) nooutput
do for [line in lines] { if (line ne own) { others = others." ".line } }
is_line(name)   = strcol(2) eq name && (is("line") || is("own-line"))
line_text(name) = $4 == 1 ? (name eq "2BSF" ? "2·BSF" : name) : sprintf("%g×", $4)
line_name(name) = sprintf(name eq own ? "{/:Bold*0.8 %s}" : "{/*0.8 %s}", line_text(name))
line_tint(name) = colour(1 + place(name, lines))
line_dash(name) = dash(1 + place(name, lines))
above     = 0.075
bottom    = 0.075
top       = 0.83
row_of_name(name) = rows * (1 + (above - 0.012) / (top - bottom) * (4 - place(name, lines) - 0.3) / 3.0)

unit_name = place("recordings", words_what) ? "units of the recordings" : "m/s²"
tint(i)   = i == 1 ? 0x222222 : colour(1)
behind    = 0xB0B0B0
left(n)   = 0 + word("0.115 0.345 0.565 0.805", n)
right(n)  = 0 + word("0.330 0.550 0.790 0.985", n)
heading(n, first, second) = sprintf("set label %d \"%s\" at screen %g, %g center; set label %d \"{/*0.85 %s}\" at screen %g, %g center textcolor rgb 0x555555", \
  2 * n, first, (left(n) + right(n)) / 2, top + above + 0.042, 2 * n + 1, second, (left(n) + right(n)) / 2, top + above + 0.016)

set multiplot
set border 1
unset grid
set ytics () scale 0
# Breaks a name that is longer than the margin after the last hyphen that fits.
do for [i = 1:rows] {
  name = word(names, i)
  fits = strlen(name) <= 14 ? strlen(name) : 0
  do for [letter = 1:14] { if (strlen(name) > 14 && name[letter:letter] eq "-") { fits = letter } }
  set ytics add (name[1:fits].(fits < strlen(name) ? "\n".name[fits + 1:*] : "") middle(i))
}
do for [i = 0:rows] {
  set arrow from graph 0, first i to graph 1, first i nohead linecolor rgb 0xDDDDDD linewidth 0.6 back
}
set bmargin at screen bottom
set tmargin at screen top
set yrange [0:rows]
set label 1 part.": real windows, and those that each method generated; in grey, the spectrum of real ones" \
  at screen 0.02, 0.98 noenhanced

n = 1
eval heading(n, "a window", sprintf("a row is ±%g %s", loudest, unit_name))
set lmargin at screen left(n)
set rmargin at screen right(n)
set xrange [0:time_max]
set xlabel "time, ms"
plot for [i = 1:rows] rows_of("waveform") using 3:(wave(i)) \
       with lines linewidth 0.5 linecolor rgb tint(i)
unset label
unset ytics

n = 2
eval heading(n, "amplitude spectrum", sprintf("a row is %g to %g dB", top_1 - height_1, top_1))
set lmargin at screen left(n)
set rmargin at screen right(n)
set xrange [0:frequency_max / 1e3]
set xlabel "frequency, kHz"
plot for [i = 2:rows] rows_of("spectrum") using ($3 / 1e3):(middle(i) + level(1, top_1, height_1)) \
       with lines linewidth 0.8 linecolor rgb behind, \
     for [i = 1:rows] rows_of("spectrum") using ($3 / 1e3):(middle(i) + level(i, top_1, height_1)) \
       with lines linewidth 0.8 linecolor rgb tint(i)
unset label

n = 4
eval heading(n, "spectrogram", sprintf("a row is 0 to %g kHz, %g dB", two_digits(frequency_max / 1e3), height_3))
set lmargin at screen left(n)
set rmargin at screen right(n)
set xrange [0:time_max]
if (time_max > 150) { set xtics 100 } # the panel is narrow
set xlabel "time, ms"
unset colorbox
set palette defined (0 'white', 1 '#0072B2', 2 '#001A2B') maxcolors 10
set cbrange [top_3 - height_3:top_3]
plot for [i = 1:rows] rows_of("spectrogram") using 3:(middle(i) - 0.5 + 0.94e-3 * $4 / (frequency_max / 1e3)):(of(i)) \
       with image
unset label
set xtics autofreq

n = 3
eval heading(n, "envelope spectrum", sprintf("%g to %g dB; dotted: ± shaft", top_2 - height_2, top_2))
set lmargin at screen left(n)
set rmargin at screen right(n)
set tmargin at screen top + above
set yrange [0:rows * (1 + above / (top - bottom))]
set xrange [0:last_line_max]
set xlabel "frequency, Hz"
plot for [f in others] data using (is_line(f) ? $3 : NaN):(0):(0):(rows) \
       with vectors nohead dashtype line_dash(f) linewidth 0.7 linecolor rgb line_tint(f), \
     data using (is("sideband") ? $3 : NaN):(0):(0):(rows) \
       with vectors nohead dashtype 3 linewidth 0.9 linecolor rgb line_tint(own), \
     data using (is_line(own) ? $3 : NaN):(0):(0):(rows) \
       with vectors nohead linewidth 1 linecolor rgb line_tint(own), \
     for [f in lines] data using (is_line(f) ? $3 : NaN):(row_of_name(f)):(line_name(f)) \
       with labels textcolor rgb line_tint(f), \
     for [i = 2:rows] rows_of("envelope") using 3:(middle(i) + level(1, top_2, height_2)) \
       with lines linewidth 0.8 linecolor rgb behind, \
     for [i = 1:rows] rows_of("envelope") using 3:(middle(i) + level(i, top_2, height_2)) \
       with lines linewidth 0.8 linecolor rgb tint(i)
unset multiplot
