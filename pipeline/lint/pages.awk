# Finds broken links, unknown targets of make and pages that are too long. A word is what `wc -w` counts, outside blocks
# of code between ```: cells and bars of tables, and indented commands, count. Every page is given twice: the first
# pass collects the headings.
# usage: awk -v targets="all cells ..." -v files="|a|b|" -f pages.awk PAGE... PAGE...

BEGIN {
  most["README.md"] = 1300; most["docs/results.md"] = 2500; most["docs/method.md"] = 2500
  most["CONTRIBUTING.md"] = 2000; most["SECURITY.md"] = 700
  most_of_a_page = 1000
  most_of_all = 24000  # without CHANGELOG.md, to which each version adds
  # Only the sum limits these.
  most["docs/claims.md"] = most["docs/tables.md"] = most["CHANGELOG.md"] = most_of_all
  most["pipeline/datasets/README.md"] = most_of_all
  most_lines["README.md"] = 150
}

function finding(what) { printf "%s:%d: %s\n", FILENAME, FNR, what }

# Returns the anchor of a heading in links.
function anchor_of(heading) {
  heading = tolower(heading)
  gsub(/[^a-z0-9 _-]/, "", heading)
  gsub(/ /, "-", heading)
  return heading
}

function folder_of(file) { return match(file, /.*\//) ? substr(file, 1, RLENGTH) : "" }

# Resolves a/b/../c to a/c.
function resolved(path) {
  while (match(path, /(^|\/)[^\/.][^\/]*\/\.\.\//)) {
    path = substr(path, 1, RSTART - 1 + (substr(path, RSTART, 1) == "/")) substr(path, RSTART + RLENGTH)
  }
  return path
}

function check_link(link,    parts, file) {
  if (link ~ /^[a-z]+:/) return
  split(link, parts, "#")
  file = parts[1] == "" ? FILENAME : resolved(folder_of(FILENAME) parts[1])
  sub(/\/$/, "", file)
  if (!index(files, "|" file "|") && !index(files, "|" file "/")) {
    finding("links to " file ", which is not there; name a file of the project")
  } else if (parts[2] != "" && file ~ /\.md$/ && !((file, parts[2]) in anchors)) {
    finding("links to " link ", but " file " has no such heading; name one that it has")
  }
}

function check_target(line,    words, count, i) {
  count = split(line, words, /[ \t]+/)
  for (i = 1; i < count; ++i) {
    if (words[i] != "make" || words[i + 1] !~ /^[a-z][a-z-]*$/) continue
    if (!index(" " targets, " " words[i + 1] " ")) {
      finding("make has no target " words[i + 1] "; see make help")
    }
    return
  }
}

FNR == 1 { ++pass[FILENAME]; fenced = 0 }
{ lines_of[FILENAME] = FNR }
/^ *```/ { fenced = !fenced; next }
pass[FILENAME] == 1 {
  if (!fenced && /^#+ /) anchors[FILENAME, anchor_of(substr($0, index($0, " ") + 1))] = 1
  next
}
!fenced { words_of[FILENAME] += NF }
fenced || /^    / { check_target($0); next }
{
  rest = $0
  while (match(rest, /\]\([^)]*\)/)) {
    link = substr(rest, RSTART + 2, RLENGTH - 3)
    rest = substr(rest, RSTART + RLENGTH)
    check_link(link)
  }
}

END {
  for (page in words_of) {
    if (page != "CHANGELOG.md") all += words_of[page]
    limit = page in most ? most[page] : most_of_a_page
    if (words_of[page] > limit) printf "%s:1: has %d words; %d at most\n", page, words_of[page], limit
  }
  for (page in most_lines) {
    if (lines_of[page] > most_lines[page]) {
      printf "%s:1: has %d lines; %d at most\n", page, lines_of[page], most_lines[page]
    }
  }
  if (all > most_of_all) printf "README.md:1: all pages have %d words; %d at most\n", all, most_of_all
}
