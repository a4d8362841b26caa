#!/bin/bash
# Computes all of results/reference with today's programs and settings, part by part, and stores each part when it is
# done. Skips the parts that results/reference/parts.csv has from the same programs and settings. Can be stopped at any
# moment; the same command continues. Runs carry the commit in their name, because rebuilt programs alone do not make a
# step run again.
# usage: pipeline/reference_all.sh MAKE      with DATA_DIR and BIN in the environment, as the Makefile sets them
set -euo pipefail

make=$1
list=results/reference/parts.csv
clock=results/.reference # seconds of each attempt at a part

all_of_paper="none dynamics smote vae wgan-gp piae-dt ae physics piae-dt-cnn piae-dt-rnn piae-dt-tcn \
  piae-dt-transformer oversample shift piae-dt-phase strike-twin oracle"
diffusion="ddpm ddpm-angle ddpm-healthy ddpm-healthy-angle flow flow-angle"
rivals="none dynamics smote vae wgan-gp piae-dt ae physics oversample shift piae-dt-phase strike-twin mixup \
  aligned-mixup spectral adasyn borderline-smote $diffusion oracle"
speeds="hit-sm-1200to900 hit-sm-1200to600 hit-sm-600to1200"
sizes="cwru-sizes-7 cwru-sizes-14 cwru-sizes-21"
types_zero="cwru-types-zero hit-sm-types-zero uestc-types-zero uestc-true-types-zero"
short_zero="cwru-types-zero-1024 hit-sm-types-zero-1024"
one_speed="hit-sm-types-zero-600 hit-sm-types-zero-900 hit-sm-types-zero-1200"
other_speed="hit-sm-types-1200to600 hit-sm-types-1200to900"
adapting="wdcnn-orders dann cdan"

names() { compgen -G "pipeline/datasets/$1.toml" | sed 's#.*/##; s#\.toml$##' | xargs; } # of data sets, by a pattern
run() { "$make" "${@:2}" RUN="$1-$commit" DATA_DIR="$DATA_DIR" BIN="$BIN"; } # run, target, variable...
store() { run "$1" reference "${@:2}"; }
store_tables() { # run, variable...: in a folder with the run's name, of the figures only those of cost
  store "$@" REFERENCE="results/reference/$1"
  find "results/reference/$1" -path '*/figures/*' ! -name 'cost*' -delete
}

# ---- the parts, each below two hours on two cores -----------------------------------------------
cwru() {
  run paper all DATASETS=cwru METHODS="$all_of_paper"
  run paper sweep DATASETS=cwru METHODS=piae-dt SEEDS="0 1 2 3 4"
  run paper identify
  compare_splits cwru
  run paper contrast DATASETS="cwru cwru-as-published" METHODS="none piae-dt shift"
  store paper
  store paper PROTOCOL=blocked
}
hit-sm() {
  run paper all DATASETS=hit-sm METHODS="$all_of_paper"
  compare_splits hit-sm
  store paper
  store paper PROTOCOL=blocked
}
compare_splits() { # data set
  run paper contrast DATASETS="$1" METHODS="none smote piae-dt piae-dt-phase shift oracle"
  for protocol in random blocked; do
    run paper trust PROTOCOL=$protocol DATASETS="$1" METHODS="none shift" RATIOS="100to1 1to1" CLASSIFIERS="wdcnn nearest"
  done
}
readings() {
  run readings readings
  # Only tables: `make check` does not compare readings.
  pipeline/keep_shown.sh "results/readings-$commit" results/reference/readings/random
}
conditions-speeds() {
  run conditions transfer DATASETS="$speeds"
  run conditions transfer PROTOCOL=blocked DATASETS="$speeds" METHODS="none shift resample randomise strike-twin"
  store conditions
  store conditions PROTOCOL=blocked
}
conditions-sizes() {
  run conditions transfer DATASETS="$sizes"
  store conditions
}
conditions-uestc() {
  run conditions transfer DATASETS="$(names 'uestc-[0-9]*to*') $(names 'uestc-true-[0-9]*to*')"
  store conditions
  # A single picture of all rigs, whose other tables are stored.
  local all=results/reference/random
  pipeline/figures/draw.sh "results/conditions-$commit/rigs.csv" $all/transfer@{sizes,speeds,uestc-speeds,uestc-true-speeds}.csv
  cp "results/conditions-$commit/rigs.svg" $all
}
zero() {
  local rules="envelope-rule exclusion-rule" networks="wdcnn wdcnn-spectrum wdcnn-envelope wdcnn-spectra"
  "$BIN/teach" --config pipeline/protocol.toml --output results/reference/any-bearing.h5
  run zero all PROTOCOL=blocked RATIOS="100to1 1to1" DATASETS="$types_zero $short_zero" \
    METHODS="none healthy-plus-impulses piae-dt-zero oracle" CLASSIFIERS="$rules symptom-net nearest"
  run zero all PROTOCOL=blocked RATIOS=1to1 DATASETS=cwru-types-zero \
    METHODS="healthy-plus-impulses piae-dt-zero" CLASSIFIERS="$networks"
  run zero all PROTOCOL=blocked RATIOS="100to1 1to1" DATASETS="$one_speed" METHODS="none piae-dt-zero" \
    CLASSIFIERS="$rules symptom-net"
  run zero all PROTOCOL=blocked DATASETS="$types_zero $other_speed" METHODS=none CLASSIFIERS="$rules any-bearing"
  run zero all PROTOCOL=blocked RATIOS=100to1 DATASETS=cwru-types-five METHODS=none \
    CLASSIFIERS="wdcnn-spectra symptom-net nearest"
  run zero verdicts CLASSIFIERS="$rules symptom-net nearest any-bearing $networks"
  store zero
  store zero PROTOCOL=blocked
}
rivals-cwru() { rivals cwru; }
rivals-hit-sm() { rivals hit-sm; }
rivals() { # data set
  run rivals all DATASETS="$1" METHODS="$rivals"
  store_tables rivals
}
rivals-conditions() { # adds the quality and cost of windows for another speed and for other sizes
  run rivals all DATASETS="$speeds $sizes" METHODS="none shift strike-twin $diffusion oracle" SEEDS="0 1 2 3 4" \
    RATIOS="100to1 1to1" CLASSIFIERS="wdcnn-orders nearest-orders"
  store_tables rivals
}
classifiers() {
  run classifiers all DATASETS="cwru hit-sm" METHODS="none shift strike-twin aligned-mixup spectral" \
    CLASSIFIERS="prototypes nearest-orders wdcnn-orders"
  store_tables classifiers
}
# Without overlaps, because dann and cdan see windows of D.
adaptation-uestc() {
  run classifiers tables PROTOCOL=blocked DATASETS="uestc-800to1200 uestc-1200to800 uestc-1000to1400" \
    SEEDS="0 1 2 3 4" RATIOS="100to1 1to1" CLASSIFIERS="nearest-orders $adapting" \
    METHODS="none shift strike-twin $diffusion"
  store_tables classifiers PROTOCOL=blocked
}
adaptation() {
  run classifiers transfer PROTOCOL=blocked DATASETS="$speeds $sizes" METHODS="none shift strike-twin" \
    CLASSIFIERS="nearest-orders $adapting"
  run classifiers tables PROTOCOL=blocked DATASETS="cwru-types-zero hit-sm-types-zero" RATIOS=1to1 \
    METHODS="healthy-plus-impulses piae-dt-zero" CLASSIFIERS="$adapting symptom-net"
  store_tables classifiers PROTOCOL=blocked
}

