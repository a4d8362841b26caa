#!/bin/bash
# clang-tidy finds nothing (.clang-tidy says what it looks for) in what changed; with LINT=all in all
# files. A file takes 5 to 40 s, so what does not fit into ten minutes is left to LINT=all.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

program=$(clang_tool tidy)
configure
results=$configured/tidy
rm -rf $results
mkdir -p $results

# For a header the file of the same name, or else one that includes it: clang-tidy looks into our
# headers from there.
sources_of() {
  local file
  while read -r file; do
    if [[ $file == *.cpp ]]; then
      echo "$file"
    elif [[ -e ${file%.hpp}.cpp ]]; then
      echo "${file%.hpp}.cpp"
    else
      files_matching '\.cpp$' | xargs grep -lF "#include \"${file#*/}\"" | head -n 1 || true
    fi
  done
}

# Of the sources on standard input those that are compiled, each with what clang-tidy needs beside: with
# Debian 12's clang LibTorch's headers compile with LLVM's C++ library alone, and others with GCC's alone.
checks() {
  awk -F'\t' '
    FNR == NR { command[$1] = $2; next }
    $1 in command {
      print $1 (command[$1] ~ /torch\/csrc\/api\/include/ ? " -extra-arg=-stdlib=libc++" : "")
    }' <(compile_commands) -
}

check() { # number, file, [argument]
  if [[ -n $seconds ]] && (($(date +%s) - started > seconds)); then
    touch "$results/$1.left_out"
    return
  fi
  "$program" -quiet -p "$configured" "${@:3}" "$2" >"$results/$1.out" 2>"$results/$1.err" ||
    # It says what it found as errors; without any it could not look.
    grep -q ' error: ' "$results/$1.out" || { echo "$2:1: clang-tidy failed:" && cat "$results/$1.err"; }
}

started=$(date +%s) seconds=
[[ ${LINT:-} == all ]] || (($#)) || seconds=600
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
((left_out == 0)) || say "$left_out of ${#files[@]} files did not fit into ten minutes; LINT=all looks at all"
# A finding in a header comes once for each file that includes it.
cat $results/*.out | sed "s,^$PWD/,," | sed -nE 's/^([^: ]+:[0-9]+):[0-9]+: (error|warning): /\1: /p' | sort -u
