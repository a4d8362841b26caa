#!/bin/bash
# Each rule of `make lint` must find its violations in a copy of the project that was clean before.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

# Copies all files of the project, committed or not, into a separate repository.
copy_of_project() {
  local inside # of a clone: empty at its top
  if ! inside=$(cd "$project" && git rev-parse --show-prefix 2>&1) || [[ $inside ]]; then
    skip "because git knows no files of $project: $inside"
  fi
  mkdir copy
  (cd "$project" && git ls-files -z --cached --others --exclude-standard) |
    while IFS= read -r -d '' file; do [[ ! -f $project/$file ]] || printf '%s\0' "$file"; done |
    (cd "$project" && xargs -0 cp --parents --target-directory="$OLDPWD/copy")
  cd copy
  git init --quiet
}

found=
lint() { # rule, [file...]
  local code=0
  found=$(pipeline/lint.sh "$@" 2>&1) || code=$?
  [[ $found != *'skipped, because'* ]] || skip "$(grep 'skipped, because' <<<"$found")"
  return $code
}

expect_clean() { # rule, [file...]
  lint "$@" || fail "$found"
  expect_line "$found" "^lint: $1 0 -- 0 findings$"
}

expect_finding() { # line, rule, [file...]
  local code=0
  lint "${@:2}" || code=$?
  ((code == 1)) || fail "expected exit code 1, got $code: $found"
  expect_line "$found" "$1"
  expect_line "$found" "^lint: $2 1 -- 1 findings$"
}

test_a_badly_formatted_file_is_found() {
  copy_of_project
  expect_clean format src/base
  echo 'int  two_spaces;' >>src/base/error.hpp
  expect_finding '^src/base/error.hpp:[0-9]+: .*clang-format -i src/base/error.hpp$' format src/base
}

test_an_unquoted_shell_variable_is_found() {
  copy_of_project
  expect_clean shell jobs
  # shellcheck disable=SC2016
  printf '#!/bin/bash\nrm $1\n' >jobs/careless.sh
  expect_finding '^jobs/careless.sh:2: Double quote' shell jobs
}

# Lines of .ninja_log: start and end in ms, a time, the output.
test_units_that_cost_four_times_the_median_are_named() {
  copy_of_project
  local unity=build/CMakeFiles/piae.dir/Unity stages=CMakeFiles/stage
  mkdir -p $unity
  for unit in base nets text; do printf '#include "a"\n#include "b"\n' >$unity/unity_$unit.cxx; done
  {
    printf '0\t6000\t0\t%s\n' "${unity#build/}"/unity_{base,nets}.cxx.o $stages/{split,score,train}.cpp.o
    printf '0\t25000\t0\t%s\n' "${unity#build/}/unity_text.cxx.o" $stages/verify.cpp.o
    printf '0\t7000\t0\t%s\n' lib/libpiae.a
  } >build/.ninja_log
  expect_clean units
  expect_line "$found" '^lint: units: Unity/unity_text.cxx.o takes 12.5 s a file, the median 3.0 s; '
  expect_line "$found" '^lint: units: .*stage/verify.cpp.o takes 25.0 s, the median 6.0 s; '
  (($(grep -c 'the median' <<<"$found") == 2)) || fail "$found"
}

test_white_space_at_the_end_of_a_line_is_found() {
  copy_of_project
  expect_clean spaces
  echo '// and then ' >>src/base/error.hpp
  expect_finding '^src/base/error.hpp:[0-9]+: ends with white space' spaces
}

test_a_link_to_nothing_and_an_unknown_target_are_found() {
  copy_of_project
  : >docs/glossary.md # else the added words could make all pages together too long
  expect_clean pages
  echo '[gone](docs/nowhere.md)' >>SECURITY.md
  expect_finding '^SECURITY.md:[0-9]+: links to docs/nowhere.md, which is not there' pages
  sed -i '$d' SECURITY.md
  echo '[gone](docs/method.md#nothing)' >>SECURITY.md
  expect_finding '^SECURITY.md:[0-9]+: links to docs/method.md#nothing, but docs/method.md has no such heading' pages
  sed -i '$d' SECURITY.md
  printf '\n    make nonsense\n' >>SECURITY.md
  expect_finding '^SECURITY.md:[0-9]+: make has no target nonsense' pages
}

test_a_page_that_is_too_long_is_found() {
  copy_of_project
  : >docs/glossary.md # else all pages together could be too long, too
  printf 'word %.0s' {1..300} >>SECURITY.md
  expect_finding '^SECURITY.md:1: has [0-9]+ words; 700 at most' pages
}

test_bars_of_tables_count_as_words_and_code_does_not() {
  copy_of_project
  : >docs/glossary.md
  { echo '```' && printf 'word %.0s' {1..300} && printf '\n```\n'; } >>SECURITY.md
  expect_clean pages
  printf '| %.0s' {1..300} >>SECURITY.md
  expect_finding '^SECURITY.md:1: has [0-9]+ words; 700 at most' pages
}

test_pages_that_are_too_long_together_are_found() {
  copy_of_project
  printf 'word %.0s' {1..2000} >>CHANGELOG.md # each version adds to it, so it does not count
  expect_clean pages
  printf 'word %.0s' {1..2000} >>docs/claims.md
  expect_finding '^README.md:1: all pages have [0-9]+ words; 24000 at most' pages
}

test_a_readme_with_too_many_lines_is_found() {
  copy_of_project
  printf '\n%.0s' {1..150} >>README.md
  expect_finding '^README.md:1: has [0-9]+ lines; 150 at most' pages
}

