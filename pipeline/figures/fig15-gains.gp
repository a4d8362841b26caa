# Fig. 15: gain of generated windows over none.
set title "Gain over no generated windows".by_whom
set ylabel "points of accuracy"
set arrow from 0.5, 0 to words(words_ratio) + 0.5, 0 nohead linecolor rgb 0x333333 back
load scripts.'/gains.gp'