# Measures the effect of each part of our twins, on the tuning seeds.
effects() {
  local seeds="100 101 102 103 104"
  run effects tables DATASETS="$speeds $sizes" METHODS="none strike-twin" RATIOS="100to1 1to1" SEEDS="$seeds" \
    CLASSIFIERS=wdcnn-spectra
  run effects sweep DATASETS="$speeds $sizes" METHODS=strike-twin SEEDS="$seeds"
  run effects tables PROTOCOL=blocked DATASETS=cwru-types-zero METHODS="none piae-dt-zero" RATIOS="100to1 1to1" \
    SEEDS="$seeds" CLASSIFIERS=symptom-net
  run effects sweep PROTOCOL=blocked DATASETS=cwru-types-zero METHODS=piae-dt-zero SEEDS="$seeds"
  store effects REFERENCE=results/reference/effects
  store effects PROTOCOL=blocked REFERENCE=results/reference/effects
}

# ---- which parts are due ------------------------------------------------------------------------
parts=(cwru hit-sm conditions-speeds conditions-sizes conditions-uestc zero readings rivals-cwru rivals-hit-sm
  rivals-conditions classifiers adaptation adaptation-uestc effects)
decisive=(CMakeLists.txt src stages pipeline/protocol.toml pipeline/bearings.csv pipeline/datasets)

# Sources inside another repository have a prefix there.
[[ $(git rev-parse --show-prefix --is-shallow-repository 2>/dev/null | xargs) == false ]] || {
  echo "reference-all: needs a whole clone by git, of its own, because the results name the commit of the programs" >&2
  exit 1
}
[[ ! $(git status --porcelain -- "${decisive[@]}") ]] || {
  echo "reference-all: programs or settings differ from their last commit; commit them, so that the results can name it" >&2
  exit 1
}
commit=$(git log -1 --abbrev=8 --format=%h -- "${decisive[@]}")
# Virtual machines hide the exact name.
processor=$(awk -F '\t+: ' '!seen[$1]++ { has[$1] = $2 }
  END { print has["model name"] " family " has["cpu family"] " model " has["model"] }' /proc/cpuinfo)
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
  pipeline/sums.sh
  echo "reference-all: $part is stored, $minutes min"
done
awk -F, 'NR > 1 { all += $NF } END { printf "reference-all: all parts together %.1f h\n", all / 60 }' "$list"
