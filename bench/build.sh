#!/usr/bin/env bash
# Measures CPU seconds from a clean clone of the last commit, without a compiler cache, until
# scripts/demo has its page and until scripts/test has its verdict. Targets, in minutes of CPU: demo
# 6, tests 50.
#   bench/build.sh [--json] [demo] [tests]     run by scripts/bench build
set -euo pipefail
json=no cases=()
for word in "$@"; do
  case $word in
    --json) json=yes ;;
    demo|tests) cases+=("$word") ;;
    *) echo "bench_build: unknown argument $word; usage: scripts/bench build [--json] [demo] [tests]" >&2; exit 2 ;;
  esac
done
[ ${#cases[@]} -gt 0 ] || cases=(demo tests)
repo=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
clone=$(mktemp -d)
trap 'rm -rf "$clone"' EXIT
export CCACHE_DISABLE=1
TIMEFORMAT='%U %S %R'

row() {  # row CASE METRIC VALUE UNIT
  if [ $json = yes ]; then printf '{"bench":"build","case":"%s","metric":"%s","value":%s,"unit":"%s"}\n' "$@"
  else printf '%-10s %-24s %-28s %12s %s\n' build "$@"; fi
}

[ $json = yes ] || printf '%-10s %-24s %-28s %12s %s\n' bench case metric value unit
"$repo/scripts/setup" build test page browser reference mpi >&2
for name in "${cases[@]}"; do
  script=scripts/${name/tests/test}
  git clone -q "$repo" "$clone/$name"
  failed=0
  { time "$clone/$name/$script" >"$clone/log" 2>&1; } 2>"$clone/times" || failed=$?
  [ $failed = 0 ] || { tail -n 20 "$clone/log" >&2; echo "bench_build: $script failed with $failed" >&2; exit 1; }
  read -r user system wall < <(tail -n 1 "$clone/times")
  row "$name" cpuSeconds "$(awk "BEGIN{print $user + $system}")" s
  row "$name" wallSeconds "$wall" s
  rm -rf "${clone:?}/$name"
done
