#!/usr/bin/env bash
# Checks that expected.tsv has a verdict and a reason for every query of the suite, and that
# levels/suite equals the output of its generator.
#   check_table.sh LEVELS
set -euo pipefail
levels=$1
awk -F'\t' '
  /^#/ { next }
  NF != 5 || $5 == "" { print FILENAME ":" FNR ": needs file, query, verdict, run and why"; bad = 1; next }
  $3 !~ /^(solved|unreachable|unsolved)$/ { print FILENAME ":" FNR ": no verdict: " $3; bad = 1 }
  $4 !~ /^(test|bench)$/ { print FILENAME ":" FNR ": run is test or bench, not " $4; bad = 1 }
  seen[$1, $2]++ { print FILENAME ":" FNR ": a second row for " $1 " " $2; bad = 1 }
  END { exit bad }' "$levels/expected.tsv"
for file in "$levels"/*.jsonl "$levels"/*.rbxlx "$levels"/suite/*.jsonl; do
  grep -q "^${file#"$levels"/}	" "$levels/expected.tsv" || { echo "$file: expected.tsv has no row for it"; exit 1; }
done
command -v python3 >/dev/null || { echo "no python3: levels/suite is not compared with its generator"; exit 77; }
"$levels/suite/generate" --check
