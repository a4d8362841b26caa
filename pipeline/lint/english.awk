# Finds patterns of pipeline/lint/english.txt in comments and pages.
# usage: awk -f english.awk PATTERNS FILE...          whole files
#        git diff --unified=0 ... | awk -f english.awk PATTERNS -     the lines that a change adds

FNR == NR {
  if (/^#/) next
  split($0, parts, "\t")
  pattern[++patterns] = parts[1]
  advice[patterns] = parts[2]
  next
}
FILENAME == "-" && /^\+\+\+ / { file = substr($0, 7); fenced = 0; next }
FILENAME == "-" && /^@@/ { match($0, /\+[0-9]+/); line = substr($0, RSTART + 1, RLENGTH - 1) - 1; next }
FILENAME == "-" && !/^\+/ { next }
FILENAME == "-" { look(substr($0, 2), file, ++line); next }
FNR == 1 { fenced = 0 }
{ look($0, FILENAME, FNR) }

# Returns the comment of a line, or the line of a page; empty if there is none.
function text_of(row, file) {
  if (file ~ /\.md$/) {
    if (row ~ /^ *```/) fenced = !fenced
    return fenced || row ~ /^    / || row ~ /^ *```/ ? "" : row
  }
  if (file ~ /\.(cpp|hpp)$/) return match(row, /\/\/+<? /) ? substr(row, RSTART + RLENGTH) : ""
  return match(row, /(^|[ \t])# /) ? substr(row, RSTART + RLENGTH) : ""
}

function look(row, file, line,    text, i, rest) {
  text = text_of(row, file)
  if (text == "" || text ~ /lint/) return
  gsub(/`[^`]*`|"[^"]*"/, "x", text)
  first = match(text, /[^ ]/) ? substr(text, RSTART, 1) : ""
  rest = " " first tolower(substr(text, RSTART + 1)) " "
  for (i = 1; i <= patterns; ++i) {
    if (pattern[i] ~ /^\^/ && file ~ /\.md$/) continue
    if (rest ~ pattern[i]) printf "%s:%d: \"%s\"; write: %s\n", file, line, shown(text), advice[i]
  }
}

function shown(text) { return length(text) > 60 ? substr(text, 1, 57) "..." : text }
