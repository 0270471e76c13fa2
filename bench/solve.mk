# The query suite in shards, one query a job, for machines with a queue or to pause and resume.
#   make -f bench/solve.mk                                     one after another, each on all cores
#   make -f bench/solve.mk -j 999 LAUNCHER="srun -n 1 -c 16"   Slurm: a job with 16 cores each
#   make -f bench/solve.mk -j 4 LAUNCHER="sem --fg -j 1"       GNU parallel's semaphore
#   make -f bench/solve.mk report ARGS="--quick"               a report of the completed runs
# Variables: BENCH is the program, OUT the folder of the shards, ARGS the options of bench_solve
# (see its --help), LAUNCHER a prefix for each job. Times are compared, so give every job the same
# cores and no other load. Each shard logs its runs when they end. Another make continues, and a
# newer program starts again.
BENCH    ?= build/release/bin/bench_solve
OUT      ?= build/bench/shards
LAUNCHER ?=
ARGS     ?=

shards := $(shell $(BENCH) --list | sed 's/:/\//')
ifeq ($(shards),)
  $(error no queries: is $(BENCH) built? scripts/bench solve --list builds it)
endif

.PHONY: all report
all: $(shards:%=$(OUT)/%.done)
	$(MAKE) --no-print-directory -f $(firstword $(MAKEFILE_LIST)) report

report:
	cat $(wildcard $(shards:%=$(OUT)/%.jsonl)) > $(OUT)/all.jsonl
	$(BENCH) --report-only --results $(OUT)/all.jsonl --svg $(OUT)/solve.svg $(ARGS)

# FILE/ID is the query FILE:ID.
$(OUT)/%.done: $(BENCH)
	@mkdir -p $(@D)
	$(LAUNCHER) $(BENCH) $(ARGS) --query $(patsubst %/,%,$(dir $*)):$(notdir $*) --results $(OUT)/$*.jsonl > /dev/null
	@touch $@
