# shellcheck shell=bash source-path=SCRIPTDIR disable=SC2119,SC2120
# A grid of two data sets, for tests that source this; includes all of support.sh. Its functions are mostly called
# without their optional arguments, which shellcheck (SC2119) would report.
source "${BASH_SOURCE[0]%/*}/support.sh"

# Uses two data sets, to distinguish what belongs to one of them.
describe() {
  rm -f pipeline/datasets/*
  printf 'name = "real"\nsha256 = "#1" # a comment\n' >pipeline/datasets/real.toml
  printf 'name = "made"\n[simulation]\nnoise = 0.1\n' >pipeline/datasets/made.toml
  cat >pipeline/protocol.toml <<'TOML'
[split]
window = 1024  # samples
[train]
epochs = 200
[train.smote]
neighbours = 4
[train.piae-dt]
depth = [
  # layers
  3,
]
[generate]
count = 495
[score]
kernels = 5
[diagnose]
epochs = 50
TOML
}

grid() {
  make --silent all BIN=fake RUN=t DATASETS="real made" METHODS="none smote piae-dt" \
    RATIOS="100to1 10to1 1to1" SEEDS="0 1" "$@"
}

finished_grid() {
  describe
  grid >/dev/null 2>&1
  rm calls
}
