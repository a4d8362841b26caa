# Makes a manual page of what a program says of itself with --help: a summary, "Usage:", headings that end in a
# colon, "Example:" and "Exit codes:". Below a heading, a line that is indented by two spaces is an entry, whose
# text stands behind two spaces more, in column 39, or, where its name is long, in that of the next line; deeper ones
# are text.
# usage: PROGRAM --help | awk -v name=piae-dt-split -v command='piae-dt split' -v version=0.1.0 -v date=2026-01-31 \
#        -f packaging/man.awk

BEGIN {
  program = command
  sub(/.* /, "", program)
  section = "summary"
}

# Text as it stands: no backslash, no hyphen that becomes a dash, no request at the beginning of a line.
function plain(text) {
  gsub(/\\/, "\\e", text)
  gsub(/-/, "\\-", text)
  gsub(/\^/, "\\(ha", text)
  gsub(/~/, "\\(ti", text)
  gsub(/`/, "\\(ga", text)
  gsub(/'/, "\\(aq", text)
  sub(/^\./, "\\\\\\&.", text)
  return text
}

# "split --records r.h5" is typed as "piae-dt split --records r.h5".
function typed(line) {
  if (line == program || index(line, program " ") == 1) sub(/^[^ ]+/, command, line)
  return line
}

function heading(title) {
  if (section == "Example") print ".fi\n.RE"
  print ".SH " toupper(title)
  section = title
}

# An entry waits for the line after it, which may hold its text.
function end_entry(text,    line, name_ends) {
  line = waiting
  waiting = ""
  if (line == "") return
  if (text == "") {
    # Texts of options start in column 39. CLI11 2.4 leaves two spaces within a name, "[0]  REQUIRED".
    name_ends = section != "Stages" && substr(line, 38, 2) ~ /^ [^ ]$/ ? 38 : match(line, /[^ ]  /) ? RSTART : 38
    text = substr(line, name_ends + 1)
    line = substr(line, 1, name_ends)
    sub(/^ +/, "", text)
    sub(/ +$/, "", line)
  }
  sub(/^ +/, "", line)
  print ".TP"
  print "\\fB" plain(substr(line, 1, match(line " ", / /) - 1)) "\\fR" plain(substr(line, match(line " ", / /)))
  print plain(text)
}

section == "summary" && !/^Usage: / {
  summary = summary (summary == "" ? "" : " ") $0
  next
}
section == "summary" {
  what = summary
  sub(/( \(|[,.:;] ).*/, "", what)
  sub(/\.$/, "", what)
  printf ".TH \"%s\" 1 \"%s\" \"piae-dt %s\" \"PIAE-DT\"\n", toupper(name), date, version
  heading("Name")
  print plain(name) " \\- " plain(tolower(substr(what, 1, 1)) substr(what, 2))
  heading("Synopsis")
  sub(/^Usage: /, "")
  print plain(typed($0))
  next
}
section == "Synopsis" && /^ / {
  sub(/^ +/, "")
  print ".br"
  print plain($0)
  next
}
section == "Synopsis" {
  heading("Description")
  print plain(summary)
}
waiting != "" && substr($0, 1, 38) ~ /^ +$/ && substr($0, 39, 1) ~ /[^ ]/ {
  end_entry(substr($0, 39))
  next
}
{ end_entry("") }
/^ *$/ { next }
/^Exit codes: / {
  heading("Exit status")
  sub(/^Exit codes: /, "")
  print plain($0)
  next
}
/^[A-Z][A-Za-z ]*:$/ {
  heading(substr($0, 1, length($0) - 1))
  if (section == "Example") print ".RS 4\n.nf"
  next
}
section == "Example" {
  sub(/^  /, "")
  print plain(typed($0))
  next
}
/^  [^ ]/ {
  waiting = $0
  next
}
{
  sub(/^ +/, "")
  print plain($0)
}
END {
  end_entry("")
  heading("See also")
  print name == "piae-dt" ? pages : ".BR piae\\-dt (1)"
}
