#!/bin/bash
# A room may include only rooms below it in the table of CONTRIBUTING.md, "Rooms", and every room must be in the table.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

folders=$(files_matching '^(src/[^/]+|stages)/' | sed -E 's,^src/,,; s,/.*,,' | sort -u | tr '\n' ' ')
files_matching '^(src|stages)/.*\.(cpp|hpp|in)$' "$@" |
  xargs --no-run-if-empty awk -v folders="$folders" -f pipeline/lint/rooms.awk CONTRIBUTING.md
