# Rows of method_rows.gp, with or without names. Loaded by scripts for each panel.
set yrange [words(words_method) + 0.6:0.4]
set ytics () scale 0 font font_12 noenhanced
do for [n = 1:words(words_method)] { set ytics add ((names ? named(word(words_method, n)) : "") n) }
