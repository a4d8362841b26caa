#!/bin/bash
# clang-tidy must find nothing (.clang-tidy lists its checks) in what changed; with LINT=all in all files. A file takes
# 5 to 40 s, so files that do not fit into three minutes are left to LINT=all.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

program=$(clang_tool tidy)
configure
results=$configured/tidy
rm -rf $results
mkdir -p $results

# Prints the sources to check for a header: the source of the same name, which includes it; else the first file next to
# it that includes it, since it has the right include folders, or what checks that file; else the header itself.
sources_of() {
  local file user
  while read -r file; do
    for _ in {1..9}; do # includes may form a ring
      [[ $file == *.hpp ]] || break
      user=${file%.hpp}.cpp
      [[ -e $user ]] || user=$(grep -lsF "\"${file#*/}\"" "${file%/*}"/*.cpp "${file%/*}"/*.hpp | head -n 1 || true)
      file=${user:-$file}
    done
    echo "$file"
  done
}

# Selects the compiled files on standard input, with the additional options for clang-tidy: with Debian 12's clang,
# LibTorch's headers compile only with LLVM's C++ library, and other files only with GCC's.
checks() {
  awk -F'\t' -v has_libtorch="$has_libtorch" '
    FNR == NR { command[$1] = $2; next }
    {
      is_header = /\.hpp$/
      torch = is_header ? /^(src|tests\/slow)\/libtorch\// : command[$1] ~ /torch\/csrc\/api\/include/
    }
    is_header ? has_libtorch || !torch : command[$1] != "" {
      print $1 (torch ? " -extra-arg=-stdlib=libc++" : "")
    }' <(compile_commands) -
}

check() { # number, file, [argument]
  if [[ -n $seconds ]] && (($(date +%s) - started > seconds)); then
    touch "$results/$1.left_out"
    return
  fi
  "$program" -quiet -p "$configured" "${@:3}" "$2" >"$results/$1.out" 2>"$results/$1.err" ||
    # Findings are errors; without one, clang-tidy itself failed.
    grep -q ' error: ' "$results/$1.out" || echo "$2:1: clang-tidy failed: $(head -n 1 "$results/$1.err")"
}

started=$(date +%s) seconds=
[[ ${LINT:-} == all ]] || (($#)) || seconds=180
export -f check
export program configured results started seconds

mapfile -t files < <(files_to_check '^(src|stages|tests)/.*\.(cpp|hpp)$' "$@" | sources_of | sort -u | checks)
if [[ ! -d /usr/lib/llvm-$clang_version/include/c++/v1 ]]; then
  say "libc++-dev is not installed, so files that include LibTorch are left out"
  mapfile -t files < <(printf '%s\n' "${files[@]}" | grep -vE '^$|stdlib=libc[+][+]$')
fi
((${#files[@]})) || exit 0
# shellcheck disable=SC2016
printf '%s\n' "${files[@]}" | nl -w1 -s' ' | xargs -P "$cores" -L 1 bash -c 'check "$@"' check

left_out=$(find $results -name '*.left_out' | wc -l)
((left_out == 0)) || say "$left_out of ${#files[@]} files did not fit into three minutes; LINT=all checks all"
# A finding in a header appears once for each file that includes the header.
cat $results/*.out | sed "s,^$PWD/,," | sed -nE 's/^([^: ]+:[0-9]+):[0-9]+: (error|warning): /\1: /p' | sort -u
