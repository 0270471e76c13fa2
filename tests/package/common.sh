# Helper for the tests of the package: a pipe whose answers depend only on its input. The pipe is
# limited by steps, and its output has no times.
answers() {  # answers RUN... : prints the pipe's answers; RUN... starts each program
  "$@" obby-import ${IMPORT_OPTIONS:-} levels/demo.rbxlx |
    "$@" obby-solve --seed 7 --max-steps 300000 --time-limit 1e9 --final-only |
    sed -E 's/,"timing":\{[^}]*\}//'
}
