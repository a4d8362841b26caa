# usage: awk -v folders="base cli ..." -f rooms.awk CONTRIBUTING.md FILE...
# A row of the table holds one or more rooms in backticks in its first column. Rooms of one row must not include each
# other.

function finding(what, right) { printf "%s:%d: %s; %s\n", FILENAME, FNR, what, right }

FILENAME == "CONTRIBUTING.md" {
  if (/^## /) in_section = /^## Rooms$/
  if (!in_section || !/^\| *`/) next
  ++rows
  split($0, columns, "|")
  count = split(columns[2], names, "`")
  for (i = 2; i <= count; i += 2) {
    row[names[i]] = rows
    if (index(" " folders, " " names[i] " ") == 0)
      finding("the table has a room '" names[i] "' without a folder", "remove it, or write it as its folder is called")
  }
  table_ends = FNR
  next
}

!folders_are_checked {
  folders_are_checked = 1
  count = split(folders, names, " ")
  for (i = 1; i <= count; ++i)
    if (!(names[i] in row))
      printf "CONTRIBUTING.md:%d: the room '%s' is not in the table; add it above all that it includes\n", table_ends, names[i]
}

FNR == 1 {
  split(FILENAME, parts, "/")
  room = parts[1] == "src" ? parts[2] : parts[1]
}

/^[ \t]*#[ \t]*include[ \t]*["<]/ {
  split($0, quoted, "[\"<>]")
  split(quoted[2], parts, "/")
  other = parts[1]
  if (other == room || !(room in row)) next
  if (!(other in row) && /</) next # a library's
  if (!(other in row) && index(" " folders, " " other " ")) next # reported above, once
  includes = "includes \"" quoted[2] "\""
  if (!(other in row))
    finding(includes ", which does not name a room of CONTRIBUTING.md", "write it from the room on, \"" room "/...\"")
  else if (row[other] < row[room])
    finding(includes ", but " room " stands below " other, "move what both need to " room " or below")
  else if (row[other] == row[room])
    finding(includes ", but " room " and " other " stand in one row", "move what both need to a row below")
}
