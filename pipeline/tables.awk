# Prints tables of a TOML file without comments, empty lines and indentation.
# usage: awk -v wanted="train train.piae-dt" -f tables.awk FILE.toml    (wanted="": the whole file)
# Strings may hold '#' and brackets; strings over several lines are not known here.

# The line without its comment; `depth` counts the brackets that are open behind it.
function without_comment(line,    i, c, quote) {
  quote = ""
  for (i = 1; i <= length(line); i++) {
    c = substr(line, i, 1)
    if (quote != "") {
      if (c == "\\" && quote == "\"") i++
      else if (c == quote) quote = ""
    } else if (c == "\"" || c == "'") quote = c
    else if (c == "#") return substr(line, 1, i - 1)
    else if (c == "[" || c == "{") depth++
    else if (c == "]" || c == "}") depth--
  }
  return line
}

BEGIN {
  all = (wanted == "")
  count = split(wanted, names, " ")
  for (i = 1; i <= count; i++) is_wanted[names[i]] = 1
}

{
  inside_value = (depth > 0)
  line = without_comment($0)
  gsub(/^[ \t\r]+|[ \t\r]+$/, "", line)
  if (line == "") next
  if (!inside_value && line !~ /^\[[^][]+\]$/ && line !~ /^\[\[[^][]+\]\]$/ && line !~ /^[A-Za-z0-9_."'-]+[ \t]*=/) {
    print FILENAME ", line " FNR ": neither a [table] nor key = value: " line >"/dev/stderr"
    exit 1
  }
  if (!inside_value && line ~ /^\[/) {
    name = line
    gsub(/[][ \t]/, "", name)
    printing = (name in is_wanted)
  }
  if (all || printing) print line
}
