# Shortens gnuplot's SVG to a third, with the same picture to a twentieth of a pixel, since a page holds many. Points of
# lines become relative, in tenths of a pixel. Successive marks of one kind become one path with a mark at each point.
# Empty groups are dropped.
# usage: awk -f shorten.awk FILE.svg

# Formats 12.3 as "12.3", -0.3 as "-.3"; a minus does not need a space before it.
function number(n,    text) {
  text = n / 10 ""
  sub(/^0\./, ".", text)
  sub(/^-0\./, "-.", text)
  return text
}
function tenths(text) {
  return int(text * 10 + (text < 0 ? -0.5 : 0.5))
}
function spaced(n) {
  return (n < 0 ? "" : " ") number(n)
}
# Adds the next point of a path; `command` is M or L.
function point(command, x, y,    text) {
  if (command == "M") text = "M" number(x) spaced(y)
  else text = (command == last_command ? spaced(x - last_x) : "l" number(x - last_x)) spaced(y - last_y)
  last_command = command
  last_x = x
  last_y = y
  return text
}

function show(line) {
  if (group != "" && line == "</g>") group = ""
  else {
    if (group != "") print group
    group = ""
    if (line ~ /^<g [^>]*>$/) group = line
    else print line
  }
}

function end_marks(    id) {
  if (marks == "") return
  # A kind has the same name in every picture, since a page may hold several pictures.
  id = mark
  gsub(/[^A-Za-z0-9]+/, "-", id)
  if (!(id in defined)) show("<marker id='" id "' overflow='visible' markerUnits='userSpaceOnUse'>" mark "</marker>")
  defined[id]
  show("<path style='stroke:none;marker:url(#" id ")' d='" marks "'/>")
  marks = ""
}

# Parses a mark such as <use xlink:href='#gpPt6' transform='translate(54.01,9.50) scale(2.25)' color='rgb(0, 1, 2)'/>
/^[ \t]*<use xlink:href='#gpPt[0-9]+' transform='translate\([-0-9.]+,[-0-9.]+\) scale\([0-9.]+\)' [^>]*\/>$/ {
  split($0, part, "'")
  split(part[4], place, /[(),]/)
  kind = $0
  sub(/translate\([^)]*\) /, "", kind)
  if (kind != mark) end_marks()
  mark = kind
  marks = marks point(marks == "" ? "M" : "L", tenths(place[2]), tenths(place[3]))
  next
}
/^$/ { next }

{ end_marks() }

in_path || /<path [^>]* d='M/ {
  line = $0
  text = ""
  while (match(line, /[ML]-?[0-9.]+,-?[0-9.]+ ?/)) {
    split(substr(line, RSTART + 1, RLENGTH - 1), place, ",")
    before = substr(line, 1, RSTART - 1)
    sub(/^[ \t]+$/, "", before)
    text = text before point(substr(line, RSTART, 1), tenths(place[1]), tenths(place[2]))
    line = substr(line, RSTART + RLENGTH)
  }
  in_path = line !~ /'/
  if (!in_path) sub(/^[ \t]+'/, "'", line)
  held = held text line
  if (in_path) next
  show(held)
  held = ""
  next
}
{ show($0) }
END { if (group != "") print group }
