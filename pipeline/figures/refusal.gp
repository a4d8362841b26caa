# Precision by the share of answered windows: method,ceiling,ratio,answered,precision. One line for each method. Methods
# at the ratio of `none` other than `none` are classifiers for comparison: lines without marks.
load scripts.'/method_rows.gp'
set title "Correct answers if only the most certain windows are answered".by_whom.", at ".colon(word(words_ratio, words(words_ratio)))
set xlabel "answered test windows, percent"
set ylabel "correct answers, percent"
set key outside right center
stats data using 5 nooutput
reference = ""
stats data using (strcol(3) eq "100to1" && strcol(1) ne "none" ? (reference = strcol(1), 0) : 0) name "bar" nooutput
# Always show the target precision, and room above 100 %.
lowest = STATS_min < 94 ? STATS_min : 94
set xrange [0:100]
set yrange [lowest - 0.02 * (100 - lowest):100 + 0.01 * (100 - lowest)]
set arrow from graph 0, first 95 to graph 1, first 95 nohead dashtype 2 linecolor rgb 0x555555
set label "95 %" at graph 1.01, first 95 left textcolor rgb 0x555555
methods = ""
do for [m in words_method] { if (m ne reference) { methods = methods." ".m } }
order(m) = place(m, words_method)
tint(m)  = m eq reference ? 0x555555 : place(m, ceilings) ? ceiling_colour : colour(order(m))
line(m)  = m eq reference ? 4 : order(m) > 8 ? 2 : 1
# Marks every tenth point, shifted for each method, to distinguish lines that coincide.
is_marked(m) = strcol(1) eq m && (int($4) + 3 * order(m)) % 10 == 0
plot for [m in words_method] data using (strcol(1) eq m ? $4 : NaN):5 \
       with lines dashtype line(m) linewidth 1.3 linecolor rgb tint(m), \
     for [m in methods] data using (is_marked(m) ? $4 : NaN):5 \
       with points pointtype mark(order(m)) pointsize 0.6 linecolor rgb tint(m), \
     for [m in methods] keyentry with linespoints dashtype line(m) linewidth 1.3 pointtype mark(order(m)) \
       pointsize 0.6 linecolor rgb tint(m) title named(m), \
     keyentry with lines dashtype 4 linewidth 1.3 linecolor rgb 0x555555 title reference
