# Loaded by scripts that show each method separately. Column 1 of their data is the method, column 2 is true for a
# ceiling. Scripts with a row for each method, the first at the top, set `names = 1` (or 0, for bare rows) and load
# name_rows.gp for each panel.
ceilings = ""
stats data using ($2 == 1 && !place(strcol(1), ceilings) ? (ceilings = ceilings." ".strcol(1), 1) : 0) nooutput
named(method) = place(method, ceilings) ? method." (ceiling)" : method
name_width    = 0  # of the longest name, in pixels
do for [method in words_method] {
  width = 20 + 7 * strlen(named(method))
  name_width = width > name_width ? width : name_width
}
own_row(down) = place(strcol(1), words_method) + down  # of a line of the data
