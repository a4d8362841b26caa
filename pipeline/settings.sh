#!/bin/bash
# Keeps the settings of a run in small files, one for each stage, method and data set, and rewrites
# a file only when the settings in it have changed. They are the prerequisites by which make knows
# what to do again, and also what the stages read: what is compared is what is used. Comments and
# spacing are left out, so that changing those changes nothing.
#
# usage: pipeline/settings.sh FOLDER 'FILE|SOURCE.toml|TABLE TABLE...|OPTIONS'...
# No tables: the whole source. OPTIONS are command line options that count as settings, too.
set -euo pipefail

# A table that says like = "NAME" stands on top of that one beside it, which then counts, too.
values_of() { # source, tables
  local values like
  values=$(awk -v wanted="$2" -f "${0%/*}/tables.awk" "$1") || return
  like=$(sed -n 's/^like *= *"\(.*\)"$/\1/p' <<<"$values")
  if [[ -n $like ]]; then
    values=$(awk -v wanted="$2 ${2%% *}.$like" -f "${0%/*}/tables.awk" "$1") || return
  fi
  printf '%s' "$values"
}

folder=$1
for specification in "${@:2}"; do
  IFS='|' read -r file source tables options <<<"$specification"
  file=$folder/$file
  text="# Made from $source; edit that file, not this one."
  [[ -z $options ]] || text+=$'\n'"# Options given by make: $options"
  values=$(values_of "$source" "$tables")
  text+=${values:+$'\n'$values}
  [[ -f $file && $(<"$file") == "$text" ]] && continue
  mkdir -p "${file%/*}"
  printf '%s\n' "$text" >"$file.partial"
  mv "$file.partial" "$file"
done
