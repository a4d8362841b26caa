# Shared by all figures. A script can use:
#   colour(i), dash(i), mark(i)   of the i-th item, from 1: colours that are distinct for the usual colour
#                                 blindnesses (Okabe and Ito 2008), never used without another cue
#   faint(rgb)                    the same colour for single seeds behind a mean
#   panels(n, columns)            number of rows in a grid of n panels
#   by_whom                       ending for titles of accuracies: ", by CLASSIFIER", or empty for the paper's; marks those
#                                 that see windows of D
# draw.sh sets `data` (the CSV), `part` (the part of its name after the "@", or empty), words_<column> (the distinct
# words of every column of words, in order; ratios from 100to1 to 1to1), and in a script with "# rows by: COLUMN"
# rows_of(word), the rows of each word of that column.

sees_d(classifier) = classifier eq "dann" || classifier eq "cdan" ? " (sees D)" : ""
by_whom = exists("part") && part ne "" ? ", by ".part.sees_d(part) : ""

set datafile separator comma
set datafile columnheaders
set datafile missing NaN
set encoding utf8

array okabe_ito[8] = [0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9, 0x000000, 0x999933]
array marks[8]     = [7, 5, 9, 11, 13, 6, 4, 8]
array dashes[8]    = [1, 2, 4, 5, 3, 1, 2, 4]
# Also defined for 0, which gnuplot uses for an empty list.
colour(i) = okabe_ito[(i + 7) % 8 + 1]
mark(i)   = marks[(i + 7 + 3 * ((i - 1) / 8)) % 8 + 1]  # the ninth differs from the first
dash(i)   = dashes[(i + 7) % 8 + 1]
faint(i)  = (0xB0 << 24) + colour(i)
ceiling_colour = 0x777777
panels(n, columns) = (n + columns - 1) / columns

colon(ratio) = ratio[1:strstrt(ratio, "to") - 1].":".ratio[strstrt(ratio, "to") + 2:]  # "10:1" for 10to1
# Returns the place of a word in a list, from 1.
place(word, list) = (found = 0, sum [n = 1:words(list)] (word(list, n) eq word ? (found = n) : 0), found)

set border 3 linecolor rgb 0x555555
set tics nomirror out scale 0.5 textcolor rgb 0x333333
set grid linecolor rgb 0xE4E4E4 linewidth 0.7 linetype 1
set key noautotitle samplen 2 textcolor rgb 0x333333
set title offset 0,-0.6
set style fill solid 1 noborder
