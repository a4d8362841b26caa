# Draws a table, transfer@GROUP.csv of `make transfer`:
# dataset,speed_ratio,method,role,classifier,recorded,best,ratio,seed,accuracy,std,ci95_low,ci95_high,... Each data set
# at the left, by tested speed if the speed changes; their mean at the right. One colour and mark for each method, at
# its recorded input.
# height: 540
edge_left = 64; edge_right = 14; edge_top = 72; edge_bottom = 96; gap_x = 0; gap_y = 0
count = 1; columns = 1
load scripts.'/panel_grid.gp'
right_of_sets = 570.0; left_of_mean = 592.0; right_of_mean = 722.0

# Curves are named METHOD@CLASSIFIER: each method by its recorded input, or by all if this run has none of the recorded
# inputs. First the method that is subtracted from the others; ceilings apart.
recorded = 0
stats data using (recorded = recorded + ($6 == 1 && strcol(4) ne "ceiling"), 0) nooutput
curve(unused) = strcol(4) ne "bar" && ($6 == 1 || recorded == 0) ? strcol(3)."@".strcol(5) : ""
method_of(m) = m[1:strstrt(m, "@") - 1]
methods = ""; ceilings = ""; against = ""
do for [wanted in "against method ceiling"] { do for [m in words_method] { do for [c in words_classifier] {
  found = 0
  stats data using (found = found + (curve(0) eq m."@".c && strcol(4) eq wanted), 0) nooutput
  if (found) {
    if (wanted eq "ceiling") { ceilings = ceilings." ".m."@".c } else { methods = methods." ".m."@".c }
    if (wanted eq "against") { against = m }
  }
} } }
# Classifiers without training, which need no generated window, are lines.
bars = ""
do for [c in words_classifier] {
  found = 0
  stats data using (found = found + (strcol(5) eq c && strcol(4) eq "bar"), 0) nooutput
  if (found) { bars = bars." ".c }
}
tone(c) = place(c, bars) == 1 ? 0x333333 : 0x888888
many = words(methods)
entry(m) = method_of(m).", ".m[strstrt(m, "@") + 1:]

# Names of data sets without their common beginning. The last word is their mean.
sets  = words(words_dataset) - 1
name(i) = word(words_dataset, i)
common = strlen(name(1))
do for [i = 1:sets] {
  while (common > 0 && (strlen(name(i)) < common || substr(name(i), 1, common) ne substr(name(1), 1, common))) { common = common - 1 }
}
while (common > 0 && substr(name(1), common, common) ne "-") { common = common - 1 }
# A few data sets have room for their whole names.
short(i) = sets > 1 && (by_speed || sets > 4) ? substr(name(i), common + 1, strlen(name(i))) : name(i)

# Place of a data set: the logarithm of its speed ratio, or in sequence if the speed does not change.
array ratios[sets]
do for [i = 1:sets] {
  undefine ratio_*
  stats data using (strcol(1) eq name(i) && valid(2) ? $2 : NaN) name "ratio" nooutput
  ratios[i] = exists("ratio_records") && ratio_records > 0 ? ratio_min : 1
}
by_speed = 0
do for [i = 1:sets] { if (abs(log(ratios[i])) > 0.05) { by_speed = 1 } }
spot(i) = by_speed ? log(ratios[i]) / log(2) : i
nearest_gap = 1.0
do for [i = 1:sets] { do for [j = 1:sets] {
  apart = abs(spot(i) - spot(j))
  if (i != j && apart > 0.02 && apart < nearest_gap) { nearest_gap = apart }
} }
least = spot(1); most = spot(1)
do for [i = 1:sets] { least = spot(i) < least ? spot(i) : least; most = spot(i) > most ? spot(i) : most }
# Methods are next to each other, each followed by its seeds.
pitch(wide)  = 0.75 * wide / (many > 5 ? many : 5)
off(m, wide) = (place(m, methods) - (many + 1) / 2.0) * pitch(wide)

of(m)    = curve(0) eq m
of_bar(c) = strcol(5) eq c && strcol(4) eq "bar"
set_in(n) = place(strcol(n), words_dataset)
plain(n) = set_in(n) <= sets ? spot(set_in(n)) : NaN
at(m)    = plain(1) + off(m, nearest_gap)
middle(m) = is_mean(1) ? off(m, 1) : NaN
is_mean(n) = strcol(n) eq "mean"
end(n)   = valid(n) ? column(n) : $10
tint(m)  = colour(place(m, methods))
symbol(m) = mark(place(m, methods))
thick(m) = method_of(m) eq against ? 2.2 : 1.1
large(m) = method_of(m) eq against ? 1.0 : 0.7

stats data using (curve(0) ne "" || strcol(4) eq "bar" ? end(12) : NaN) name "low" nooutput
bottom = floor(low_min / 10.0) * 10 - 2
set yrange [(bottom < 0 ? -2 : bottom):102]
set label 1 (by_speed ? "Accuracy at a speed other than that of the known faults" : \
  "Accuracy in a condition other than that of the known faults").": ".part
