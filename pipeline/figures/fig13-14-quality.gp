# Figs 13 and 14, with metrics that do not reward silence.
# height: 1300
# rows by: metric
heading = "Generated windows of the methods and real ones, by class"
load scripts.'/quality.gp'
