# Counts the tests in ctest's JUnit report, names those that failed, and says why some were skipped.
# The last line is "N passed, N failed, N skipped"; exits with 1 unless something passed and nothing
# failed. What ctest could not even start counts as failed.
# usage: awk -f tests/count.awk tests.xml

function quoted(line, key,    rest) {
  rest = substr(line, index(line, key "=\"") + length(key) + 2)
  return substr(rest, 1, index(rest, "\"") - 1)
}

function plain(text) {
  gsub(/&lt;/, "<", text)
  gsub(/&gt;/, ">", text)
  gsub(/&quot;/, "\"", text)
  gsub(/&apos;/, "'", text)
  gsub(/&amp;/, "\\&", text)
  return text
}

/<testcase / {
  name = plain(quoted($0, "name"))
  status = quoted($0, "status")
  reason = ""
}
/<skipped message="SKIP_/ { status = "skipped" }
reason_follows && reason == "" { reason = plain($0) }
{ reason_follows = /: Skipped$/ }

/<\/testcase>/ {
  if (status == "run") passed++
  else if (status == "skipped") { skipped++; skipped_for[reason == "" ? "no reason given" : reason]++ }
  else { failed++; print "failed: " name }
}

END {
  for (reason in skipped_for) print "skipped: " skipped_for[reason] " (" reason ")"
  print passed + 0 " passed, " failed + 0 " failed, " skipped + 0 " skipped"
  exit !(passed > 0 && failed == 0)
}
