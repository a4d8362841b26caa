# The front door. `make help` says what there is; the experiment itself is in pipeline/grid.mk.

ifneq ($(firstword $(sort 4.3 $(MAKE_VERSION))),4.3)
$(error GNU make 4.3 or later is needed, this is $(MAKE_VERSION))
endif
SHELL := /bin/bash
MAKEFLAGS += --no-builtin-rules --no-print-directory

# ---- what is run: each can be given on the command line -----------------------------------------
RUN      := paper
DATASETS := cwru
METHODS  := none dynamics smote vae wgan-gp piae-dt ae physics piae-dt-cnn piae-dt-rnn
RATIOS   := 100to1 50to1 25to1 10to1 5to1 2to1 1to1
SEEDS    := 0 1 2 3 4 5 6 7 8 9
PROTOCOL := random
DATA_DIR ?= data
ARCH     ?= native
SUBMIT   :=
TOLERANCE := auto
LINT     :=
V        :=

# The demo is a small grid of the same kind, on all cores unless -j says otherwise.
ifneq (,$(filter demo,$(MAKECMDGOALS)))
RUN      := demo
DATASETS := simulated
METHODS  := none piae-dt
RATIOS   := 100to1 10to1
SEEDS    := 0 1
MAKEFLAGS += -j$(shell env -u OMP_NUM_THREADS nproc)
endif

# Only simulated windows have a known (k, c).
ifeq (identify,$(strip $(MAKECMDGOALS)))
DATASETS := simulated
METHODS  := piae-dt piae-dt-phase
endif

# Programs are built first, unless BIN= names a folder where they already are.
ifneq ($(origin BIN),command line)
BIN      := build/bin
programs := build
endif

# The folder, as a shell completes it, will do: RUN=results/try/ is RUN=try.
override RUN := $(patsubst results/%,%,$(RUN:/=))

export BIN SUBMIT
Q := $(if $(V),,@)

.DEFAULT_GOAL := help
.PHONY: help demo all cells tables holes sweep contrast identify records status check reference data test lint bench deps build clean

help:
	@printf '  %-11s%s\n' \
	  demo     'install what is missing, build, run the method on a simulated bearing: start here' \
	  all      'run the grid and make its tables in results/RUN/<dataset>/' \
	  cells    'run the grid without the tables (on a cluster: see jobs/)' \
	  sweep    'vary the settings of piae-dt one at a time (pipeline/sweep.mk): sweep.csv, sweep.md' \
	  contrast 'both protocols side by side, and both readings of cwru: protocols.md, rates.md' \
	  identify 'whether the (k, c) of the twin are the true ones, on simulated windows: identifiability.md' \
	  records  'only read or simulate the data sets' \
	  status   'how far the grid is: cells done, running, failed, missing, and the time left' \
	  check    'compare RUN with results/reference: all cells, or those of the variables given' \
	  reference 'store RUN, or the cells of the variables given, as results/reference, and its tables' \
	  data     'download the recordings that have an official address into DATA_DIR' \
	  test     'build and run every test; those on real recordings when DATA_DIR has them' \
	  lint     'check style and structure of what changed; of everything with LINT=all' \
	  bench    'build and run the benchmarks' \
	  deps     'install the packages that are missing (apt)' \
	  build    'build the programs into build/bin' \
	  clean    'remove build/; results and data stay' \
	  | sed 's/^ /make/; 1i\Targets'
	@printf '  %-11s%s\n' \
	  RUN      'folder under results/; PROTOCOL=blocked adds "-blocked"  [$(RUN)]' \
	  DATASETS 'any of $(known_datasets)  [$(DATASETS)]' \
	  METHODS  'none runs at 100to1, all others at the other ratios  [$(METHODS)]' \
	  RATIOS   'windows known to generated  [$(RATIOS)]' \
	  SEEDS    'independent repeats; 100-104 are for choosing parameters  [$(SEEDS)]' \
	  PROTOCOL 'the split: random (the paper) or blocked (no overlaps)  [$(PROTOCOL)]' \
	  DATA_DIR 'folder of the recordings  [$(DATA_DIR)]' \
	  ARCH     'processor to build for: native, x86-64-v3, ...  [$(ARCH)]' \
	  BIN      'folder of programs to use as they are, instead of building  [$(BIN)]' \
	  SUBMIT   'command put before every step, such as "srun --ntasks=1 --mem=2G"  [$(SUBMIT)]' \
	  TOLERANCE 'of check: exact, spread, or auto: exact on the same processor and libraries  [$(TOLERANCE)]' \
	  LINT     'of lint: all, or what changed  [$(LINT)]' \
	  V        'V=1 shows the commands  [$(V)]' \
	  | sed '1i\\nVariables, and their values now'
	@printf '%s\n' '' \
	  'make -j2 runs two steps at a time, -k carries on after a failed cell, -n shows what would run.' \
	  'A setting changed in pipeline/ makes exactly what depends on it again. Programs built again do' \
	  'not discard results: to start over, remove the folder of the run.'

deps:
	$(Q)pipeline/deps.sh

build: deps
	$(Q)pipeline/build.sh $(ARCH) programs

bench: deps
	$(Q)pipeline/build.sh $(ARCH) benches
	$(Q)source pipeline/environment.sh; export OMP_NUM_THREADS=1; \
	  for bench in build/bin/bench_*; do $$bench || exit; done

test: deps
	$(Q)pipeline/build.sh $(ARCH) programs tests
	$(Q)DATA_DIR='$(DATA_DIR)' tests/run.sh

lint:
	$(Q)pipeline/deps.sh lint
	$(Q)LINT='$(LINT)' pipeline/lint.sh

# Of the grid's variables only those that are given narrow down what is compared or stored.
given = $(foreach name,DATASETS METHODS RATIOS SEEDS,\
          $(if $(filter command,$(firstword $(origin $(name)))),--$(shell echo $(name) | tr A-Z a-z) $($(name))))
compare = $(BIN)/check --run $(results) --reference results/reference $(given)
check: | $(programs)
	$(Q)$(compare) --tolerance $(TOLERANCE)
reference: | $(programs)
	$(Q)$(compare) --store
	$(Q)pipeline/keep_tables.sh $(results) results/reference/$(PROTOCOL)

status:
	$(Q)pipeline/status.sh '$(results)' $(MAKE) $(choice)

data: | $(programs)
	$(Q)pipeline/download.sh '$(DATA_DIR)' $(filter-out $(simulated),$(DATASETS))

clean:
	rm -rf build

include pipeline/grid.mk
