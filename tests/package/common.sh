# For the tests of the package. A pipe whose answers depend on nothing but its input: bounded by steps, without timing.
answers() {  # answers RUN... : what the pipe answers, each program started by the words RUN
  "$@" obby-import ${IMPORT_OPTIONS:-} levels/demo.rbxlx |
    "$@" obby-solve --seed 7 --max-steps 300000 --time-limit 1e9 --final-only |
    sed -E 's/,"timing":\{[^}]*\}//'
}
