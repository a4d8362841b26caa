# Fig. 18: what the windows of the paper's five models gain over none.
set title "Gain of the paper's models over no generated windows"
set ylabel "points of accuracy"
load scripts.'/gains.gp'
