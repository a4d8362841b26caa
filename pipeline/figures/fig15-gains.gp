# Fig. 15: what generated windows gain over none.
set title "Gain over no generated windows"
set ylabel "points of accuracy"
load scripts.'/gains.gp'
