# The front door. `make help` says what there is; the experiment itself is in pipeline/grid.mk, which
# is read when the programs are built, because they know what methods and settings there are.

ifneq ($(firstword $(sort 4.3 $(MAKE_VERSION))),4.3)
$(error GNU make 4.3 or later is needed, this is $(MAKE_VERSION))
endif
SHELL := /bin/bash
MAKEFLAGS += --no-builtin-rules --no-print-directory

# ---- what is run: each can be given on the command line -----------------------------------------
RUN      := paper
DATASETS := cwru
# Where these three are not given, the programs say which they are: the paper's methods and those we recommend, all
# ratios, the paper's classifier. The word `paper` among METHODS stands for the paper's alone.
METHODS  :=
RATIOS   :=
CLASSIFIERS :=
SEEDS    := 0 1 2 3 4 5 6 7 8 9
PROTOCOL := random
DATA_DIR ?= data
ARCH     ?= native
LIBTORCH := on
SUBMIT   :=
TOLERANCE := auto
LINT     :=
STORM    := full
PREFIX   := /usr/local
DESTDIR  ?=
V        :=
# On a cluster: cores of a job, how long it is to take, how many run at a time.
CORES    := 4
MINUTES  := 15
JOBS     := 16
GPU_PARTITION :=
quickly  :=

# `make cluster sweep` is the goal sweep, but computed elsewhere; and `make status sweep` only looks at it.
elsewhere  := cluster cluster-plan cluster-stop status help
on_cluster := $(filter $(elsewhere),$(MAKECMDGOALS))
goals      := $(filter-out $(elsewhere),$(MAKECMDGOALS))

# The demo has grids of its own (pipeline/demo.mk) and uses all cores unless -j says otherwise. It builds only the
# programs that it runs, and does not need LibTorch.
ifneq (,$(filter demo,$(MAKECMDGOALS)))
$(if $(filter-out demo,$(MAKECMDGOALS)),$(error make demo: give no other target with it))
RUN      := demo
RATIOS   := 100to1 5to1
SEEDS    := 0 1 2
LIBTORCH := off
quickly  := demo
MAKEFLAGS += -j$(shell env -u OMP_NUM_THREADS nproc)
endif

# Only simulated windows have a known (k, c).
ifeq (identify,$(strip $(goals)))
DATASETS := simulated
METHODS  := piae-dt piae-dt-phase
endif

# Choices are made on seeds of their own (pipeline/readings.mk).
ifneq (,$(filter readings,$(MAKECMDGOALS)))
RUN      := readings
DATASETS := cwru hit-sm simulated
METHODS  := piae-dt
SEEDS    := 100 101 102 103 104
endif

# The groups of pipeline/protocol.toml say of which data sets it is (pipeline/transfer.mk).
ifneq (,$(filter transfer,$(MAKECMDGOALS)))
DATASETS :=
endif

# ---- what was given -----------------------------------------------------------------------------
variables := RUN DATASETS METHODS RATIOS CLASSIFIERS SEEDS PROTOCOL DATA_DIR ARCH LIBTORCH BIN SUBMIT TOLERANCE LINT STORM V \
             PREFIX DESTDIR CORES MINUTES JOBS GPU_PARTITION
given     := $(foreach name,$(.VARIABLES),$(if $(filter command,$(firstword $(origin $(name)))),$(name)))

# Values are text, and make and the shell are given no other. (What a value holds is looked at before make
# would read it as one of its own expressions.) The recordings' folder may be called nearly anything.
define line_break


endef
in_folders := ' $$
of_code    := $(in_folders) " ` \ ; & | < > ( ) { } [ ] * ? ! ~ \#
found_in    = $(firstword $(foreach sign,$2,$(if $(findstring $(sign),$(value $1)),$(sign)))\
                $(if $(findstring $(line_break),$(value $1)),line break))
