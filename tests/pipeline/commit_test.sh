#!/bin/bash
# packaging/commit.cmake: the commit that artefacts record says if the sources differ from it.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

commit_of() { # folder
  cat >name.cmake <<CMAKE
include($project/packaging/commit.cmake)
name_commit($PWD/$1 commit)
message("commit: \${commit}.")
CMAKE
  cmake -P name.cmake 2>&1
}

in_sources() { git -C sources -c user.name=t -c user.email=t@example.org "$@" >/dev/null; }

test_a_commit_is_marked_if_tracked_files_differ() {
  export GIT_CEILING_DIRECTORIES=$PWD
  mkdir sources
  expect_equal "$(commit_of sources)" "commit: ."
  in_sources init
  echo 1 >sources/tracked
  in_sources add tracked
  in_sources commit -m one
  local commit
  commit=$(git -C sources rev-parse --short=12 HEAD)
  echo 1 >sources/untracked
  expect_equal "$(commit_of sources)" "commit: $commit."
  echo 2 >sources/tracked
  expect_equal "$(commit_of sources)" "commit: $commit-changed."
  in_sources commit -am two
  expect_equal "$(commit_of sources)" "commit: $(git -C sources rev-parse --short=12 HEAD)."
}

run_tests "$@"
