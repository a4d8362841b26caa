#!/bin/bash
# Pages must link to existing targets, show existing goals of make, and stay short: each page has a limit, and all
# together.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

pages() { files_matching '\.md$' "$@" | grep -vE '^results/(reference|published)/'; }
# Goals of `make help`, and the goal that CONTRIBUTING.md adds as an example.
targets=$(sed -nE 's/^make ([a-z-]+) .*/\1/p; s/.*\.name = "([a-z-]+)", \.add.*/\1/p' pipeline/help.txt CONTRIBUTING.md |
  sort -u | tr '\n' ' ')
files=$(git ls-files --cached --others --exclude-standard | tr '\n' '|')

mapfile -t all < <(pages)
# Read the headings of all pages first: a link may lead to any page.
findings=$(awk -v targets="$targets" -v files="|$files" -f pipeline/lint/pages.awk "${all[@]}" "${all[@]}")
(($#)) && findings=$(grep -F -f <(pages "$@" | sed 's/$/:/') <<<"$findings" || true)
[[ ! $findings ]] || printf '%s\n' "$findings"