test_awkward_comments_are_found_and_names_in_code_are_not() {
  copy_of_project
  expect_clean english src/base/error.hpp SECURITY.md
  echo '/// Of a WDCNN alone.' >>src/base/error.hpp
  expect_finding '^src/base/error.hpp:[0-9]+: "Of a WDCNN alone."; write: start with a verb or a noun$' english src/base/error.hpp
  sed -i '$d' src/base/error.hpp
  # shellcheck disable=SC2016 # a name in code
  echo 'int beside; // `beside` has a name' >>src/base/error.hpp
  expect_clean english src/base/error.hpp
  echo 'A log stands beside it.' >>SECURITY.md
  expect_finding '^SECURITY.md:[0-9]+: "A log stands beside it."; write: next to, in addition to$' english SECURITY.md
}

test_a_torch_header_elsewhere_is_found() {
  copy_of_project
  expect_clean torch
  sed -i '1i#include <torch/types.h>' src/nets/adam.cpp
  expect_finding '^src/nets/adam.cpp:1: includes LibTorch outside src/libtorch' torch
}

test_an_include_against_the_direction_is_found() {
  copy_of_project
  expect_clean rooms
  sed -i '1i#include "report/tables.hpp"' src/nets/adam.cpp
  expect_finding '^src/nets/adam.cpp:1: includes "report/tables.hpp", but nets stands below report' rooms
}

test_an_include_of_the_same_row_is_found() {
  copy_of_project
  sed -i '1i#include "twin/losses.hpp"' src/diagnosis/wdcnn.cpp
  expect_finding '^src/diagnosis/wdcnn.cpp:1: .* diagnosis and twin stand in one row' rooms
}

test_includes_of_the_room_of_libtorch_are_found() {
  copy_of_project
  sed -i '1i#include "libtorch/nets/adam.hpp"' src/augment/smote.cpp
  expect_finding '^src/augment/smote.cpp:1: includes "libtorch/nets/adam.hpp", but augment stands below libtorch' rooms
}

test_a_room_without_a_row_and_a_row_without_a_folder_are_found() {
  copy_of_project
  # shellcheck disable=SC2016
  sed -i 's/^| `text` /| `texts` /' CONTRIBUTING.md
  expect_exit 1 pipeline/lint.sh rooms
  lint rooms || true
  expect_line "$found" "^CONTRIBUTING.md:[0-9]+: the table has a room 'texts' without a folder"
  expect_line "$found" "^CONTRIBUTING.md:[0-9]+: the room 'text' is not in the table"
}

test_a_helper_with_the_name_of_another_files_function_is_found() {
  copy_of_project
  expect_clean names
  printf '%s\n' 'namespace {' 'int listed(int all) { return all; }' '}  // namespace' >>src/raw/csv.cpp
  expect_finding "^src/raw/csv.cpp:[0-9]+: the helper 'listed' has the name of a function in src/raw/file" names
}

test_a_header_that_does_not_compile_alone_is_found() {
  copy_of_project
  printf '#pragma once\n\ninline std::string name() { return {}; }\n' >src/base/name.hpp
  expect_finding '^src/base/name.hpp:3: does not compile alone: .*include what it uses$' \
    headers src/base/name.hpp src/base/error.hpp
  sed -i '1a#include <string>' src/base/name.hpp
  expect_clean headers src/base/name.hpp src/base/error.hpp
}

test_a_header_is_compiled_again_when_what_it_includes_changed() {
  copy_of_project
  printf '#pragma once\n#include "base/b.hpp"\ninline std::size_t a() { return 0; }\n' >src/base/a.hpp
  printf '#pragma once\n#include <cstddef>\n' >src/base/b.hpp
  expect_clean headers src/base/a.hpp src/base/b.hpp
  printf '#pragma once\n' >src/base/b.hpp
  expect_finding '^src/base/a.hpp:3: does not compile alone' headers src/base/a.hpp src/base/b.hpp
}

test_warnings_of_clang_tidy_are_found() {
  copy_of_project
  # Its own name between quotes looks as if it included itself.
  printf '#pragma once  // "base/nothing.hpp"\n\ninline int* nothing() { return 0; }\n' >src/base/nothing.hpp
  expect_finding '^src/base/nothing.hpp:3: use nullptr' tidy src/base/nothing.hpp
  printf 'int* nothing() { return 0; }\n' >tests/base/nothing_test.cpp
  expect_finding '^tests/base/nothing_test.cpp:1: use nullptr' tidy tests/base/nothing_test.cpp
}

# Its name alone, that of src/twin/contact.cpp, would have it checked without the include folders of LibTorch.
test_a_header_is_checked_through_the_header_that_includes_it() {
  copy_of_project
  local code=0 room=libtorch/twin
  printf '#pragma once\n#include <torch/version.h>\ninline int* nothing() { return 0; }\n' >src/$room/contact.hpp
  printf '#pragma once\n#include "%s/contact.hpp"\n' $room >src/$room/pairs.hpp
  printf '#include "%s/pairs.hpp"\n' $room >src/$room/pairs.cpp
  lint tidy src/$room/contact.hpp || code=$?
  [[ $found != *'are left out'* ]] || skip "$(grep 'are left out' <<<"$found")"
  expect_equal $code 1
  expect_line "$found" "^src/$room/contact.hpp:3: use nullptr"
  expect_line "$found" '^lint: tidy 1 -- 1 findings$'
}

test_an_unknown_rule_and_a_file_that_is_not_there_are_refused() {
  copy_of_project
  expect_exit 2 pipeline/lint.sh spelling
  expect_exit 2 pipeline/lint.sh pages english
}

run_tests "$@"
