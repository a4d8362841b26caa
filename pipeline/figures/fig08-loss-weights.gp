# Fig. 8: seed,stage,epoch,curve,value. One panel, one colour for each weight; the seed "stationary" marks the minimum
# of eq. 23.
# rows by: curve
set xlabel "epoch"
set ylabel "weight of eq. 23, logarithmic"
set logscale y
set yrange [*:*]
set title "Weights of the losses of PIAE-DT by epoch, and the minimum of eq. 23 (dotted)"
set key outside right center
label(curve) = curve eq "alpha" ? "α, differential" : curve eq "beta" ? "β, twin" : "γ, reconstruction"
is_least         = "stationary"
dash_of(seed, n) = seed eq is_least ? 3 : dash(n)
plot for [seed in words_seed] for [n = 1:words(words_curve)] rows_of(word(words_curve, n)) \
       using (strcol(1) eq seed ? $3 : NaN):5 \
       with lines linewidth (seed eq "mean" ? 2.4 : seed eq is_least ? 1.2 : 0.6) \
       dashtype dash_of(seed, n) \
       linecolor rgb (seed eq "mean" || seed eq is_least ? colour(n) : faint(n)) \
       title (seed eq "mean" ? label(word(words_curve, n)) : "")
