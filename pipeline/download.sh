#!/bin/bash
# Downloads the recordings of data sets from the official addresses in their descriptions, checks their sha256 sums, and
# resumes after an interruption. Simulated data sets do not have recordings.
# usage: pipeline/download.sh DATA_DIR DATASET...      (BIN in the environment: folder of the programs)
set -euo pipefail

data_dir=$1
[[ $data_dir != -* ]] || data_dir=./$data_dir
shift

is_right() { [[ -f $1 ]] && echo "$2  $1" | sha256sum --check --status; }

give_up() { # file, sha256, what happened
  echo "data: $1: $3. Run the same command to continue, or put the file there by hand (sha256 $2)," \
    "or name a folder that has the recordings: DATA_DIR=..." >&2
  exit 1
}

# A link planted in the folder must not redirect the download.
require_inside() { # file, sha256
  [[ $(realpath -m "${1%/*}")/ == "$(realpath -m "$data_dir")"/* ]] ||
    give_up "$1" "$2" "its folder is a link out of $data_dir, so nothing is downloaded to it"
  [[ ! -L $1 && ! -L $1.part ]] || give_up "$1" "$2" "it or its .part is a link, so nothing is written"
  local there
  for there in "$1" "$1.part"; do
    [[ ! -e $there || -f $there ]] || give_up "$1" "$2" "$there is not a regular file; remove it"
  done
}

# Largest size of a recording (src/raw/limits.hpp). curl checks the size that the site announces; the shell checks the
# received bytes and ends curl with SIGXFSZ, which is 25. A transfer below 1 kB/s for 20 s is given up.
largest_bytes=4000000000
too_large=63 # curl's exit code for it
download() { # file, url
  { ulimit -f $((largest_bytes / 1024)) || :; } 2>/dev/null
  exec curl --fail --location --silent --show-error --retry 3 --connect-timeout 20 \
    --speed-limit 1000 --speed-time 20 --max-filesize $largest_bytes \
    --proto =http,https --proto-redir =http,https --globoff --continue-at - --output "$1" --url "$2"
}

fetch() { # file, sha256, url
  local file=$1 sum=$2 url=$3 part=$1.part message status=0
  require_inside "$file" "$sum"
  mkdir -p "${file%/*}" || give_up "$file" "$sum" "its folder cannot be created"
  if ! is_right "$part" "$sum"; then
    echo "data: $file from $url"
    message=$(download "$part" "$url" 2>&1) || status=$?
    if ((status == too_large || status == 128 + 25)); then
      rm -f "$part" # useless for resuming
      message="more than $largest_bytes bytes"
    fi
    ((status == 0)) ||
      give_up "$file" "$sum" "could not be downloaded from $url (${message##*$'\n'})"
  fi
  if ! is_right "$part" "$sum"; then
    rm -f "$part"
    give_up "$file" "$sum" "the file from $url is not the described recording"
  fi
  mv -T "$part" "$file"
}

for dataset in "$@"; do
  sources=$("$BIN/ingest" --sources --description "pipeline/datasets/$dataset.toml" --data-dir "$data_dir" |
    awk '!seen[$0]++')
  [[ $sources ]] || continue
  there=0 fetched=0 missing=()
  # "sha256  file  url", separated by two spaces; "-" for a missing sum or address.
  while read -r line; do
    sum=${line%%  *} url=${line##*  } file=${line#*  }
    file=$data_dir/${file%  *}
    if [[ $sum == - && -f $file ]] || is_right "$file" "$sum"; then
      there=$((there + 1))
    elif [[ $sum == - || $url == - ]]; then
      missing+=("$file")
    else
      fetch "$file" "$sum" "$url"
      fetched=$((fetched + 1))
    fi
  done <<<"$sources"
  echo "data: $dataset: $fetched files fetched, $there existed"
  if ((${#missing[@]})); then
    echo "data: $dataset: no official address for ${missing[*]}: put them there by hand," \
      "or name a folder that has the recordings: DATA_DIR=..." >&2
    exit 1
  fi
done
