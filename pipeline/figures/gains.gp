# Gains or accuracies by ratio: method,ceiling,ratio,generated_per_class,seed,VALUE,low,high,published,published_of.
# Loaded by scripts that have set a title and drawn the baseline. Methods are next to each other at each ratio. The
# paper's results of a method are dashed in its colour, with a plus at each ratio. Single seeds are at the right of
# their mean.
set key outside right center
set xlabel "healthy windows to those of each fault (generated windows of each fault)" offset 0,-0.7
set xtics () scale 0
do for [n = 1:words(words_ratio)] {
  ratio = word(words_ratio, n)
  stats data using (strcol(3) eq ratio ? $4 : NaN) name "generated" nooutput
  set xtics add (sprintf("%s:1\n(%d)", ratio[1:strstrt(ratio, "to") - 1], generated_max) n)
}
methods  = words(words_method)
ceilings = ""
published = ""
do for [method in words_method] {
  values = 0
  of_ceiling = 0
  stats data using (of = strcol(1) eq method, values = values + (of && valid(9)), \
                    of_ceiling = of_ceiling + (of && $2 == 1), 0) nooutput
  if (values > 0) { published = published." ".method }
  if (of_ceiling > 0) { ceilings = ceilings." ".method }
}
# Only `none` has this ratio.
shift(method) = method eq "none" ? 0 : (place(method, words_method) - (methods + 1) / 2.0) * 0.8 / methods
x(method)     = place(strcol(3), words_ratio) + shift(method)
seed_x(method) = strcol(1) eq method && strcol(5) ne "mean" ? x(method) + 0.24 / methods : NaN
mean_x(method) = strcol(1) eq method && strcol(5) eq "mean" ? x(method) : NaN
tint(method)   = place(method, ceilings) ? ceiling_colour : colour(place(method, words_method))
symbol(method) = mark(place(method, words_method))
named(method)  = place(method, ceilings) ? method." (ceiling)" : method
set xrange [0.5:words(words_ratio) + 0.5]
# Names the paper's recordings if other recordings stand in for them.
of_whom = exists("words_published_of") ? " of ".words_published_of : ""
plot for [m in words_method] data using (seed_x(m)):6 \
       with points pointtype 7 pointsize 0.3 linecolor rgb (0x40 << 24) + tint(m), \
     for [m in words_method] data using (mean_x(m)):6:(valid(7) ? $7 : $6):(valid(8) ? $8 : $6) \
       with yerrorbars pointtype symbol(m) pointsize 0.7 linewidth 1.2 linecolor rgb tint(m) title named(m), \
     for [m in published] data using (mean_x(m)):9 \
       with linespoints pointtype 1 pointsize 0.4 dashtype 2 linewidth 0.8 linecolor rgb tint(m), \
     keyentry with linespoints pointtype 1 pointsize 0.4 dashtype 2 linecolor rgb 0x555555 \
       title (published eq "" ? "" : "as published".of_whom)
