#!/bin/bash
# packaging/commit.cmake: the commit that artefacts record says if the sources differ from it.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

# Prints the project's script as it is in git: in an archive the commit has replaced the placeholder.
# shellcheck disable=SC2016 # git expands the placeholder
script() { sed -E 's/^(set\(COMMIT_OF_ARCHIVE ")[^"]*/\1$Format:%H$/' "$project/packaging/commit.cmake"; }

commit_of() { # folder, the script there (default: the project's)
  script >commit.cmake
  cat >name.cmake <<CMAKE
include(${2:-$PWD/commit.cmake})
name_commit($PWD/$1 commit)
message("commit: \${commit}.")
CMAKE
  cmake -P name.cmake 2>&1
}

in_sources() { git -C sources -c init.defaultBranch=main -c user.name=t -c user.email=t@example.org "$@" >/dev/null; }

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

test_an_archive_carries_its_commit() {
  export GIT_CEILING_DIRECTORIES=$PWD
  mkdir -p sources/packaging unpacked
  script >sources/packaging/commit.cmake
  cp "$project/.gitattributes" sources
  in_sources init
  in_sources add .
  in_sources commit -m one
  git -C sources archive HEAD | tar --extract --directory unpacked
  expect_equal "$(commit_of unpacked "$PWD/unpacked/packaging/commit.cmake")" \
    "commit: $(git -C sources rev-parse --short=12 HEAD)."
}

run_tests "$@"
