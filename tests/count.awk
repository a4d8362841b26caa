# Counts the tests in the reports of the rooms' programs (Google Test's) and in ctest's, names those
# that failed, and says why some were skipped. The last line is "N passed, N failed, N skipped"; exits
# with 1 unless something passed and nothing failed. What could not even start counts as failed.
# usage: awk -f tests/count.awk build/tests-of-rooms/ROOM.xml... build/tests.xml

function quoted(line, key,    rest) {
  rest = substr(line, index(line, " " key "=\"") + length(key) + 3)
  return plain(substr(rest, 1, index(rest, "\"") - 1))
}

function plain(text) {
  gsub(/&lt;/, "<", text)
  gsub(/&gt;/, ">", text)
  gsub(/&quot;/, "\"", text)
  gsub(/&apos;/, "'", text)
  gsub(/&#x0A;/, "\n", text)
  gsub(/&amp;/, "\\&", text)
  return text
}

# Uses the report of ctest on a whole room only if the report of the room itself is missing.
function is_known(name,    room) {
  room = substr(name, 6)
  return name ~ /^room\./ && (status == "fail" ? room_failed[room] : room_passed[room])
}

function count() {
  if (is_known(name)) return
  if (status == "run") { passed++; room_passed[of_room]++ }
  else if (status == "skipped") { skipped++; room_passed[of_room]++; skipped_for[reason == "" ? "no reason given" : reason]++ }
  else { failed++; room_failed[of_room]++; print "failed: " name }
}

FNR == 1 {
  of_room = FILENAME
  gsub(/.*\/|\.xml$/, "", of_room)
}

/<testcase / {
  by_google = / result="/
  name = (by_google ? quoted($0, "classname") "." : "") quoted($0, "name")
  status = quoted($0, "status")
  reason = ""
  if (/\/>$/) count()
}
by_google && /<failure / { status = "fail" }
by_google && /<skipped / {
  status = "skipped"
  reason = quoted($0, "message")
  sub(/^[^\n]*\n/, "", reason)
  sub(/\n+$/, "", reason) # newer versions end it with one
}
/<skipped message="SKIP_/ { status = "skipped" }
reason_follows && reason == "" { reason = plain($0) }
{ reason_follows = /: Skipped$/ }

/<\/testcase>/ { count() }

END {
  for (reason in skipped_for) print "skipped: " skipped_for[reason] " (" reason ")"
  print passed + 0 " passed, " failed + 0 " failed, " skipped + 0 " skipped"
  exit !(passed > 0 && failed == 0)
}
