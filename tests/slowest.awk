# Names the ten slowest tests in ctest's reports, with their seconds.
# usage: awk -f tests/slowest.awk build/tests-TIER.xml...
function value(key,    rest) {
  rest = substr($0, index($0, " " key "=\"") + length(key) + 3)
  return substr(rest, 1, index(rest, "\"") - 1)
}

/<testcase / { seconds[value("name")] = value("time") + 0 }

END {
  print "the slowest tests, in seconds:"
  for (place = 1; place <= 10; ++place) {
    slowest = ""
    for (name in seconds) if (slowest == "" || seconds[name] > seconds[slowest]) slowest = name
    if (slowest == "") break
    printf "%8.1f  %s\n", seconds[slowest], slowest
    delete seconds[slowest]
  }
}