refuse_signs = $(if $(found_in),$(error $1: holds a $(patsubst line,line break,$(found_in)), which it must not; $3))
$(if $(strip $(value DATA_DIR)),,$(error DATA_DIR: is empty; name the folder of the recordings or leave it out))
$(call refuse_signs,DATA_DIR,$(in_folders),rename the folder or make a link to it)
$(if $(filter -%,$(firstword $(DATA_DIR))),$(error DATA_DIR: begins with '-'; write ./$(DATA_DIR)))
$(foreach name,$(filter-out DATA_DIR SUBMIT,$(variables)),$(call refuse_signs,$(name),$(of_code),it is a plain word or a list of them))
# make reads these as its own where a file has them in its name.
comma := ,
$(call refuse_signs,RUN,: = % $(comma),it is the name of a folder under results/)

ifneq (,$(filter demo,$(MAKECMDGOALS)))
$(foreach name,$(filter DATASETS METHODS RATIOS CLASSIFIERS,$(given)),$(error make demo: has $(name) of its own; \
  `make all` takes any))
endif

# A name that is nearly one of ours: in the other case, or the beginning of one, or one with more to it.
upper_case = $(shell printf %s '$1' | tr a-z A-Z)
like_it    = $(foreach name,$(variables),$(if $(filter $1%,$(name))$(filter $(name)%,$1),$(name)))
meant      = $(firstword $(call like_it,$(call upper_case,$1)))
$(foreach name,$(filter-out $(variables),$(given)),$(error there is no variable $(name); $(or \
  $(patsubst %,did you mean %?,$(call meant,$(name))),`make help` lists those there are)))
one_of = $(if $(and $(filter $2,$($1)),$(filter 1,$(words $($1)))),,$(error $1: $(firstword $2) or \
  $(lastword $2), not '$($1)'))
$(call one_of,LIBTORCH,on off)
$(call one_of,PROTOCOL,random blocked)
$(if $(filter full short least,$(STORM)),,$(error STORM: full, short or least, not '$(STORM)'))
$(if $(filter-out all,$(LINT)),$(error LINT: all, or not given, not '$(LINT)'))

$(if $(filter cluster cluster-stop,$(MAKECMDGOALS)),$(if $(shell command -v sbatch),,$(error there is no sbatch here, \
  so no Slurm to submit to; `make all` computes on this machine, `make cluster-plan` shows what jobs there would be)))

# The folder, as a shell completes it, will do: RUN=results/try/ is RUN=try.
override RUN := $(patsubst results/%,%,$(RUN:/=))
results      := results/$(RUN)$(patsubst %,-%,$(filter blocked,$(PROTOCOL)))

