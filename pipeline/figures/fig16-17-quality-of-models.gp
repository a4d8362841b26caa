# Figs 16 and 17, and what does not reward silence.
# height: 1300
heading = "Generated windows of the paper's five models beside real ones, by class"
load scripts.'/quality.gp'
