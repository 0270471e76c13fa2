#!/bin/sh
# localize.sh LINKER OBJCOPY NM SYMBOL OUTPUT OBJECT...: links objects into one whose only global
# symbol is SYMBOL (ObbyLanes.cmake gives the reason).
set -eu
linker=$1 objcopy=$2 nm=$3 symbol=$4 output=$5
shift 5
"$linker" -r --force-group-allocation -o "$output.all" "$@"
"$objcopy" --keep-global-symbol="$symbol" "$output.all" "$output"
rm "$output.all"
defined=$("$nm" --defined-only --extern-only --format=just-symbols "$output")
[ "$defined" = "$symbol" ] || { echo "localize.sh: $output defines more than $symbol: $defined" >&2; exit 1; }
