# Quality of generated windows: metric,class,method,seed,value. One panel for each metric, one tick for each class,
# methods next to each other. Loaded by scripts that have set `heading`, and have rows by metric.
set key noautotitle
unset key
set xtics () rotate by 35 right
do for [n = 1:words(words_class)] { set xtics add (word(words_class, n) n) }
set xrange [0.5:words(words_class) + 0.5]
methods = words(words_method)
shift(method)   = (place(method, words_method) - (methods + 1) / 2.0) * 0.8 / methods
x(method)       = place(strcol(2), words_class) + shift(method)
seed_x(method)  = strcol(3) eq method && strcol(4) ne "mean" ? x(method) : NaN
mean_x(method)  = strcol(3) eq method && strcol(4) eq "mean" ? x(method) : NaN
tint(method)    = colour(place(method, words_method))
symbol(method)  = mark(place(method, words_method))
# Value of a window like the real ones; MMD and RMSE are good if small.
ideal(metric)   = metric eq "amplitude_ratio" ? 1 : 0
in_words(m) = m eq "mmd" ? "MMD²" : m eq "rmse" ? "RMSE (unit of the recordings)" : \
  m eq "aligned_rmse" ? "RMSE at the best shift" : m eq "amplitude_ratio" ? "RMS, generated to real" : \
  m eq "spectral_distance_db" ? "log-spectral distance, dB" : m eq "fault_line_db" ? "fault lines, dB" : \
  m eq "fault_line_difference_db" ? "fault lines, generated minus real, dB" : m
# Metrics that are positive, and good if small, start at 0, so that the panel shows the ideal.
from_zero(metric) = metric eq "mmd" || metric eq "spectral_distance_db"
is_rmse(metric)   = metric eq "rmse" || metric eq "aligned_rmse"
set multiplot layout panels(words(words_metric) + 1, 2), 2 title heading
do for [metric in words_metric] {
  set title in_words(metric)
  unset logscale y
  set ytics autofreq
  set yrange [*:*]
  if (from_zero(metric)) { set yrange [0:*] }
  if (is_rmse(metric)) {
    set logscale y
    set ytics ()
    do for [decade = -4:4] { do for [digit in "1 2 5"] { set ytics add (digit * 10.0 ** decade) } }
  }
  unset arrow
  if (metric ne "fault_line_db" && !is_rmse(metric)) {
    set arrow from graph 0, first ideal(metric) to graph 1, first ideal(metric) nohead \
      linecolor rgb 0x333333 dashtype 3 back
  }
  plot for [m in words_method] rows_of(metric) using (seed_x(m) + 0.3 / methods):5 \
         with points pointtype 7 pointsize 0.25 linecolor rgb (0x60 << 24) + tint(m), \
       for [m in words_method] rows_of(metric) using (mean_x(m)):5 \
         with points pointtype symbol(m) pointsize 0.6 linecolor rgb tint(m)
}
# The last panel is the key.
unset title
unset tics
unset border
unset arrow
unset logscale
set key at graph 0.5, 0.5 center maxrows 7
set yrange [0:1]
plot for [m in words_method] NaN with points pointtype symbol(m) pointsize 0.9 linecolor rgb tint(m) title m
unset multiplot
