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

test_nothing_run_is_no_success() {
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

test_tests_of_a_room_count_one_by_one() {
  room twin "$good"$'\n'"$without_data"
  room nets "$good"$'\n'"$bad"
  { case_of A run "" && case_of room.twin run "" && case_of room.nets fail ""; } >report.xml
  expect_equal "$(count_with_rooms || true)" "$(printf '%s\n' 'failed: S.Bad' \
    'skipped: 1 (no "recordings")' '3 passed, 1 failed, 1 skipped')"
  expect_exit 1 count_with_rooms
}

test_room_that_left_no_report_failed() {
  room twin "$good"
  { case_of room.twin run "" && case_of room.nets fail "" && case_of room.phase notrun ""; } >report.xml
  expect_equal "$(count_with_rooms || true)" "$(printf '%s\n' 'failed: room.nets' 'failed: room.phase' \
    '1 passed, 2 failed, 0 skipped')"
}

test_room_that_crashed_after_its_report_failed() {
  room twin "$good"
  case_of room.twin fail "" >report.xml
  expect_equal "$(count_with_rooms || true)" "$(printf '%s\n' 'failed: room.twin' \
    '1 passed, 1 failed, 0 skipped')"
}

run_tests "$@"
