#!/bin/bash
# Measures how make, status, tables, figures and the report grow with a grid: seconds, and the largest memory of one
# process, for 10^3, 10^4 and 10^5 steps. Growth is the ratio of processor times between successive numbers of steps,
# because other programs on the machine change the elapsed time. The steps compute nothing: fill_run writes small, valid
# outputs, so the measurement shows what the project adds to any grid. The line below the table gives the cost of a
# step in addition to its stage.
# usage: tests/bench/scale/scale.sh PROGRAMS [DATASETSxSEEDS...]     from the project's folder; 1x10 10x10 10x100
set -euo pipefail
export LC_ALL=C
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES

refuse() {
  echo "scale.sh: $1; usage: tests/bench/scale/scale.sh PROGRAMS [DATASETSxSEEDS...], such as build/bin 1x10 10x10" >&2
  exit 2
}
(($#)) || refuse "name the folder of the programs"
[[ -x $1/fill_run ]] || refuse "there is no $1/fill_run (\`make bench-scale\` builds it)"
programs=$(realpath "$1")
shift
sizes=("$@")
(($#)) || sizes=(1x10 10x10 10x100)
for size in "${sizes[@]}"; do
  [[ $size =~ ^[1-9][0-9]*x[1-9][0-9]*$ ]] || refuse "'$size' is not a size"
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp -r Makefile pipeline jobs "$scratch"
mkdir "$scratch/results" "$scratch/programs" "$scratch/nothing"
cp -r results/published "$scratch/results"
cd "$scratch"

for program in plan status tabulate figures report; do ln -s "$programs/$program" programs; done
# A stage that only creates its files, so that only the cost of a step remains.
cat >nothing/stage <<'STAGE'
#!/bin/sh
while [ $# -gt 1 ]; do
  case $1 in
    --output) : >"$2" ;;
    --) shift && for file; do : >"$file"; done ;;
    --output-dir) for role in A B C D; do : >"$2/$role.h5"; done ;;
  esac
  shift
done
echo "stage: nothing done"
STAGE
chmod +x nothing/stage
for stage in simulate split train generate score diagnose; do ln -s stage "nothing/$stage"; done
ln -s "$programs/plan" nothing

describe() { # data sets
  local name
  for name; do
    sed "s/^name = .*/name = \"$name\"/" pipeline/datasets/simulated-small.toml >"pipeline/datasets/$name.toml"
  done
}

# Prints the number of due steps of a goal, and writes the settings files.
count_steps() { # goal, variables of make
  env GOALS="$1" "${@:2}" programs/plan --format make | grep -c 'pipeline/step\.sh' || true
}

# Makes the outputs of the cells' steps.
fill() { # variables of make
  env GOALS=cells "$@" "$programs/fill_run"
  (($(count_steps cells "$@") == 0)) || {
    echo "scale.sh: after fill_run plan would still run: $(env GOALS=cells "$@" programs/plan --looks)" >&2
    exit 1
  }
}

measure() { # name, command...
  command time --quiet --format='%e %U %S %M' --output=used "${@:2}" >output 2>&1 || {
    cat output >&2
    exit 1
  }
  # Columns: seconds elapsed, processor time, MB.
  awk -v OFS='\t' -v name="$1" -v count="$count" \
    '{ print name, count, $1, $2 + $3, int($4 / 1000) }' used | tee -a measured >&2
}

cores=$(env -u OMP_NUM_THREADS nproc)
: >measured
for size in "${sizes[@]}"; do
  mapfile -t datasets < <(seq -f 'scale%g' "${size%x*}")
  describe "${datasets[@]}"
  variables=(RUN="$size" DATASETS="${datasets[*]}" SEEDS="$(seq -s ' ' 0 $((${size#*x} - 1)))" BIN=programs)
  count=$(count_steps tables "${variables[@]}")
  fill "${variables[@]}"
  rm -f "results/$size/.journal"
  measure 'a copied run' make cells "${variables[@]}" # every artefact is read
  measure 'nothing to do' make cells "${variables[@]}"
  measure 'status' make status "${variables[@]}"
  measure 'tables' make -j"$cores" tables "${variables[@]}"
  measure 'figures' make -j"$cores" figures RUN="$size" BIN=programs
  measure 'report' make -j"$cores" report RUN="$size" BIN=programs
  printf 'report.html, MB\t%s\t\t\t%s\n' "$count" \
    "$(awk "BEGIN { printf \"%.1f\", $(stat --format=%s "results/$size/report.html") / 1e6 }")" >>measured
done

# One row per measure, one column per number of steps.
printf '\n%s\n' "seconds elapsed (of processor time), MB of the largest process; ${cores} cores"
awk -F '\t' '{
    if (!($2 in seen)) { seen[$2]; counts[++columns] = $2 }
    if (!($1 in known)) { known[$1]; names[++rows] = $1 }
    elapsed[$1, $2] = $3; used[$1, $2] = $4; memory[$1, $2] = $5
  }
  END {
    printf "%-16s", "steps"
    for (c = 1; c <= columns; ++c) printf "%21s", counts[c]
    print (columns > 1 ? "  growth" : "")
    for (r = 1; r <= rows; ++r) {
      printf "%-16s", names[r]
      for (c = 1; c <= columns; ++c) {
        key = names[r] SUBSEP counts[c]
        if (elapsed[key] == "") printf "%21s", memory[key]
        else printf "%21s", sprintf("%.2f (%.2f) %4d", elapsed[key], used[key], memory[key])
      }
      growth = ""
      for (c = 2; c <= columns; ++c) {
        before = used[names[r], counts[c - 1]]
        if (before > 0) growth = growth sprintf(" x%.1f", used[names[r], counts[c]] / before)
      }
      print " " growth
    }
  }' measured

# Cost of make and the shell for each step, in addition to its stage.
user_and_system() { # command...
  command time --quiet --format='%U %S' --output=used "$@" >/dev/null
  awk '{ print $1 + $2 }' used
}
alone() { for ((i = 0; i < $1; ++i)); do nothing/stage --output made; done; }
export -f alone
variables=(RUN=steps DATASETS=scale1 SEEDS="0 1" BIN=nothing)
make records "${variables[@]}" >/dev/null
count=$(count_steps cells "${variables[@]}")
printf '\nbeside its stage a step takes %s ms of processor time (of %s steps that compute nothing)\n' \
  "$(awk "BEGIN { printf \"%.1f\", 1000 * ($(user_and_system make cells "${variables[@]}") - \
    $(user_and_system bash -c "alone $count")) / $count }")" "$count"
