# What jobs there are, for `make status`.
# usage: awk -F '\t' -v log_folder=FOLDER -f jobs/ended.awk QUEUE ENDED      (both of jobs/ended.sh)

function head() { if (!heads++) print "\njobs" }

FILENAME == ARGV[1] {
  kind = $2
  sub(/\.[0-9]+$/, "", kind)
  state = tolower($3)
  if (state == "pending" && $4 != "None") state = state " (" $4 ")"
  if (!((kind, state) in count)) order[++lines] = kind SUBSEP state
  ++count[kind, state]
  next
}
{ ended[++ended_count] = $1 ": " $2 " (log: " log_folder "/" $1 ".log)" }
END {
  for (i = 1; i <= lines; ++i) {
    split(order[i], name, SUBSEP)
    head()
    printf "  %s: %d %s\n", name[1], count[order[i]], name[2]
  }
  for (i = 1; i <= ended_count; ++i) {
    head()
    print "  " ended[i]
  }
}
