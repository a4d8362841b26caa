# Counts the cells of a run and estimates the time left; for pipeline/status.sh.
# usage: awk -v run=results/RUN -v counted=cells -f status.awk DURATIONS STATES CELLS
#   DURATIONS  folder stage seconds        of steps that are done
#   STATES     folder stage state [code]   of steps that are to be done
#   CELLS      files that the tables are made from
#
# A cell is a diagnosis or a score; where models are counted, a model. It is failed or running when its step or one that it waits for is.
# The time of steps that all methods wait for has a line of its own. Times are those of one step after
# the other.

# place[1] data set, place[2] seed, place[3] method, place[4] ratio, place[5] classifier: as many as the folder has.
# What is tried beside the methods (sweep/depth-1/1to1) is together like one of them. A contrast has two runs.
function locate(folder,    other_run, tried) {
  other_run = index(folder, run "/") != 1
  sub("^[^/]*/[^/]*/", "", folder)
  if (match(folder, "/(sweep(@[^/]*)?|readings)/")) {
    tried = substr(folder, RSTART + RLENGTH)
    sub("^[^/]*", "", tried)
    folder = substr(folder, 1, RSTART + RLENGTH - 2) tried
  }
  if (other_run) sub("^[^/]*", "&, blocked", folder)
  return split(folder, place, "/")
}

# Times are those of a ratio and a classifier.
function step_of_method() { return place[4] "/" place[5] }

function learn(key, seconds) {
  sum[key] += seconds
  count[key]++
}

# Seconds that a step takes, by those that are most like it; -1 when none is known. Generators have
# nothing in common, but to diagnose or score takes equally long for all of them.
function estimate(stage, data_set, method, step,    keys, count_of_keys, i) {
  keys[1] = stage SUBSEP data_set SUBSEP method SUBSEP step
  keys[2] = stage SUBSEP SUBSEP method SUBSEP step
  keys[3] = stage SUBSEP data_set SUBSEP SUBSEP step
  keys[4] = stage SUBSEP SUBSEP SUBSEP step
  keys[5] = stage
  count_of_keys = (stage == "train" || stage == "generate") ? 2 : 5
  for (i = 1; i <= count_of_keys; i++) if (keys[i] in count) return sum[keys[i]] / count[keys[i]]
  return -1
}

function duration(seconds) {
  if (seconds < 59.5) return sprintf("%d s", seconds + 0.5)
  if (seconds < 3570) return sprintf("%d min", seconds / 60 + 0.5)
  return sprintf("%d h %02d min", (seconds + 30) / 3600, int((seconds + 30) / 60) % 60)
}

function worst(state, other) {
  return rank[state] >= rank[other] ? state : other
}

function line_of(name) {
  if (!(name in seen)) {
    seen[name] = 1
    lines[++line_count] = name
  }
  return name
}

BEGIN {
  shared = "records, split"
  rank["done"] = 0
  rank["missing"] = 1
  rank["running"] = 2
  rank["failed"] = 3
}

FILENAME == ARGV[1] {
  locate($1)
  learn($2 SUBSEP place[1] SUBSEP place[3] SUBSEP step_of_method(), $3)
  learn($2 SUBSEP SUBSEP place[3] SUBSEP step_of_method(), $3)
  learn($2 SUBSEP place[1] SUBSEP SUBSEP step_of_method(), $3)
  learn($2 SUBSEP SUBSEP SUBSEP step_of_method(), $3)
  learn($2, $3)
}

FILENAME == ARGV[2] {
  depth = locate($1)
  name = place[1] SUBSEP (depth < 3 ? shared : place[3])
  if ($3 == "running") running++
  seconds = estimate($2, place[1], place[3], step_of_method())
  if (seconds < 0) unknown[name]++
  else left[name] += seconds
  # Nothing waits for a score but its own cell.
  if ($2 == "score") score[$1] = $3
  else state[$1] = ($1 in state) ? worst(state[$1], $3) : $3
}

FILENAME == ARGV[3] {
  folder = $1
  sub("/[^/]*$", "", folder)
  locate(folder)
  if ((place[1], shared) in unknown || (place[1], shared) in left) line_of(place[1] SUBSEP shared)
  name = line_of(place[1] SUBSEP place[3])
  result = ($1 ~ /\/score\.h5$/ && folder in score) ? score[folder] : "done"
  while (length(folder) > length(run)) {
    if (folder in state) result = worst(result, state[folder])
    sub("/[^/]*$", "", folder)
  }
  cells[name]++
  number[name, result]++
}

function time_left(name) {
  if (!unknown[name]) return duration(left[name])
  return left[name] ? duration(left[name]) " or more" : "not known yet"
}

function show(data_set, method, cells, finished, running, failed, missing, time) {
  printf "%-*s  %-*s  %6s  %6s  %7s  %6s  %7s  %s\n", width[1], data_set, width[2], method, cells, \
    finished, running, failed, missing, time
}

function show_line(name,    words) {
  split(name, words, SUBSEP)
  show(words[1], words[2], cells[name] + 0, number[name, "done"] + 0, number[name, "running"] + 0, \
    number[name, "failed"] + 0, number[name, "missing"] + 0, time_left(name))
  if (name == "all") return
  cells["all"] += cells[name]
  left["all"] += left[name]
  unknown["all"] += unknown[name]
  for (result in rank) number["all", result] += number[name, result]
}

END {
  width[1] = length("data set")
  width[2] = length("method")
  for (i = 1; i <= line_count; i++) {
    split(lines[i], words, SUBSEP)
    for (k = 1; k <= 2; k++) if (length(words[k]) > width[k]) width[k] = length(words[k])
  }
  show("data set", "method", counted, "done", "running", "failed", "missing", "time left")
  for (i = 1; i <= line_count; i++) show_line(lines[i])
  show_line("all")
  if (running > 1) {
    printf "\n%d steps run at a time: %s left at this rate\n", running, \
      duration(left["all"] / running) (unknown["all"] ? " or more" : "")
  }
}
