# Of what make would run (`make -n`), the steps: folder, stage, method, file, with tabs between them. Make
# shows a long command as several lines. Of a step that makes several files one is named.
# usage: make -n ... | awk -f jobs/steps.awk

# (A stage that has several steps in a folder is called as the log of the step is.)

function option(name,    i) {
  for (i = first; i < NF; ++i) if ($i == name) return $(i + 1)
  return ""
}

function file_of(stage) {
  if (stage == "split") return "A.h5"
  if (stage == "train") return "model.h5"
  if (stage == "generate") return "E.h5"
  if (stage == "diagnose") return "diagnosis.h5"
  if (stage == "ingest" || stage == "simulate") return "records.h5"
  return stage ".h5"
}

{
  line = line $0
  if (sub(/\\$/, "", line)) next
  $0 = line
  line = ""
  for (first = 1; first <= NF && $first != "pipeline/step.sh"; ++first) continue
  if (first >= NF) next
  folder = $(first + 1)
  stage = $(first + 2)
  if (stage == "diagnose" && $0 ~ / --keep-features( |$)/) stage = "features"
  if (stage == "sweep" && option("--method") != "") stage = "sweep@" option("--method")
  print folder "\t" stage "\t" option("--method") "\t" folder "/" file_of(stage)
}
