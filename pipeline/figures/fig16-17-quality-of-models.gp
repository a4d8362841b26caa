# Figs 16 and 17, with metrics that do not reward silence.
# height: 1300
# rows by: metric
load scripts.'/models.gp'
heading = "Generated windows of ".models." and real ones, by class"
load scripts.'/quality.gp'
