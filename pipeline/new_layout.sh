#!/bin/bash
# Moves the cells of a run from before 0.1.0 to the present layout. The paper's classifier, wdcnn, had its files in the
# folder of the ratio; now it has a folder there, as all others: 10to1/diagnosis.h5 becomes 10to1/wdcnn/diagnosis.h5.
# Moving keeps file times, so make does not recompute the cells. A second call changes nothing.
# usage: pipeline/new_layout.sh results/RUN...
set -euo pipefail

refuse() { # exit code, line
  echo "new_layout.sh: $2" >&2
  exit "$1"
}
(($#)) || refuse 2 "no run is given; name its folder, such as results/paper"

for run; do
  compgen -G "${run%/}/*/seed*/" >/dev/null ||
    refuse 65 "$run: is not a run, because it does not have a folder DATASET/seedK; name one such as results/paper"
done

# Lists RUN/DATASET/seedK/METHOD/RATIO, and one folder deeper for the cells of sweeps and interpretations.
cells_of_before() { # run
  find -L "${1%/}/" -mindepth 5 -maxdepth 6 -type f -regextype posix-extended \
    -regex '.*/seed[0-9]+/([^/]+/){1,2}[0-9]+to1/(diagnosis\.h5|diagnose\.log|(features|classifier)\.(h5|log))(\.checkpoint)?' -print0
}

status=0
for run; do
  moved=0
  while IFS= read -r -d '' file; do
    folder=${file%/*}/wdcnn
    if [[ -e $folder/${file##*/} ]]; then
      echo "new_layout.sh: $file: exists in $folder, too; remove one of the two" >&2
      status=65
      continue
    fi
    mkdir -p "$folder"
    mv "$file" "$folder"
    moved=$((moved + 1))
  done < <(cells_of_before "$run")
  echo "$run: $moved files moved"
done
exit "$status"
