#!/bin/bash
# Writes the manual pages of the installed command and of its stages, from what they say with --help.
# usage: packaging/man.sh PREFIX DATE      (they go to PREFIX/share/man/man1)
set -euo pipefail
export LC_ALL=C

prefix=$1 date=$2
folder=$prefix/share/man/man1
version=$("$prefix/bin/piae-dt" --version)
version=${version#piae-dt }
mkdir -p "$folder"

page() { # name, command, further variables of awk...
  awk -v name="$1" -v command="$2" -v version="${version% (*}" -v date="$date" "${@:3}" -f "${0%/*}/man.awk" |
    gzip --no-name -9 >"$folder/$1.1.gz"
}

see_also=
for program in "$prefix"/lib/piae-dt/*; do
  stage=${program##*/}
  [[ $stage != *-libtorch ]] || continue
  "$program" --help | page "piae-dt-$stage" "piae-dt $stage"
  see_also+="${see_also:+,\\n}.BR piae\\\\-dt\\\\-$stage (1)"
done
COLUMNS=1000 "$prefix/bin/piae-dt" --help | page piae-dt piae-dt -v pages="$see_also"
