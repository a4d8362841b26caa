#!/bin/bash
# Draws one figure: turns NAME.csv into NAME.svg and NAME.pdf next to it, by pipeline/figures/SCRIPT.gp. SCRIPT is the
# name of the figure, or the part of it before the last "@".
# With tables, NAME.csv is first made of their rows, behind a column `part`: what follows the "@" in a table's name.
# usage: pipeline/figures/draw.sh FOLDER/NAME.csv [TABLE.csv...]
set -euo pipefail
export TZ=UTC LC_ALL=C.UTF-8 # the same bytes everywhere

for program in gnuplot qpdf; do
  command -v $program >/dev/null || {
    echo "figures: $program is not installed; \`make deps\` installs it (package ${program/gnuplot/gnuplot-nox})" >&2
    exit 69
  }
done
csv=$1
tables=("${@:2}")
name=$(basename "$csv" .csv)
scripts=$(dirname "$0")
script=$scripts/${name%@*}.gp
part=$([[ $name != *@* ]] || echo "${name##*@}")
# A killed drawing leaves its folder.
find "$(dirname "$csv")" -maxdepth 1 -name '.drawing.*' -mmin +60 -exec rm -rf {} +
partial=$(mktemp -d "$(dirname "$csv")/.drawing.XXXXXX")
trap 'rm -rf "$partial"' EXIT

if ((${#tables[@]} > 0)); then
  awk 'FNR == 1 { part = FILENAME; sub(/.*@/, "", part); sub(/[.]csv$/, "", part)
                  if (NR == 1) print "part," $0
                  next }
       { print part "," $0 }' "${tables[@]}" >"$partial/joined"
  mv -T "$partial/joined" "$csv"
fi

# Collects the distinct words of each column of words, in order, for gnuplot's string variables. Ratios are sorted from
# 100to1 to 1to1, then everything else: not every method has every ratio.
words=$(awk -F, '
  function by_ratio(list,    word, n, i, j, moved) {
    n = split(list, word, " ")
    for (i = 2; i <= n; ++i) {
      moved = word[i]
      for (j = i; j > 1 && word[j - 1] + 0 < moved + 0; --j) word[j] = word[j - 1]
      word[j] = moved
    }
    list = word[1]
    for (i = 2; i <= n; ++i) list = list " " word[i]
    return list
  }
  NR == 1 { for (i = 1; i <= NF; ++i) column[i] = $i; columns = NF; next }
  { for (i = 1; i <= columns; ++i) if ($i != "" && !((i, $i) in seen)) {
      seen[i, $i]; all[i] = all[i] (all[i] == "" ? "" : " ") $i
      if ($i !~ /^[-+]?[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?$/) wordy[i] } }
  # Seeds are words although they are digits; so are names of classes, which may be digits.
  END { for (i = 1; i <= columns; ++i) if (i in wordy || column[i] ~ /^(seed|class|truth|predicted)$/)
          printf "words_%s = \"%s\"\n", column[i], column[i] == "ratio" ? by_ratio(all[i]) : all[i] }' "$csv")

# A script with a line "# rows by: COLUMN" finds the rows of each word of that column in a file of their own,
# rows_of(word). Otherwise a figure of many curves would spend most of its time on searching rows.
rows_by=$(sed -nE 's/^# rows by: (.+)$/\1/p' "$script")
[[ -z $rows_by ]] || awk -F, -v by="$rows_by" -v folder="$partial" '
  NR == 1 { for (i = 1; i <= NF; ++i) if ($i == by) column = i; header = $0; next }
  { file = folder "/" $column ".csv"
    if (!(file in started)) { print header >file; started[file] }
    print >file }' "$csv"

# A script with another height than 600 has a line "# height: EXPRESSION", which may count words. The script gets it as
# `height`.
height=$(sed -nE 's/^# height: (.+)$/\1/p' "$script")
height=$(gnuplot - <<<"$words
load '$scripts/style.gp'
set print '-'
print int(${height:-600})")
for format in svg pdf; do
  case $format in
    svg) terminal="svg size 960,$height dynamic font 'DejaVu Sans,13' linewidth 1.2 background rgb 'white'" ;;
    pdf) terminal="pdfcairo size 20cm,$(awk "BEGIN { print $height / 48 }")cm font 'DejaVu Sans,9' linewidth 1.2" ;;
  esac
  # Hide gnuplot's warnings about series without points, such as missing published values, and about values that are all
  # equal.
  gnuplot -e "data = '$csv'; scripts = '$scripts'; format = '$format'; height = $height; part = '$part'; rows_of(word) = '$partial/'.word.'.csv'" - <<<"$words
set terminal $terminal
set output '$partial/$format'
load scripts.'/style.gp'
load '$script'
unset output" 2> >(grep -vE 'Skipping data file with no valid points|empty [xy] range|^$' >&2)
done
# The same numbers must give the same bytes, but a PDF holds its time of drawing, on Debian 13 in compressed form.
# Replace it by a time of the same length.
qpdf --object-streams=disable --static-id "$partial/pdf" "$partial/plain"
LC_ALL=C sed -i -E '/\/CreationDate \(D:/ s/D:[0-9]{14}/D:20000101000000/' "$partial/plain"
mv -T "$partial/plain" "${csv%.csv}.pdf"
awk -f "$scripts/shorten.awk" "$partial/svg" >"$partial/short"
mv -T "$partial/short" "${csv%.csv}.svg"
