#!/usr/bin/env bash
# Solves the queries of one level and compares the verdicts with levels/expected.tsv.
#   check.sh BIN LEVELS FILE
# Queries that should be solved or proved unreachable get a generous time limit. The others get a
# short one, since their searches use all of it. Rows marked `bench` are for bench_solve only.
set -euo pipefail
bin=$1 levels=$2 file=$3

stream() {
  case $file in
    *.jsonl) cat "$levels/$file" ;;
    *) "$bin/obby-import" "$levels/$file" ;;
  esac
}

# select_queries IDS: prints the level records, and the queries whose id is a line of the file IDS.
select_queries() {
  awk -v ids="$1" '
    BEGIN { while ((getline line < ids) > 0) wanted["\"id\":\"" line "\""] = 1 }
    /"type":"level"/ { print }
    /"type":"query"/ { if (match($0, /"id":"[^"]*"/) && substr($0, RSTART, RLENGTH) in wanted) print }'
}

# verdicts: prints "id<TAB>verdict" for each result record.
verdicts() {
  awk '/"type":"result"/ {
    id = verdict = ""
    if (match($0, /"query":"[^"]*"/)) id = substr($0, RSTART + 9, RLENGTH - 10)
    if (match($0, /"verdict":"[^"]*"/)) verdict = substr($0, RSTART + 11, RLENGTH - 12)
    print id "\t" verdict
  }'
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
awk -F'\t' -v file="$file" '$1 == file && $4 == "test" { print $2 "\t" $3 }' "$levels/expected.tsv" |
  sort >"$work/expected"
[ -s "$work/expected" ] || { echo "check: expected.tsv has no row for $file"; exit 1; }
stream >"$work/stream"
awk -F'\t' '$2 != "unsolved" { print $1 }' "$work/expected" >"$work/decided"
awk -F'\t' '$2 == "unsolved" { print $1 }' "$work/expected" >"$work/others"

for group in "decided 40" "others 4"; do
  read -r ids limit <<<"$group"
  [ -s "$work/$ids" ] || continue
  select_queries "$work/$ids" <"$work/stream" | "$bin/obby-solve" -q --time-limit "$limit" | verdicts >>"$work/raw"
done
sort "$work/raw" >"$work/got"

# `unsolved` stands for unreachable or unknown.
join -t "$(printf '\t')" -a 1 -e missing -o 0,1.2,2.2 "$work/expected" "$work/got" |
  awk -F'\t' '{
    ok = $2 == $3 || ($2 == "unsolved" && ($3 == "unreachable" || $3 == "unknown"))
    printf "%-7s %-28s expected %-12s got %s\n", ok ? "ok" : "DIFFERS", $1, $2, $3
    if (!ok) bad = 1
  } END { exit bad }'
total=$(grep -c '"type":"query"' "$work/stream")
rows=$(awk -F'\t' -v file="$file" '$1 == file { ++rows } END { print rows }' "$levels/expected.tsv")
[ "$total" = "$rows" ] || { echo "check: $file has $total queries, expected.tsv $rows rows"; exit 1; }
