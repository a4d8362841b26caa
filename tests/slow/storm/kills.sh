#!/bin/bash
# Kills random processes of a small grid while it runs (make, plan, pipeline/*.sh, stages; by kill -9, a third of the
# times after a SIGTERM that makes a training write its checkpoint), and repeats the same command. A finished grid must
# hold exactly the bytes of an undisturbed one; it is then restarted until there were enough kills. Checkpoints must
# never be damaged or ignored.
# usage: tests/slow/storm/kills.sh FOLDER COUNT SEED BIN
set -uo pipefail

project=$(realpath "${BASH_SOURCE[0]%/*}/../../..")
mkdir -p "$1"
folder=$(realpath "$1") count=$2 seed=$3 bin=$(realpath "$4")
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES DATA_DIR
export OMP_NUM_THREADS=1
RANDOM=$seed

rm -rf "$folder"
mkdir "$folder"
cp -r "$project"/{Makefile,pipeline} "$folder"
mkdir "$folder/results"
ln -s "$project/results/published" "$folder/results/published"
run=$folder/results/r
# Smaller than the paper's experiment: a grid takes half a minute, mostly for trainings.
sed -i -E 's/^epochs = .*/epochs = 60/; s/^width = .*/width = 64/; s/^(windows-per-class) = .*/\1 = 150/
  s/^(test-per-class) = .*/\1 = 40/' "$folder/pipeline/protocol.toml"
sed -i -E 's/^(records_per_class) = .*/\1 = 10/' "$folder/pipeline/datasets/simulated-small.toml"
# A few kills need only half of it.
seeds='0 1'
((count >= 8)) || seeds=0

grid=(make -C "$folder" -j2 cells "BIN=$bin" RUN=r DATASETS=simulated-small RATIOS='100to1 10to1' SEEDS="$seeds"
  METHODS='none smote vae wgan-gp piae-dt piae-dt-phase')

missed=0
miss() {
  echo "kills: $1" >&2
  missed=$((missed + 1))
}

# Prints the processes of the run: only make, plan, scripts and stages work in this folder.
processes() {
  local link
  for link in /proc/[0-9]*/cwd; do
    [[ $(readlink "$link" 2>/dev/null) != "$folder" ]] || { link=${link%/cwd} && echo "${link#/proc/}"; }
  done
}
gone() { ! kill -0 "$1" 2>/dev/null; }

checkpoints() { find "$run" -name '*.checkpoint' 2>/dev/null; }

# A checkpoint is complete at any moment, and a restarted training continues from it.
look_at_checkpoints() {
  local file said
  for file in $(checkpoints); do
    cp "$file" "$folder/checked" 2>/dev/null || continue # the training has just ended
    said=$("$bin/verify" "$folder/checked" 2>&1) || miss "$file is damaged after a kill: $said"
  done
  rm -f "$folder/checked"
}

kill_one() {
  local victims victim name
  mapfile -t victims < <(processes)
  ((${#victims[@]})) || return 1
  victim=${victims[RANDOM % ${#victims[@]}]}
  name=$(cat "/proc/$victim/comm" 2>/dev/null) || return 1
  # Excludes this script's own helpers and processes that are about to end.
  case $name in
    make | run.sh | step.sh | plan | simulate | split | train | generate | score | diagnose) ;;
    *) return 1 ;;
  esac
  if [[ $name == train ]] && ((RANDOM % 3)); then
    kill -TERM "$victim" 2>/dev/null
    sleep "0.00$((RANDOM % 10))"
  fi
  kill -KILL "$victim" 2>/dev/null || return 1
  killed[$name]=$((${killed[$name]:-0} + 1))
}

# Ends a round: compares with what the same command makes undisturbed.
finish_round() {
  local difference
  "${grid[@]}" >"$folder/log" 2>&1 || miss "the repeated command ends with $?: $(tail -n 3 "$folder/log")"
  wait_for_all
  "${grid[@]}" -q >/dev/null 2>&1 || miss "steps are still due: $("${grid[@]}" -n 2>&1 | head -n 3)"
  difference=$(diff -r --exclude='*.log' --exclude=.journal "$folder/one" "$run") ||
    miss "differs from an undisturbed run: ${difference:0:500}"
  difference=$(diff <(cd "$folder/one" && find . | sort) <(cd "$run" && find . | sort)) ||
    miss "files differ from those of an undisturbed run: ${difference:0:500}"
  ! difference=$(grep -rE 'damaged|starts again' "$run" --include='*.log') ||
    miss "a checkpoint was lost: ${difference:0:500}"
  resumed=$((resumed + $(grep -rl 'going on from' "$run" --include='*.log' | wc -l)))
  rounds=$((rounds + 1))
  rm -rf "$run"
}
wait_for_all() { while [[ $(processes) ]]; do sleep 0.05; done; }

declare -A killed=()
started=$SECONDS
"${grid[@]}" >"$folder/log" 2>&1 || {
  echo "kills: the undisturbed run fails: $(tail -n 3 "$folder/log")" >&2
  exit 2
}
mv "$run" "$folder/one"
echo "kills: the undisturbed grid takes $((SECONDS - started)) s" >&2

kills=0 rounds=0 resumed=0 told=$SECONDS
while ((kills < count)); do
  "${grid[@]}" >"$folder/log" 2>&1 &
  make=$!
  while ((kills < count)); do
    sleep "$((RANDOM % 2)).$((RANDOM % 10))"
    ! gone "$make" || break
    kill_one && kills=$((kills + 1)) && look_at_checkpoints
    # make may survive: it stops at the failed step, or the command is repeated while it runs.
    ((RANDOM % 2)) || break
  done
  ((RANDOM % 4)) || gone "$make" || while ! gone "$make"; do sleep 0.1; done
  if ((SECONDS - told > 20)); then
    told=$SECONDS
    echo "kills: $kills of $count, $missed missed," \
      "$(((SECONDS - started) * (count - kills) / (kills + 1) / 60)) minutes left" >&2
  fi
  # Compares a finished grid and restarts it.
  if gone "$make" && wait "$make"; then finish_round; fi
done
finish_round
list=
for name in "${!killed[@]}"; do list+=", ${killed[$name]} $name"; done
echo "kills: killed ${list#, }; $rounds grids compared, $resumed trainings continued from a checkpoint"
echo "kills: $kills done, 0 refused, $((kills - missed)) accepted, $missed missed"
((missed == 0))
