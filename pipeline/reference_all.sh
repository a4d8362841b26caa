#!/bin/bash
# Computes all of results/reference with today's programs and settings, part by part, and stores each part when it is
# done. Skips the parts that results/reference/parts.csv has from the same programs and settings. Can be stopped at any
# moment; the same command continues.
# usage: pipeline/reference_all.sh MAKE      with DATA_DIR and BIN in the environment, as the Makefile sets them
set -euo pipefail

make=$1
list=results/reference/parts.csv
clock=results/.reference # seconds of each attempt at a part

all_of_paper="none dynamics smote vae wgan-gp piae-dt ae physics piae-dt-cnn piae-dt-rnn piae-dt-tcn \
  piae-dt-transformer oversample shift piae-dt-phase strike-twin oracle"
rivals="none dynamics smote vae wgan-gp piae-dt ae physics oversample shift piae-dt-phase strike-twin mixup \
  aligned-mixup spectral adasyn borderline-smote ddpm ddpm-angle ddpm-healthy ddpm-healthy-angle flow flow-angle oracle"
speeds="hit-sm-1200to900 hit-sm-1200to600 hit-sm-600to1200"
sizes="cwru-sizes-7 cwru-sizes-14 cwru-sizes-21"
types_zero="cwru-types-zero hit-sm-types-zero uestc-types-zero uestc-true-types-zero"
short_zero="cwru-types-zero-1024 hit-sm-types-zero-1024"
one_speed="hit-sm-types-zero-600 hit-sm-types-zero-900 hit-sm-types-zero-1200"
other_speed="hit-sm-types-1200to600 hit-sm-types-1200to900"

names() { compgen -G "pipeline/datasets/$1.toml" | sed 's#.*/##; s#\.toml$##' | xargs; } # of data sets, by a pattern
run() { "$make" "$@" DATA_DIR="$DATA_DIR" BIN="$BIN"; }
store() { run reference "$@"; }

