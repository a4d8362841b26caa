# A grid of panels of equal size, with shared names at the left and lower edges. Loaded by scripts that have set
# `count`, `columns`, and edges and gaps in pixels of a picture 960 wide. Then run `eval panel_at(i)` for each panel i
# from 1. It frees the ranges, which would restrict `stats`; set them afterwards.
panel_rows   = panels(count, columns)
panel_width  = (960.0 - edge_left - edge_right - gap_x * (columns - 1)) / columns
panel_height = (1.0 * height - edge_top - edge_bottom - gap_y * (panel_rows - 1)) / panel_rows
left_of(i)   = (edge_left + (i - 1) % columns * (panel_width + gap_x)) / 960
top_of(i)    = 1 - (edge_top + (i - 1) / columns * (panel_height + gap_y)) / height
margins(left, right, top, bottom) = \
  sprintf("set lmargin at screen %f; set rmargin at screen %f; set tmargin at screen %f; set bmargin at screen %f; ", \
          left, right, top, bottom)
panel_at(i) = margins(left_of(i), left_of(i) + panel_width / 960, top_of(i), top_of(i) - panel_height / height). \
  "set xrange [*:*]; set yrange [*:*]"
is_leftmost(i) = (i - 1) % columns == 0
is_lowest(i)   = i + columns > count
# Draws outside the panels: a heading and the names of the axes, with the first panel only. For a row with a key below
# the heading, run `eval key_row` after the last panel and plot empty series with titles.
set label 1 at screen 0.5, 1 - 16.0 / height center noenhanced
set label 2 at screen 0.5, 14.0 / height center
set label 3 at screen 0.018, 0.5 rotate by 90 center
headings_done = "unset label 1; unset label 2; unset label 3"
key_row  = margins(0.05, 0.95, 1 - 24.0 / height, 1 - 48.0 / height). \
  "unset border; unset tics; unset title; unset label; unset arrow; unset object; ". \
  "set xrange [0:1]; set yrange [0:1]; set key at screen 0.5, 1 - 36.0 / height center horizontal maxrows 1"
# Font size in pixels; 13 is the default, which is 9 points in a PDF.
sized(pixels) = sprintf(",%g", format eq "pdf" ? pixels * 9 / 13.0 : pixels)
font_9  = sized(9)
font_10 = sized(10)
font_11 = sized(11)
font_12 = sized(12)
# Seeds are half transparent. A mean without an interval has a bar of length zero, which is invisible without caps.
set errorbars small
dots(i) = (0x80 << 24) + colour(i)
# Distance of ticks that gives about five of them.
step(span) = span > 110 ? 50 : span > 55 ? 20 : span > 25 ? 10 : span > 11 ? 5 : span > 5 ? 2 : \
             span > 2 ? 1 : span / 4.0
