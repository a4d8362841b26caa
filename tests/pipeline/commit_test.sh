#!/bin/bash
# packaging/commit.cmake: the commit that artefacts record says if the sources differ from it, and the day is its day.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

# Prints the project's script as it is in git: in an archive the commit and its day have replaced the placeholders.
# shellcheck disable=SC2016 # git expands the placeholders
script() {
  sed -E 's/^(set\(COMMIT_OF_ARCHIVE ")[^"]*/\1$Format:%H$/; s/^(set\(DAY_OF_ARCHIVE ")[^"]*/\1$Format:%cs$/' \
    "$project/packaging/commit.cmake"
}

commit_and_day_of() { # folder, the script there (default: the project's)
  script >commit.cmake
  cat >name.cmake <<CMAKE
include(${2:-$PWD/commit.cmake})
name_commit($PWD/$1 commit)
name_day($PWD/$1 day)
message("commit: \${commit}, of \${day}.")
CMAKE
  cmake -P name.cmake 2>&1
}

# Commits are of a day of their own.
export GIT_AUTHOR_DATE='2026-01-31 12:00' GIT_COMMITTER_DATE='2026-01-31 12:00'
in_sources() { git -C sources -c init.defaultBranch=main -c user.name=t -c user.email=t@example.org "$@" >/dev/null; }
head_of_sources() { git -C sources rev-parse --short=12 HEAD; }

test_a_commit_is_marked_if_tracked_files_differ() {
  export GIT_CEILING_DIRECTORIES=$PWD
  mkdir sources
  expect_equal "$(commit_and_day_of sources)" "commit: , of $(date --utc +%F)."
  in_sources init
  echo 1 >sources/tracked
  in_sources add tracked
  in_sources commit -m one
  echo 1 >sources/untracked
  expect_equal "$(commit_and_day_of sources)" "commit: $(head_of_sources), of 2026-01-31."
  echo 2 >sources/tracked
  expect_equal "$(commit_and_day_of sources)" "commit: $(head_of_sources)-changed, of 2026-01-31."
  in_sources commit -am two
  expect_equal "$(commit_and_day_of sources)" "commit: $(head_of_sources), of 2026-01-31."
}

test_an_archive_carries_its_commit() {
  mkdir -p sources/packaging
  script >sources/packaging/commit.cmake
  cp "$project/.gitattributes" sources
  in_sources init
  in_sources add .
  in_sources commit -m one
  local archived
  archived="commit: $(head_of_sources), of 2026-01-31."
  mkdir sources/unpacked # within a clone whose own commit is another one
  git -C sources archive HEAD | tar --extract --directory sources/unpacked
  GIT_COMMITTER_DATE='2026-02-01 12:00' in_sources commit --allow-empty -m two
  expect_equal "$(commit_and_day_of sources/unpacked "$PWD/sources/unpacked/packaging/commit.cmake")" "$archived"
}

run_tests "$@"