# ---- the parts, each below two hours on two cores -----------------------------------------------
cwru() {
  run all DATASETS=cwru METHODS="$all_of_paper"
  run sweep DATASETS=cwru METHODS=piae-dt SEEDS="0 1 2 3 4"
  run identify
  compare_splits cwru
  run contrast DATASETS="cwru cwru-as-published" METHODS="none piae-dt shift"
  store
  store PROTOCOL=blocked
}
hit-sm() {
  run all DATASETS=hit-sm METHODS="$all_of_paper"
  compare_splits hit-sm
  store
  store PROTOCOL=blocked
}
compare_splits() { # data set
  run contrast DATASETS="$1" METHODS="none smote piae-dt piae-dt-phase shift oracle"
  for protocol in random blocked; do
    run trust PROTOCOL=$protocol DATASETS="$1" METHODS="none shift" RATIOS="100to1 1to1" CLASSIFIERS="wdcnn nearest"
  done
}
readings() {
  run readings RUN=readings
  store RUN=readings REFERENCE=results/reference/readings
}
conditions-speeds() {
  run transfer RUN=conditions DATASETS="$speeds"
  run transfer RUN=conditions PROTOCOL=blocked DATASETS="$speeds" METHODS="none shift resample randomise strike-twin"
  store RUN=conditions
  store RUN=conditions PROTOCOL=blocked
}
conditions-sizes() {
  run transfer RUN=conditions DATASETS="$sizes"
  store RUN=conditions
}
conditions-uestc() {
  run transfer RUN=conditions DATASETS="$speeds $sizes $(names 'uestc-[0-9]*to*') $(names 'uestc-true-[0-9]*to*')"
  store RUN=conditions
}
zero() {
  local rules="envelope-rule exclusion-rule" networks="wdcnn wdcnn-spectrum wdcnn-envelope wdcnn-spectra"
  run all RUN=zero PROTOCOL=blocked RATIOS="100to1 1to1" DATASETS="$types_zero $short_zero" \
    METHODS="none healthy-plus-impulses piae-dt-zero oracle" CLASSIFIERS="$rules symptom-net nearest"
  run all RUN=zero PROTOCOL=blocked RATIOS=1to1 DATASETS=cwru-types-zero \
    METHODS="healthy-plus-impulses piae-dt-zero" CLASSIFIERS="$networks"
  run all RUN=zero PROTOCOL=blocked RATIOS="100to1 1to1" DATASETS="$one_speed" METHODS="none piae-dt-zero" \
    CLASSIFIERS="$rules symptom-net"
  run all RUN=zero PROTOCOL=blocked DATASETS="$types_zero $other_speed" METHODS=none CLASSIFIERS="$rules any-bearing"
  run all RUN=zero PROTOCOL=blocked RATIOS=100to1 DATASETS=cwru-types-five METHODS=none \
    CLASSIFIERS="wdcnn-spectra symptom-net nearest"
  run verdicts RUN=zero CLASSIFIERS="$rules symptom-net nearest any-bearing $networks"
  store RUN=zero
  store RUN=zero PROTOCOL=blocked
}
rivals-cwru() { rivals cwru; }
rivals-hit-sm() { rivals hit-sm; }
rivals() { # data set
  run all RUN=rivals DATASETS="$1" METHODS="$rivals"
  store RUN=rivals REFERENCE=results/reference/rivals
}
classifiers() {
  run all RUN=classifiers DATASETS="cwru hit-sm" METHODS="none shift strike-twin aligned-mixup spectral" \
    CLASSIFIERS="prototypes nearest-orders wdcnn-orders"
  store RUN=classifiers REFERENCE=results/reference/classifiers
}
# Without overlaps, because dann and cdan see windows of D.
adaptation() {
  local those="wdcnn-orders dann cdan"
  run transfer RUN=classifiers PROTOCOL=blocked DATASETS="$speeds $sizes" METHODS="none shift strike-twin" \
    CLASSIFIERS="nearest-orders $those"
  run tables RUN=classifiers PROTOCOL=blocked DATASETS="uestc-800to1200 uestc-1200to800 uestc-1000to1400" \
    SEEDS="0 1 2 3 4" RATIOS="100to1 1to1" CLASSIFIERS="nearest-orders $those" \
    METHODS="none shift strike-twin ddpm ddpm-angle ddpm-healthy ddpm-healthy-angle flow flow-angle"
  run tables RUN=classifiers PROTOCOL=blocked DATASETS="cwru-types-zero hit-sm-types-zero" RATIOS=1to1 \
    METHODS="healthy-plus-impulses piae-dt-zero" CLASSIFIERS="$those symptom-net"
  store RUN=classifiers PROTOCOL=blocked REFERENCE=results/reference/classifiers
}

# ---- which parts are due ------------------------------------------------------------------------
parts=(conditions-speeds conditions-sizes rivals-hit-sm adaptation rivals-cwru classifiers cwru hit-sm zero
  conditions-uestc readings)
decisive=(CMakeLists.txt src stages pipeline/protocol.toml pipeline/bearings.csv pipeline/datasets)

[[ ! $(git status --porcelain -- "${decisive[@]}") ]] || {
  echo "reference-all: programs or settings differ from their last commit; commit them, so that the results can name it" >&2
  exit 1
}
commit=$(git log -1 --format=%h -- "${decisive[@]}")
processor=$(sed -nE 's/^model name\s*: //p' /proc/cpuinfo | head -1)
mkdir -p "$clock"
[[ -s $list ]] || echo 'part,commit,processor,minutes' >"$list"

for part in "${parts[@]}"; do
  if grep -q "^$part,$commit," "$list"; then
    echo "reference-all: $part is stored"
    continue
  fi
  time_of=$clock/$part@$commit
  started=$SECONDS
  trap 'echo $((SECONDS - started)) >>"$time_of"' EXIT
  "$part"
  trap - EXIT
  echo $((SECONDS - started)) >>"$time_of"
  minutes=$(awk '{ all += $1 } END { printf "%.0f", all / 60 }' "$time_of")
  { grep -v "^$part," "$list" && echo "$part,$commit,$processor,$minutes"; } >"$list.new"
  mv "$list.new" "$list"
  echo "reference-all: $part is stored, $minutes min"
done
awk -F, 'NR > 1 { all += $NF } END { printf "reference-all: all parts together %.1f h\n", all / 60 }' "$list"
