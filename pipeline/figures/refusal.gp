# Precision by the share of the windows that is answered: method,ceiling,ratio,answered,precision. A line a method.
load scripts.'/method_rows.gp'
set title "Right answers where only the surest windows are answered".by_whom.", at ".colon(word(words_ratio, words(words_ratio)))
set xlabel "test windows that are answered, percent"
set ylabel "answers that are right, percent"
set key outside right center
stats data using 5 nooutput
# Always with the precision that is wanted, and room above what is perfect.
lowest = STATS_min < 94 ? STATS_min : 94
set xrange [0:100]
set yrange [lowest - 0.02 * (100 - lowest):100 + 0.01 * (100 - lowest)]
set arrow from graph 0, first 95 to graph 1, first 95 nohead dashtype 2 linecolor rgb 0x555555
set label "95 %" at graph 1.01, first 95 left textcolor rgb 0x555555
tint(m) = place(m, ceilings) ? ceiling_colour : colour(place(m, words_method))
# Marks at every tenth point, not at the same ones for all, so that lines that meet can be told apart.
start(m) = (3 * place(m, words_method)) % 10
plot for [m in words_method] data using (strcol(1) eq m ? $4 : NaN):5 \
       with linespoints pointtype mark(place(m, words_method)) pointsize 0.6 pointinterval 10 \
       linewidth 1.3 linecolor rgb tint(m) title named(m)
