# Fig. 7: seed,stage,epoch,curve,value. One panel for each loss; Stage 1 and Stage 2 have lines of their own.
# rows by: curve
stage_name(s) = s == 1 ? "Stage 1: each network its own loss" : "Stage 2: all the total loss"
line_of(seed, s) = seed eq "mean" ? s : 1
set logscale y
set format y "10^{%L}"
set xlabel "epoch"
set multiplot layout panels(words(words_curve), 2), 2 title "Losses of PIAE-DT by epoch"
do for [n = 1:words(words_curve)] {
  curve = word(words_curve, n)
  set title curve
  if (n == 2) { set key top right } else { unset key }
  plot for [seed in words_seed] for [s = 1:2] rows_of(curve) \
         using (strcol(1) eq seed && $2 == s ? $3 : NaN):5 \
         with lines linewidth (seed eq "mean" ? 2.4 : 0.6) dashtype line_of(seed, s) \
         linecolor rgb (seed eq "mean" ? colour(s) : faint(s)) \
         title (seed eq "mean" ? stage_name(s) : "")
}
unset multiplot