# What is only looked at is what the run holds.
ifneq (,$(filter figures report,$(MAKECMDGOALS)))
DATASETS := $(or $(sort $(notdir $(patsubst %/,%,$(dir $(wildcard $(results)/*/seed*))))),$(DATASETS))
endif

# Programs are built first, unless BIN= names a folder where they already are, or the link bin of a folder that the
# installed piae-dt has laid out (packaging/piae-dt). There are no sources then. `make -q` only asks.
flags := $(firstword -$(MAKEFLAGS))
installed  := $(wildcard bin/settings)
of_sources := build build-demo deps install package test test-all storm lint bench bench-scale reference clean
$(if $(installed),$(foreach goal,$(filter $(of_sources),$(goals)),$(error make $(goal): needs a clone of the sources; the programs here \
  are installed ones ($(realpath bin)))))
ifneq (,$(filter BIN,$(given)))
$(if $(wildcard $(BIN)/settings),,$(error BIN: there are no programs in '$(BIN)'; `make build` builds them into build/bin))
else ifneq (,$(installed))
BIN      := bin
else
BIN      := build/bin
programs := $(if $(findstring q,$(flags)),,build$(quickly:%=-%))
endif

export BIN SUBMIT
Q := $(if $(V),,@)

.DEFAULT_GOAL := help
.PHONY: help grid demo cluster cluster-plan cluster-stop status check reference data test \
        test-all storm lint bench bench-scale deps build build-demo install package clean

help:
	@printf '  %-14s%s\n' \
	  demo     'install and build what is missing, answer three questions on a simulated bearing: start here' \
	  all      'run the grid, make its tables in results/RUN/<dataset>/, its figures, its report' \
	  cells    'run the grid without the tables (on a cluster: see jobs/)' \
	  figures  'draw what RUN holds, in results/RUN/<dataset>/figures/: CSV, SVG and PDF' \
	  report   'a page of what RUN holds and lacks: results/RUN/report.html, and report.md' \
	  sweep    'move the settings that [sweep] of the protocol has of METHODS, one at a time: sweep*.csv, .md' \
	  contrast 'both protocols side by side, and both readings of cwru: protocols.md, rates.md' \
	  identify 'whether the (k, c) of the twin are the true ones, on simulated windows' \
	  readings 'the choices that the paper leaves, tried on seeds 100-104: readings.csv, readings.md' \
	  transfer 'methods in the mean over data sets that test another speed or size: transfer@GROUP.md' \
  trust    'keep the classifiers, for classify and monitor, and say how far to believe them: trust.md' \
  records  'only read or simulate the data sets' \
	  cluster  'the same on Slurm, in few jobs: all, or with cells, sweep, contrast, identify or readings' \
	  cluster-plan 'what jobs that would be: their number, cores, hours and memory' \
	  cluster-stop 'stop the jobs of RUN; the same make cluster goes on from there' \
	  status   'how far the grid is: cells done, running, failed, missing, and the time left' \
	  check    'compare RUN with results/reference: all cells, or those of the variables given' \
	  data     'download the recordings that have an official address into DATA_DIR' \
	  | sed 's/^ /make/; 1i\Targets'
	@$(if $(installed),: )printf '  %-14s%s\n' \
	  reference 'store RUN, or the cells of the variables given, as results/reference, its tables and figures' \
	  test     'build and run the quick tests, in minutes; those on real recordings when DATA_DIR has them' \
	  test-all 'build and run every test, on a real Slurm, too: most of an hour' \
	  storm    'kill, damage and forge by the thousand, under sanitizers: SECURITY.md' \
	  lint     'check style and structure of what changed; of everything with LINT=all' \
	  bench    'build and run the benchmarks' \
	  bench-scale 'what make, status, tables, figures and report take of 10^3, 10^4 and 10^5 steps' \
	  deps     'install the packages that are missing (apt)' \
	  build    'build the programs into build/bin' \
	  install  'build them and install them into PREFIX, as the command piae-dt' \
	  package  'make Debian packages of them, build/package/*.deb, for this release of Debian' \
	  clean    'remove build/; results and data stay' \
	  | sed 's/^ /make/; 1i\\nTargets that need the sources'
	@printf '  %-14s%s\n' \
	  RUN      'folder under results/; PROTOCOL=blocked adds "-blocked"  [$(RUN)]' \
	  DATASETS 'any of $(basename $(notdir $(wildcard pipeline/datasets/*.toml)))  [$(DATASETS)]' \
	  METHODS  "none runs at 100to1, all others at the other ratios; paper: the paper's alone  [$(or $(METHODS),$(default_methods))]" \
	  RATIOS   'windows known to generated  [$(or $(RATIOS),all seven)]' \
	  CLASSIFIERS "what learns from the windows; none has its cell of nearest in any case  [$(or $(CLASSIFIERS),wdcnn)]" \
	  SEEDS    'independent repeats; 100-104 are for choosing parameters  [$(SEEDS)]' \
	  PROTOCOL 'the split: random (the paper) or blocked (no overlaps)  [$(PROTOCOL)]' \
	  DATA_DIR 'folder of the recordings  [$(DATA_DIR)]' \
	  BIN      'folder of programs to use as they are, instead of building  [$(BIN)]' \
	  SUBMIT   'command put before every step, such as "srun --ntasks=1 --mem=2G"  [$(SUBMIT)]' \
	  TOLERANCE 'of check: exact, spread, or auto: exact on the same processor and libraries  [$(TOLERANCE)]' \
	  CORES    'of a job on a cluster  [$(CORES)]' \
	  MINUTES  'that a job on a cluster is to take, by what the steps took elsewhere  [$(MINUTES)]' \
	  JOBS     'that run at a time on a cluster  [$(JOBS)]' \
	  GPU_PARTITION 'of the cluster, for what asks for device = "cuda" in pipeline/  [$(GPU_PARTITION)]' \
	  V        'V=1 shows the commands  [$(V)]' \
	  | sed '1i\\nVariables, and their values now'
	@$(if $(installed),: )printf '  %-14s%s\n' \
	  ARCH     'processor to build for: native, x86-64-v3, ...  [$(ARCH)]' \
	  LIBTORCH 'on, or off: build without it, and without --backend libtorch and --device cuda  [$(LIBTORCH)]' \
	  LINT     'of lint: all, or what changed  [$(LINT)]' \
	  STORM    'of storm: full (hours), short (minutes) or least  [$(STORM)]' \
	  PREFIX   'where to install  [$(PREFIX)]' \
	  DESTDIR  'folder that stands for the root when installing  [$(DESTDIR)]' \
	  | sed '1i\\nVariables of targets that need the sources'
	@printf '%s\n' '' \
	  'make -j2 runs two steps at a time, -k carries on after a failed cell, -n shows what would run.' \
	  'A setting changed in pipeline/ makes exactly what depends on it again. Programs built again do' \
	  'not discard results: to start over, remove the folder of the run.'

# ---- the grid -----------------------------------------------------------------------------------
# All goals that are its own, files of results/ among them, go to one make.
asked := $(filter records cells tables all figures report sweep contrast identify readings transfer trust results/%,$(goals))
.PHONY: $(asked)
$(asked): $(or $(on_cluster),grid)
ifneq (,$(on_cluster))
$(asked): ; @: # or make would say that there is nothing to be done
endif

# The programs know the methods.
facts_of = $(patsubst $1:%,%,$(filter $1:%,$(shell [ ! -x $(BIN)/settings ] || $(BIN)/settings --facts)))
default_methods = $(or $(call facts_of,default),the paper's ten and what we recommend: piae-dt-phase shift)
spelled_out = $(if $(filter paper,$1),$(foreach word,$1,$(if $(filter paper,$(word)),$(call facts_of,paper),$(word))),$1)
value_of    = $(if $(filter METHODS,$1),$(call spelled_out,$(METHODS)),$($1))

# Where a run is only looked at, nothing need be there but what those variables name that are given.
lower_case  = $(shell printf %s '$1' | tr A-Z a-z)
options_of  = $(foreach name,$(filter $1,$(given)),--$(call lower_case,$(name)) $(call value_of,$(name)))
cells_given = $(call options_of,METHODS RATIOS CLASSIFIERS SEEDS)
part        = $(call options_of,DATASETS) $(cells_given)

choice = $(foreach name,RUN DATASETS METHODS RATIOS CLASSIFIERS SEEDS PROTOCOL DATA_DIR BIN results cells_given,\
           $(if $($(name)),'$(name)=$(call value_of,$(name))'))
# A dry run of a project that is not built can show no more than that it would be built. Nor can one whose programs
# are older than the sources, where these programs do not understand pipeline/ any more.
too_old     = $(if $(programs),$(shell $(BIN)/settings --facts >/dev/null 2>&1 || \
  find src stages -newer $(BIN)/settings -print -quit 2>/dev/null))
unknown_yet := $(if $(findstring n,$(filter-out --%,$(flags))),$(if $(wildcard $(BIN)/settings),$(too_old),yes))
to_run = $(if $(unknown_yet),echo 'for the steps of the grid the programs must be built first: `make build`',\
  $(MAKE) --file=pipeline/$1.mk $(choice) $2)
grid: | $(programs)
	$(Q)+$(call to_run,grid,$(asked))
demo: | $(programs)
	$(Q)+$(call to_run,demo,demo)

cluster: | $(programs)
	$(Q)jobs/submit.sh '$(or $(asked),all)' $(choice) $(foreach name,CORES MINUTES JOBS GPU_PARTITION,'$(name)=$($(name))')
cluster-plan: | $(programs)
	$(Q)jobs/submit.sh --plan '$(or $(asked),all)' $(choice) $(foreach name,CORES MINUTES JOBS,'$(name)=$($(name))')
cluster-stop:
	$(Q)jobs/stop.sh '$(results)'

status:
	$(Q)pipeline/status.sh '$(results)' '$(asked)' '$(given)' $(MAKE) --file=pipeline/grid.mk $(choice)

# Only the variables that are given narrow down what is compared or stored.
compare = $(BIN)/check --run $(results) --reference results/reference $(part)
check: | $(programs)
	$(Q)$(compare) --tolerance $(TOLERANCE)
reference: | $(programs)
	$(Q)$(compare) --store
	$(Q)pipeline/keep_shown.sh $(results) results/reference/$(PROTOCOL)

data: | $(programs)
	$(Q)pipeline/download.sh '$(DATA_DIR)' $(DATASETS)

# ---- building -----------------------------------------------------------------------------------
# What is to be built, of `programs tests benches` or `demo`: packages for that are installed first.
draws      = $(filter demo all figures report transfer,$(or $(goals),$(on_cluster:%=all)))
build_them = pipeline/deps.sh $(LIBTORCH) $1 $(if $(draws),figures) && pipeline/build.sh $(ARCH) $(LIBTORCH) $1

build:
	$(Q)$(call build_them,programs)

build-demo:
	$(Q)$(call build_them,demo)

bench:
	$(Q)$(call build_them,benches)
	$(Q)source pipeline/environment.sh; export OMP_NUM_THREADS=1; \
	  for bench in build/bin/bench_*; do $$bench || exit; done

bench-scale:
	$(Q)pipeline/deps.sh $(LIBTORCH) programs benches figures
	$(Q)pipeline/build.sh $(ARCH) $(LIBTORCH) programs benches_of_scale
	$(Q)tests/bench/scale/scale.sh build/bin

test:
	$(Q)$(call build_them,programs tests)
	$(Q)DATA_DIR='$(DATA_DIR)' tests/run.sh quick

test-all:
	$(Q)pipeline/deps.sh $(LIBTORCH) programs tests benches readers cluster
	$(Q)pipeline/build.sh $(ARCH) $(LIBTORCH) programs tests slow_tests benches
	$(Q)DATA_DIR='$(DATA_DIR)' tests/run.sh all

# The programs are found where they are installed, whatever stands in BIN.
install:
	$(Q)$(call build_them,programs)
	$(Q)DESTDIR='$(DESTDIR)' cmake --install build --prefix '$(abspath $(PREFIX))' --strip >build/install.log
	@echo 'installed: $(DESTDIR)$(abspath $(PREFIX))/bin/piae-dt'

# A package is for any processor of the last ten years, unless ARCH= says for which.
ifneq (,$(filter package,$(goals)))
ifeq (native,$(ARCH))
ARCH := $(or $(patsubst %,x86-64-v3,$(filter x86_64,$(shell uname -m))),native)
endif
endif
package:
	$(Q)pipeline/deps.sh $(LIBTORCH) programs package
	$(Q)rm -f build/package/*.deb
	$(Q)pipeline/build.sh $(ARCH) $(LIBTORCH) package
	@ls build/package/*.deb

# The programs as they are used, and the readers once more under the sanitizers.
storm:
	$(Q)pipeline/deps.sh $(LIBTORCH) programs tests
	$(Q)pipeline/build.sh $(ARCH) $(LIBTORCH) programs storm_parts
	$(Q)pipeline/build.sh $(ARCH) off storm_inputs
	$(Q)tests/slow/storm/storm.sh build/storm/run '$(BIN)' build/storm/bin '$(STORM)'

lint:
	$(Q)pipeline/deps.sh $(LIBTORCH) programs tests benches lint
	$(Q)LINT='$(LINT)' pipeline/lint.sh

deps:
	$(Q)pipeline/deps.sh $(LIBTORCH) programs tests benches figures

clean:
	rm -rf build
