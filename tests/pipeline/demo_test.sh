#!/bin/bash
# The demo as a newcomer has it: built in a folder of its own, with all methods, tables and sentences.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

test_the_demo_builds_what_it_runs_and_ends_with_one_table_and_two_sentences() {
  ln -s "$project"/{CMakeLists.txt,packaging,src,stages} .
  make demo >messages 2>&1 || fail "$(<messages)"
  [[ ! -e build/bin ]] || fail "built more than the demo runs: $(ls build/bin)"
  local summary=results/demo/simulated-small/summary.txt
  expect_equal "$(tail -n "$(wc -l <$summary)" <(grep -v '^tables and artefacts' messages))" "$(<$summary)"
  expect_equal "$(awk '/^(none|smote|piae-dt|piae-dt-phase|oracle \(ceiling\)) .* [0-9]+\.[0-9]$/' $summary | wc -l)" 6 # none twice
  expect_line "$(<$summary)" '^none by nearest +[0-9]'
  expect_line "$(<$summary)" '^With 45 generated windows of each fault'
  expect_line "$(<$summary)" 'piae-dt gains'
  expect_equal "$(awk 'length > 80' $summary)" ""
}

run_tests "$@"
