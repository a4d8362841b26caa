#!/bin/bash
# Checks the rules that a machine can check (CONTRIBUTING.md, "Style" and "Rooms"). Prints one line for each finding,
# "file:line: what; what would be right", and finally the number of findings of each rule. Exits with 1 after findings,
# with 2 if a rule could not be checked.
# usage: [LINT=all] pipeline/lint.sh [RULE [FILE or FOLDER...]]
# Without LINT=all only what changed is checked by tidy, by english, and of the headers in src/libtorch.
set -uo pipefail
cd "$(dirname "$0")/.." || exit 2

rules=(format shell spaces pages english torch rooms names units headers tidy) # the quick ones first
if (($#)); then
  [[ " ${rules[*]} " == *" $1 "* ]] || {
    echo "lint: there is no rule '$1'; the rules are ${rules[*]}" >&2
    exit 2
  }
  rules=("$1")
  shift
  for file; do
    [[ -e $file ]] || {
      echo "lint: '$file' does not exist; after the rule, name files or folders" >&2
      exit 2
    }
  done
fi

total=0 status=0 counts=()
for rule in "${rules[@]}"; do
  findings=$("pipeline/lint/$rule.sh" "$@")
  case $? in
    0)
      count=$(grep -c . <<<"$findings")
      ((count == 0)) || printf '%s\n' "$findings"
      total=$((total + count))
      counts+=("$rule $count")
      ;;
    77) counts+=("$rule skipped") ;;
    *)
      echo "lint: the rule '$rule' could not be checked; the lines above say why" >&2
      counts+=("$rule not checked")
      status=2
      ;;
  esac
done

((status || total == 0)) || status=1
printf -v list '%s, ' "${counts[@]}"
echo "lint: ${list%, } -- $total findings"
exit $status
