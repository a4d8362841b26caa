# Divides the steps that are to be done among jobs, by what they have cost elsewhere.
# usage: awk -f jobs/plan.awk -v cores=N -v minutes=N -v out=FOLDER [-v papers=METHOD] \
#          [-v gpu_stages="..."] [-v gpu_methods="..."] jobs/costs.csv STEPS
#   STEPS   of jobs/steps.awk
# Writes into FOLDER for each job the files that it makes, in the order in which they are to be begun:
#   records     what all others wait for: the data sets, and their windows
#   cells.N     the steps of some methods and seeds; cells-gpu.N those of them that need a GPU
# and prints a line for each kind of job: name, jobs, cores, minutes and megabytes of each, steps, seconds of
# processor time, with tabs between them; and "unknown", what had to be guessed.
#
# What cannot be divided is a unit: the steps of one method of one seed, which wait for one another. Jobs
# take about the same time: units go, the longest first, to the job that has least to do. No job is of two
# folders under results/, as each folder has a make of its own.

function learn(key, seconds, megabytes) {
  if (seconds > cost[key]) cost[key] = seconds
  if (megabytes > memory[key]) memory[key] = megabytes
}

function max(a, b) { return a > b ? a : b }
function ceiling(x) { return x == int(x) ? x : int(x) + 1 }

# The most that is known to be taken by what is most like it. Generators have nothing in common: of one that
# is not known the longest is taken, and said.
function look_up(stage, dataset, method, ratio,    keys, i) {
  keys[1] = stage SUBSEP dataset SUBSEP method SUBSEP ratio
  keys[2] = stage SUBSEP SUBSEP method SUBSEP ratio
  keys[3] = stage SUBSEP dataset SUBSEP SUBSEP ratio
  keys[4] = stage SUBSEP SUBSEP SUBSEP ratio
  keys[5] = stage
  keys[6] = ""
  for (i = 1; i <= 6; ++i) {
    if (stage == "train" && i > 2 && i < 5) continue
    if (!(keys[i] in cost)) continue
    if (i > 5 || (stage == "train" && i > 2)) unknown[stage (stage == "train" ? " --method " method : "")]
    return keys[i]
  }
  return ""
}

# results/RUN/DATASET/seedK/METHOD, and for what is tried beside the methods one folder more.
function unit_of(    unit, i, last) {
  last = place[5] ~ beside ? 6 : 5
  for (i = 1; i <= last; ++i) unit = unit (i > 1 ? "/" : "") place[i]
  return unit
}

# Each classifier is like a stage of its own.
function stage_by(stage, classifier) { return classifier == "" ? stage : stage " by " classifier }

function is_among(word, words) { return index(" " words " ", " " word " ") > 0 }
function needs_gpu(stage, method) {
  return is_among(stage, gpu_stages) || (is_among(stage, "train generate") && is_among(method, gpu_methods))
}

function add_to_unit(unit, seconds, target) {
  if (!(unit in load)) units[++unit_count] = unit
  load[unit] += seconds
  targets[unit] = targets[unit] target "\n"
  ++steps[unit]
}

# Heap sort is not worth its lines: names are sorted by `sort`, their numbers made equally long.
function sort_units(    command, i, line) {
  if (!unit_count) return
  command = "LC_ALL=C sort -r >'" out "/.units'"
  for (i = 1; i <= unit_count; ++i) printf "%015.3f\t%s\n", load[units[i]], units[i] | command
  close(command)
  for (i = 1; (getline line <(out "/.units")) > 0; ++i) {
    sub(/^[^\t]*\t/, "", line)
    units[i] = line
  }
  close(out "/.units")
  system("rm '" out "/.units'")
}

function kind_of(unit) { return (unit in gpu) ? "cells-gpu" : "cells" }

function divide(    i, group, name, job, k, least) {
  for (i = 1; i <= unit_count; ++i) {
    group = kind_of(units[i]) SUBSEP run[units[i]]
    if (!(group in group_load)) groups[++group_count] = group
    group_load[group] += load[units[i]]
    ++group_units[group]
  }
  for (i = 1; i <= group_count; ++i) {
    split(groups[i], name, SUBSEP)
    wanted = ceiling(group_load[groups[i]] / (cores * minutes * 60))
    if (wanted > 500) wanted = 500 # below MaxArraySize, which is 1001 where nobody has set it
    if (wanted > group_units[groups[i]]) wanted = group_units[groups[i]]
    first_job[groups[i]] = jobs[name[1]] + 0
    jobs[name[1]] = last_job[groups[i]] = jobs[name[1]] + max(wanted, 1)
  }
  for (i = 1; i <= unit_count; ++i) {
    group = kind_of(units[i]) SUBSEP run[units[i]]
    least = first_job[group]
    for (k = least + 1; k < last_job[group]; ++k)
      if (job_load[kind_of(units[i]), k] < job_load[kind_of(units[i]), least]) least = k
    job = kind_of(units[i]) SUBSEP least
    job_load[job] += load[units[i]]
    job_steps[job] += steps[units[i]]
    job_longest[job] = max(job_longest[job], load[units[i]])
    printf "%s", targets[units[i]] >(out "/" kind_of(units[i]) "." least)
  }
}

