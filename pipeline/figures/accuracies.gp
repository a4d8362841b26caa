# Accuracy of all methods by ratio.
set title "Accuracy"
set ylabel "percent"
stats data using (strcol(1) eq "none" && strcol(5) eq "mean" ? $6 : 0) name "none" nooutput
if (none_max > 0) {
  set arrow from graph 0, first none_max to graph 1, first none_max nohead dashtype 3 linecolor rgb 0x555555
  set label "none" at graph 1.01, first none_max left textcolor rgb 0x555555
}
load scripts.'/gains.gp'