set label 4 (recorded > 0 ? "each method by the input chosen for it beforehand" : "each method by each input")."; marks: mean over the seeds and its 95 % interval; dots: seeds" \
  at screen 0.5, 1 - 36.0 / height center font font_11 textcolor rgb 0x555555
set label 2 by_speed ? "tested speed divided by the speed at which faults are known (data set".(sets > 6 ? "s" : "")." ".substr(name(1), 1, common)."...)" \
  : sets > 4 ? "data set ".substr(name(1), 1, common)."..." : "data set"
set label 2 at screen (edge_left + right_of_sets) / 2 / 960, 22.0 / height noenhanced
set label 3 "accuracy, percent"
set ytics 0, 20, 100 font font_12
set multiplot
eval margins(edge_left / 960.0, right_of_sets / 960, 1 - 1.0 * edge_top / height, 1.0 * edge_bottom / height)
set xrange [least - 0.6 * nearest_gap:most + 0.6 * nearest_gap]
set xtics () scale 0 font font_12
# Names have no room if many ratios are close; the ratio tells the data sets then.
crowded = by_speed && nearest_gap < 0.1 * (most - least)
if (crowded) {
  array round_ratios[9] = [0.25, 0.33, 0.5, 0.67, 0.8, 1, 1.25, 1.5, 2]
  do for [i = 1:9] { set xtics add (sprintf("%.3g", round_ratios[i]) log(round_ratios[i]) / log(2)) }
} else {
  do for [i = 1:sets] { set xtics add ((by_speed ? sprintf("%.3g\n%s", ratios[i], short(i)) : short(i)) spot(i)) }
}
set key off
# Connect data sets only if they have an order; else each has a separate line.
joined(names) = by_speed ? names : ""
apart(names)  = by_speed ? "" : names
plot for [m in joined(ceilings)] data using (of(m) && is_mean(9) ? plain(1) : NaN):10 smooth unique \
       with lines linewidth 1.6 dashtype 2 linecolor rgb ceiling_colour, \
     for [c in joined(bars)] data using (of_bar(c) && is_mean(9) ? plain(1) : NaN):10 smooth unique \
       with lines linewidth 1.6 dashtype 3 linecolor rgb tone(c), \
     for [m in apart(ceilings)] data using (of(m) && is_mean(9) ? plain(1) - 0.45 : NaN):10:(0.9):(0) \
       with vectors nohead linewidth 1.6 dashtype 2 linecolor rgb ceiling_colour, \
     for [c in apart(bars)] data using (of_bar(c) && is_mean(9) ? plain(1) - 0.45 : NaN):10:(0.9):(0) \
       with vectors nohead linewidth 1.6 dashtype 3 linecolor rgb tone(c), \
     for [m in joined(methods)] data using (of(m) && is_mean(9) ? at(m) : NaN):10 smooth unique \
       with lines linewidth 0.7 linecolor rgb faint(place(m, methods)), \
     for [m in methods] data using (of(m) && !is_mean(9) ? at(m) + 0.35 * pitch(nearest_gap) : NaN):10 \
       with points pointtype 7 pointsize 0.25 linecolor rgb dots(place(m, methods)), \
     for [m in methods] data using (of(m) && is_mean(9) ? at(m) : NaN):10:(end(12)):(end(13)) \
       with yerrorbars pointtype symbol(m) pointsize large(m) linewidth thick(m) linecolor rgb tint(m)
eval headings_done
unset label 4
eval margins(left_of_mean / 960, right_of_mean / 960, 1 - 1.0 * edge_top / height, 1.0 * edge_bottom / height)
set xrange [-0.6:0.6]
set xtics () scale 0 font font_12
set xtics add ("mean" 0)
set format y ""
# All entries in one column.
entries = many + words(ceilings) + words(bars)
key_font = entries > 20 ? font_10 : font_11
set key at screen (right_of_mean + 14) / 960, 1 - 1.0 * edge_top / height left top reverse Left vertical maxrows 99 samplen 1.5 \
  spacing (entries > 20 ? 1 : 1.25) font key_font noenhanced
plot for [m in methods] data using (of(m) && !is_mean(9) ? middle(m) + 0.35 * pitch(1) : NaN):10 \
       with points pointtype 7 pointsize 0.25 linecolor rgb dots(place(m, methods)) notitle, \
     for [m in methods] data using (of(m) && is_mean(9) ? middle(m) : NaN):10:(end(12)):(end(13)) \
       with yerrorbars pointtype symbol(m) pointsize large(m) linewidth thick(m) linecolor rgb tint(m) title entry(m), \
     for [m in ceilings] data using (of(m) && is_mean(9) && is_mean(1) ? -0.6 : NaN):10:(1.2):(0) \
       with vectors nohead linewidth 1.6 dashtype 2 linecolor rgb ceiling_colour title method_of(m)." (ceiling)", \
     for [c in bars] data using (of_bar(c) && is_mean(9) && is_mean(1) ? -0.6 : NaN):10:(1.2):(0) \
       with vectors nohead linewidth 1.6 dashtype 3 linecolor rgb tone(c) title "none by ".c
unset multiplot
