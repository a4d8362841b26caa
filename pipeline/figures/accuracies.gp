# Accuracy of all methods by ratio.
set title "Accuracy".by_whom
set ylabel "percent"
# Results without any generated window are lines across all ratios, each with its own dots: `none`, and another
# classifier for comparison, whose name replaces a method's.
others = ""
do for [m in words_method] {
  without = 0
  stats data using (without = without + (strcol(1) eq m && $4 == 0), 0) nooutput
  if (without > 0) {
    stats data using (strcol(1) eq m && strcol(5) eq "mean" ? $6 : NaN) name "line" nooutput
    dots = m eq "none" ? 3 : 4
    set arrow from graph 0, first line_max to graph 1, first line_max nohead dashtype dots \
      linecolor rgb 0x555555
    set label m at graph 1.01, first line_max left textcolor rgb 0x555555
  }
  if (without == 0 || m eq "none") { others = others." ".m }
}
words_method = others
load scripts.'/gains.gp'
