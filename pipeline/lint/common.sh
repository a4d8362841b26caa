# shellcheck shell=bash disable=SC2034
# Sourced by the rules. Each rule is a script that prints its findings, one a line. It exits with 0 when everything was
# checked, with 77 when it was skipped (with the reason), and with any other code when it failed.
set -euo pipefail
rule=$(basename "$0" .sh)
cores=$(env -u OMP_NUM_THREADS nproc)

say() { echo "lint: $rule: $1" >&2; }

skip() {
  say "skipped, $1"
  exit 77
}

# Lists files whose name matches: tracked by git, or new and not ignored.
files_matching() { # extended regular expression, [file or folder...]
  git ls-files --cached --others --exclude-standard -- "${@:2}" | sort -u |
    while read -r file; do [[ ! -f $file ]] || echo "$file"; done | { grep -E "$1" || true; }
}

# Prints the commit that a change is measured from: the point where the branch left origin/main; on main itself, as in
# continuous integration, or without origin, the commit before. Prints nothing in a clone of depth one.
commit_before_change() {
  local head before
  head=$(git rev-parse --quiet --verify HEAD) || return 0
  before=$(git merge-base origin/main HEAD 2>/dev/null) || before=$head
  [[ $before != "$head" ]] || before=$(git rev-parse --quiet --verify HEAD~1) || return 0
  echo "$before"
}

# Lists the files for a slow rule: the named ones; with LINT=all every file; else the files that changed since that
# commit, committed or not.
files_to_check() { # extended regular expression, [file or folder...]
  local before
  before=$(commit_before_change)
  if (($# > 1)) || [[ ${LINT:-} == all || -z $before ]]; then
    files_matching "$@"
  else
    { git diff --name-only --diff-filter=d "$before" && git ls-files --others --exclude-standard; } |
      sort -u | { grep -E "$1" || true; }
  fi
}

# The required version of clang's tools: other versions format and warn differently.
clang_version=$(sed -nE 's/^# For clang-format ([0-9]+).*/\1/p' .clang-format)

clang_tool() { # format or tidy
  local program
  for program in "clang-$1-$clang_version" "clang-$1"; do
    if "$program" --version 2>/dev/null | grep -q "version $clang_version\."; then
      echo "$program"
      return
    fi
  done
  skip "because it needs clang-$1 $clang_version of Debian 12; other versions find other things"
}

# A folder that is configured but never built, to know how each file is compiled. Clang can neither read GCC's
# precompiled headers nor understand GCC's flag for complex products.
configured=build/lint
configure() {
  mkdir -p $configured
  exec 9>$configured/.lock
  flock 9
  local options=(-S . -B "$configured" -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DPIAE_UNITS=OFF) benches
  for has_libtorch in yes ''; do
    for benches in yes ''; do
      cmake "${options[@]}" "-DPIAE_LIBTORCH=${has_libtorch:-OFF}" "-DPIAE_BENCH=${benches:-OFF}" \
        >$configured/configure.log 2>&1 && break 2
    done
  done || {
    cat $configured/configure.log >&2
    exit 1
  }
  [[ $has_libtorch ]] || say "LibTorch is not installed, so src/libtorch and the tests that need it are left out"
  [[ $benches ]] || say "Google Benchmark is not installed, so tests/bench is left out"
  sed -i 's/ -fcx-limited-range//; s/ --param=avoid-fma-max-bits=0//' $configured/compile_commands.json
  flock --unlock 9
}

# Prints a line for each compiled file: its name, a tab, the command.
compile_commands() {
  awk -v root="$PWD/" '
    /^ *"command": "/ { sub(/^ *"command": "/, ""); sub(/",?$/, ""); command = $0 }
    /^ *"file": "/ {
      sub(/^ *"file": "/, ""); sub(/",?$/, "")
      if (index($0, root) == 1) print substr($0, length(root) + 1) "\t" command
    }' $configured/compile_commands.json
}
