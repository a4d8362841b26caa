#!/bin/bash
# The closing line of `make test`.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

case_of() { # name, status, inside
  printf '\t<testcase name="%s" classname="x" time="0" status="%s">\n%s\n\t</testcase>\n' "$@"
}

count() { awk -f "$project/tests/count.awk" report.xml; }

skipped='<skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/>
<system-out>a_test.cpp:3: Skipped
DATA_DIR is not set, so there are no &quot;recordings&quot;
</system-out>'

test_all_passed() {
  { case_of A run "" && case_of B run "" && case_of C notrun "$skipped"; } >report.xml
  expect_equal "$(count)" "$(printf '%s\n' \
    'skipped: 1 (DATA_DIR is not set, so there are no "recordings")' '2 passed, 0 failed, 1 skipped')"
  expect_exit 0 count
}

test_failed_and_not_started_are_failures() {
  {
    case_of A run ""
    case_of 'B&lt;int&gt;' fail '<failure message=""/>'
    case_of C notrun '<skipped message="Unable to find executable"/>'
  } >report.xml
  expect_equal "$(count || true)" "$(printf '%s\n' 'failed: B<int>' 'failed: C' '1 passed, 2 failed, 0 skipped')"
  expect_exit 1 count
}

test_fails_if_no_test_ran() {
  case_of A notrun "$skipped" >report.xml
  expect_exit 1 count
}

room() { # name, cases of Google Test's report
  mkdir -p rooms
  printf '<?xml version="1.0"?>\n<testsuites>\n<testsuite name="S">\n%s\n</testsuite>\n</testsuites>\n' "$2" >"rooms/$1.xml"
}

count_with_rooms() { awk -f "$project/tests/count.awk" rooms/*.xml report.xml; }

good='<testcase name="Good" status="run" result="completed" time="0" classname="S" />'
bad='<testcase name="Bad" status="run" result="completed" time="0" classname="S">
  <failure message="a_test.cpp:3&#x0A;Expected: &lt;1"><![CDATA[a]]></failure>
  <failure message="a_test.cpp:4&#x0A;Expected: 2"><![CDATA[b]]></failure>
</testcase>'
without_data='<testcase name="Real" status="run" result="skipped" time="0" classname="S">
  <skipped message="a_test.cpp:3&#x0A;no &quot;recordings&quot;&#x0A;"><![CDATA[a_test.cpp:3
no "recordings"]]></skipped>
</testcase>'

test_counts_tests_of_a_room_one_by_one() {
  room twin "$good"$'\n'"$without_data"
  room nets "$good"$'\n'"$bad"
  { case_of A run "" && case_of room.twin run "" && case_of room.nets fail ""; } >report.xml
  expect_equal "$(count_with_rooms || true)" "$(printf '%s\n' 'failed: S.Bad' \
    'skipped: 1 (no "recordings")' '3 passed, 1 failed, 1 skipped')"
  expect_exit 1 count_with_rooms
}

test_a_room_without_a_report_failed() {
  room twin "$good"
  { case_of room.twin run "" && case_of room.nets fail "" && case_of room.phase notrun ""; } >report.xml
  expect_equal "$(count_with_rooms || true)" "$(printf '%s\n' 'failed: room.nets' 'failed: room.phase' \
    '1 passed, 2 failed, 0 skipped')"
}

test_a_room_that_crashed_after_its_report_failed() {
  room twin "$good"
  case_of room.twin fail "" >report.xml
  expect_equal "$(count_with_rooms || true)" "$(printf '%s\n' 'failed: room.twin' \
    '1 passed, 1 failed, 0 skipped')"
}

test_names_the_ten_slowest_tests_slowest_first() {
  local number
  for number in {1..12}; do
    printf '\t<testcase name="T%d" classname="x" time="%d.25" status="run">\n' "$number" "$number"
  done >report.xml
  printf '\t<testcase name="Slow" classname="x" time="100.5" status="run">\n' >other.xml
  expect_equal "$(awk -f "$project/tests/slowest.awk" report.xml other.xml)" "the slowest tests, in seconds:
$(printf '%8.1f  %s\n' 100.5 Slow 12.2 T12 11.2 T11 10.2 T10 9.2 T9 8.2 T8 7.2 T7 6.2 T6 5.2 T5 4.2 T4)"
}

test_refuses_an_invalid_patience() {
  local patience
  for patience in 0 -1 1.5 much; do
    expect_equal "$(PIAE_TEST_PATIENCE=$patience "$project/tests/run.sh" quick 2>&1 || echo "exit $?")" \
      "PIAE_TEST_PATIENCE: a whole number from 1, not '$patience'"$'\n'"exit 2"
  done
}

run_tests "$@"
