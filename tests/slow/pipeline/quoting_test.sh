#!/bin/bash
# Values that the shell or make could take for more than text must never be executed.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

recordings() { # folder of the recordings
  rm fake/ingest
  # shellcheck disable=SC2016
  printf '%s\n' '#!/bin/bash' 'printf "<%s>\n" "$@" >options' 'until [[ $1 == --output ]]; do shift; done' \
    'echo records >"$2"; echo "ingest: 1 thing done"' >fake/ingest
  chmod +x fake/ingest
  make --silent records BIN=fake DATASETS=cwru RUN=try "DATA_DIR=$1" >messages 2>&1 || fail "$(<messages)"
  expect_line "$(grep -xF -A 1 "<--data-dir>" options | tail -n 1)" "^<.*>$"
  grep -qxF "<$1>" options || fail "<$1> is not in $(<options)"
}

test_almost_any_folder_name_works() {
  recordings 'my recordings'
  rm -r results
  # shellcheck disable=SC2016
  recordings 'a;b&c|d<e>f(g)*?[h]{i}~!#%=:,"j\k`touch x`'
  [[ ! -e x ]] || fail "a value was executed"
}

test_a_folder_name_that_make_cannot_pass_is_refused() {
  local value
  # shellcheck disable=SC2016
  for value in "it's" 'a$b' '$(shell touch executed)' '`touch executed`$' "';touch executed;'" $'a\nb' \
    $'a\ntouch executed' '-r'; do
    for goal in help records data status all test; do
      expect_equal "$(make "$goal" BIN=fake DATASETS=cwru "DATA_DIR=$value" 2>&1 | wc -l)" 1
      expect_line "$(make "$goal" BIN=fake "DATA_DIR=$value" 2>&1)" "DATA_DIR: .*; (rename the folder|write ./)"
      expect_line "$(DATA_DIR=$value make "$goal" BIN=fake 2>&1)" "DATA_DIR: .*; (rename the folder|write ./)"
      DATA_DIR=$value expect_exit 2 make "$goal" BIN=fake
    done
  done
  [[ ! -e executed ]] || fail "a value was executed"
}

test_an_empty_folder_is_not_the_root() {
  local goal
  for goal in help records data status; do
    expect_equal "$(make "$goal" BIN=fake DATASETS=cwru DATA_DIR= 2>&1 | wc -l)" 1
    expect_line "$(make "$goal" BIN=fake DATA_DIR= 2>&1)" "DATA_DIR: is empty; "
    expect_line "$(DATA_DIR=' ' make "$goal" BIN=fake 2>&1)" "DATA_DIR: is empty; "
  done
}

test_nothing_is_installed_into_a_part_of_a_name() {
  expect_line "$(make --dry-run install PREFIX='here/a b' 2>&1)" 'PREFIX: contains a space, which is not allowed; '
}

test_no_other_value_is_executed() {
  local name value
  for name in RUN DATASETS METHODS RATIOS SEEDS PROTOCOL ARCH LIBTORCH BIN TOLERANCE LINT PREFIX DESTDIR; do
    # shellcheck disable=SC2016
    for value in '0;touch executed' '$(shell touch executed)' '`touch executed`' "0' ; touch executed '" \
      '0 | touch executed' $'0\ntouch executed' '0 >executed'; do
      expect_line "$(make status "$name=$value" 2>&1)" "$name: "
      make status "$name=$value" >/dev/null 2>&1 && fail "$name=$value was taken"
      env "$name=$value" make --dry-run status BIN=fake DATASETS=cwru >/dev/null 2>&1 || true
      [[ ! -e executed ]] || fail "$name=$value was executed"
    done
  done
}

run_tests "$@"
