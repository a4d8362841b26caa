#!/bin/bash
# clang-tidy finds nothing (.clang-tidy says what it looks for) in what changed; with LINT=all in all
# files. A file takes 5 to 40 s, so what does not fit into three minutes is left to LINT=all.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

program=$(clang_tool tidy)
configure
results=$configured/tidy
rm -rf $results
mkdir -p $results

# For a header the source of the same name, from which clang-tidy looks into it; where there is none, the
# first beside it that includes it, whose include folders are the right ones; or else the header itself.
sources_of() {
  local file user
  while read -r file; do
    if [[ $file == *.hpp ]]; then
      user=${file%.hpp}.cpp
      [[ -e $user ]] || user=$(grep -lsF "\"${file#*/}\"" "${file%/*}"/*.cpp | head -n 1 || true)
      file=${user:-$file}
    fi
    echo "$file"
  done
}

# Of the files on standard input those that are compiled here, each with what clang-tidy needs beside: with
# Debian 12's clang LibTorch's headers compile with LLVM's C++ library alone, and others with GCC's alone.
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
    # It says what it found as errors; without any it could not look.
    grep -q ' error: ' "$results/$1.out" || echo "$2:1: clang-tidy failed: $(head -n 1 "$results/$1.err")"
}

started=$(date +%s) seconds=
[[ ${LINT:-} == all ]] || (($#)) || seconds=180
export -f check
export program configured results started seconds

mapfile -t files < <(files_to_check '^(src|stages|tests)/.*\.(cpp|hpp)$' "$@" | sources_of | sort -u | checks)
if [[ ! -d /usr/lib/llvm-$clang_version/include/c++/v1 ]]; then
  say "libc++-dev is not installed, so files that include LibTorch are left out"
  mapfile -t files < <(printf '%s\n' "${files[@]}" | grep -v 'stdlib=libc++$')
fi
((${#files[@]})) || exit 0
# shellcheck disable=SC2016
printf '%s\n' "${files[@]}" | nl -w1 -s' ' | xargs -P "$cores" -L 1 bash -c 'check "$@"' check

left_out=$(find $results -name '*.left_out' | wc -l)
((left_out == 0)) || say "$left_out of ${#files[@]} files did not fit into three minutes; LINT=all looks at all"
# A finding in a header comes once for each file that includes it.
cat $results/*.out | sed "s,^$PWD/,," | sed -nE 's/^([^: ]+:[0-9]+):[0-9]+: (error|warning): /\1: /p' | sort -u
