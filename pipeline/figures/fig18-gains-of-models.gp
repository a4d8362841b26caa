# Fig. 18: gain of windows from the paper's models, and from those of its outlook, over none.
load scripts.'/models.gp'
set title "Gain of ".models." over no generated windows".by_whom
set ylabel "points of accuracy"
set arrow from 0.5, 0 to words(words_ratio) + 0.5, 0 nohead linecolor rgb 0x333333 back
load scripts.'/gains.gp'