# Twice what was measured and five minutes, for processors that are slower, in steps of five minutes.
function minutes_for(seconds) { return 5 * ceiling((2 * seconds + 300) / 300) }
# What the programs take, and make, the shells and the file buffers that count as ours.
function megabytes_for(many, most) { return 100 * ceiling((many * most + 300) / 100) }

function show(name, count, many, seconds_each, most, step_count, seconds) {
  printf "%s\t%d\t%d\t%d\t%d\t%d\t%.0f\n", name, count, many, minutes_for(seconds_each), \
    megabytes_for(many, most), step_count, seconds
}

function show_kind(name,    k, job, most_steps, longest, all_steps, seconds, many) {
  if (!jobs[name]) return
  for (k = 0; k < jobs[name]; ++k) most_steps = max(most_steps, job_steps[name, k])
  many = most_steps < cores ? most_steps : cores
  for (k = 0; k < jobs[name]; ++k) {
    job = name SUBSEP k
    longest = max(longest, max(job_load[job] / many, job_longest[job]))
    all_steps += job_steps[job]
    seconds += job_load[job]
  }
  show(name, jobs[name], many, longest, most_megabytes[name], all_steps, seconds)
}

BEGIN {
  FS = "\t"
  # What is tried beside the methods: of the paper's, or of the one that is named.
  beside = "^(sweep|sweep@.*|readings)$"
}

FILENAME == ARGV[1] {
  if ($0 ~ /^#/ || !split($0, c, ",") || c[1] == "stage") next
  # stage, dataset, method, classifier, ratio, seconds, megabytes
  costly = stage_by(c[1], c[4])
  learn(costly SUBSEP c[2] SUBSEP c[3] SUBSEP c[5], c[6], c[7])
  learn(costly SUBSEP SUBSEP c[3] SUBSEP c[5], c[6], c[7])
  learn(costly SUBSEP c[2] SUBSEP SUBSEP c[5], c[6], c[7])
  learn(costly SUBSEP SUBSEP SUBSEP c[5], c[6], c[7])
  learn(costly, c[6], c[7])
  learn("", c[6], c[7])
  next
}

{
  split($1, place, "/")
  stage = $2
  if (stage == "ingest" || stage == "simulate" || stage == "split") {
    key = look_up(stage, place[3], "", "")
    print $4 >(out "/records")
    ++records_steps
    records_seconds += cost[key]
    records_megabytes = max(records_megabytes, memory[key])
  } else if (stage ~ /^(train|generate|score|diagnose|features)$/) {
    unit = unit_of()
    method = $3
    if (method == "") method = (unit in method_of) ? method_of[unit] : place[5]
    if (method ~ beside && !sub(/^sweep@/, "", method)) method = papers
    method_of[unit] = method
    ratio = ""
    costly = stage
    # The training of the features is that of the diagnosis beside it.
    if (stage == "diagnose" || stage == "features") {
      split(substr($1, length(unit) + 2), below, "/") # RATIO/CLASSIFIER
      ratio = below[1]
      costly = stage_by("diagnose", below[2])
    }
    key = look_up(costly, place[3], method, ratio)
    add_to_unit(unit, cost[key], $4)
    run[unit] = place[1] "/" place[2]
    most[unit] = max(most[unit], memory[key])
    if (needs_gpu(stage, method)) gpu[unit]
  } else {
    sub(/@.*/, "", stage)
    key = look_up(stage, place[3], "", "")
    tables_seconds += cost[key]
    tables_megabytes = max(tables_megabytes, memory[key])
    ++tables_steps
  }
}

END {
  sort_units()
  for (i = 1; i <= unit_count; ++i)
    most_megabytes[kind_of(units[i])] = max(most_megabytes[kind_of(units[i])], most[units[i]])
  divide()
  if (records_steps)
    show("records", 1, records_steps < cores ? records_steps : cores, records_seconds, \
      records_megabytes, records_steps, records_seconds)
  show_kind("cells")
  show_kind("cells-gpu")
  show("tables", 1, 1, tables_seconds + 300, max(tables_megabytes, 500), tables_steps, tables_seconds)
  for (name in unknown) print "unknown\t" name | "LC_ALL=C sort"
}
