# Fig. 8: seed,stage,epoch,curve,value. One panel, a colour a weight.
set xlabel "epoch"
set ylabel "weight of eq. 23"
set yrange [0:*]
set title "Weights of the losses of PIAE-DT by epoch"
set key outside right center
label(curve) = curve eq "alpha" ? "α, differential" : curve eq "beta" ? "β, twin" : "γ, reconstruction"
plot for [seed in words_seed] for [n = 1:words(words_curve)] data \
       using ((strcol(4) eq word(words_curve, n) && strcol(1) eq seed) ? $3 : NaN):5 \
       with lines linewidth (seed eq "mean" ? 2.4 : 0.6) dashtype dash(n) \
       linecolor rgb (seed eq "mean" ? colour(n) : faint(n)) \
       title (seed eq "mean" ? label(word(words_curve, n)) : "")
