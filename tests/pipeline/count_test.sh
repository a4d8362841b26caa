#!/bin/bash
# The closing line of `make test`.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/check.sh"

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

run_tests
