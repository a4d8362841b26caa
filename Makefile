# The front door: `make help` lists everything. The program `plan` (src/plan) knows the steps of a run and
# which are due; make runs what it prints (pipeline/run.sh).

ifneq ($(firstword $(sort 4.3 $(MAKE_VERSION))),4.3)
$(error GNU make 4.3 or later is needed, this is $(MAKE_VERSION))
endif
SHELL := /bin/bash
MAKEFLAGS += --no-builtin-rules --no-print-directory

# ---- the request: each variable can be given on the command line --------------------------------
# Choices are made in a run of their own.
RUN      := $(if $(filter readings,$(MAKECMDGOALS)),readings,paper)
# Defaults of these depend on the goal: `make help`.
DATASETS :=
METHODS  :=
RATIOS   :=
CLASSIFIERS :=
SEEDS    :=
PROTOCOL := random
DATA_DIR ?= data
ARCH     ?= native
LIBTORCH := on
SUBMIT   :=
TOLERANCE := auto
REFERENCE := results/reference
LINT     :=
STORM    := full
PREFIX   := /usr/local
DESTDIR  ?=
V        :=
# On a cluster: cores of a job, its approximate minutes, jobs at a time.
CORES    := 4
MINUTES  := 15
JOBS     := 16
GPU_PARTITION :=
quickly  :=

# `make cluster sweep` computes the goal sweep elsewhere; `make status sweep` and `make why sweep` only look.
looking    := cluster-plan status why plan
elsewhere  := cluster cluster-stop $(looking) help
on_cluster := $(filter $(elsewhere),$(MAKECMDGOALS))
goals      := $(filter-out $(elsewhere),$(MAKECMDGOALS))

# ---- checks of the given variables --------------------------------------------------------------
variables := RUN DATASETS METHODS RATIOS CLASSIFIERS SEEDS PROTOCOL DATA_DIR ARCH LIBTORCH BIN SUBMIT \
             TOLERANCE REFERENCE LINT STORM V PREFIX DESTDIR CORES MINUTES JOBS GPU_PARTITION
given     := $(foreach name,$(.VARIABLES),$(if $(filter command,$(firstword $(origin $(name)))),$(name)))

# Values must be plain text for make and the shell. They are checked before make would expand them. The folder
# of the recordings may have almost any name.
define line_break


endef
in_folders := ' $$
of_code    := $(in_folders) " ` \ ; & | < > ( ) { } [ ] * ? ! ~ \#
found_in    = $(firstword $(foreach sign,$2,$(if $(findstring $(sign),$(value $1)),$(sign)))\
                $(if $(findstring $(line_break),$(value $1)),newline))
refuse_signs = $(if $(found_in),$(error $1: contains a $(found_in), which is not allowed; $3))
$(if $(strip $(value DATA_DIR)),,$(error DATA_DIR: is empty; name a folder or leave it out))
$(call refuse_signs,DATA_DIR,$(in_folders),rename the folder or make a link to it)
$(if $(filter -%,$(firstword $(DATA_DIR))),$(error DATA_DIR: starts with '-'; write ./$(DATA_DIR)))
$(foreach name,$(filter-out DATA_DIR SUBMIT,$(variables)),\
  $(call refuse_signs,$(name),$(of_code),use plain words))
$(foreach name,$(filter RUN DATASETS METHODS RATIOS CLASSIFIERS SEEDS,$(given)),\
  $(if $(strip $($(name))),,$(error $(name): is empty; give a value or leave it out)))
# make would interpret these characters in a file name.
comma := ,
$(call refuse_signs,RUN,: = % $(comma),it is the name of a folder under results/)

# The demo has grids of its own (pipeline/demo.mk), and uses all cores unless -j is given. It builds only the
# programs that it runs, and does not need LibTorch.
ifneq (,$(filter demo,$(MAKECMDGOALS)))
$(foreach name,$(filter DATASETS METHODS RATIOS CLASSIFIERS,$(given)),\
  $(error make demo: $(name) cannot be chosen; `make all` accepts it))
$(if $(filter-out demo,$(MAKECMDGOALS)),\
  $(error make demo: cannot be combined with other targets; run it alone))
RUN      := demo
RATIOS   := 100to1 5to1
SEEDS    := 0 1 2
LIBTORCH := off
quickly  := demo
MAKEFLAGS += -j$(shell env -u OMP_NUM_THREADS nproc)
endif

# Suggests a variable that is almost the given name: in the other case, or with fewer or more letters.
upper_case = $(shell printf %s '$1' | tr a-z A-Z)
like_it    = $(foreach name,$(variables),$(if $(filter $1%,$(name))$(filter $(name)%,$1),$(name)))
meant      = $(firstword $(call like_it,$(call upper_case,$1)))
$(foreach name,$(filter-out $(variables),$(given)),$(error there is no variable $(name); $(or \
  $(patsubst %,did you mean %?,$(call meant,$(name))),`make help` lists all)))
one_of = $(if $(and $(filter $2,$($1)),$(filter 1,$(words $($1)))),,$(error $1: must be $(firstword $2) or \
  $(lastword $2), not '$($1)'))
$(call one_of,LIBTORCH,on off)
$(call one_of,PROTOCOL,random blocked)
$(if $(filter full short least,$(STORM)),,$(error STORM: must be full, short or least, not '$(STORM)'))
$(if $(filter-out all,$(LINT)),$(error LINT: must be all, or not given, not '$(LINT)'))

$(if $(filter cluster cluster-stop,$(MAKECMDGOALS)),$(if $(shell command -v sbatch),,$(error sbatch is not \
  installed, so there is no Slurm; `make all` computes here, `make cluster-plan` shows the jobs)))

# Accepts a folder as a shell completes it: RUN=results/try/ is RUN=try.
override RUN := $(patsubst results/%,%,$(RUN:/=))
$(if $(RUN),,$(error RUN: is empty; give a name or leave it out))
results      := results/$(RUN)$(patsubst %,-%,$(filter blocked,$(PROTOCOL)))

# The one-letter options of this make, such as -nk.
letters    := $(filter-out --%,$(firstword -$(MAKEFLAGS)))

# Builds the programs first, unless BIN= names their folder or the installed piae-dt has linked them as bin
# (packaging/piae-dt). An installation does not have the sources. `make -q` does not build.
installed  := $(wildcard bin/plan)
of_sources := build build-demo deps install package test test-all storm lint bench bench-scale reference reference-all \
              clean
$(if $(installed),$(foreach goal,$(filter $(of_sources),$(goals)),\
  $(error make $(goal): needs a clone of the sources; the programs here are installed: $(realpath bin))))
ifneq (,$(filter BIN,$(given)))
no_programs = there are no programs in '$(BIN)'; `make build` builds them into build/bin
$(if $(wildcard $(BIN)/plan),,$(error BIN: $(no_programs)))
else ifneq (,$(installed))
BIN      := bin
else
BIN      := build/bin
programs := $(if $(findstring q,$(letters)),,build$(quickly:%=-%))
endif

# One plan covers all goals of the grid, including files of results/.
grid_goals := records cells features tables all figures report
grid_goals += sweep contrast identify readings transfer trust verdicts
requested := $(filter $(grid_goals) results/%,$(goals))
# Programs take the request from the environment, so that neither make nor a shell interprets a value.
GOALS := $(requested)
export GOALS RUN DATASETS METHODS RATIOS CLASSIFIERS SEEDS PROTOCOL DATA_DIR BIN SUBMIT V
Q := $(if $(V),,@)

.DEFAULT_GOAL := help
.PHONY: help grid demo cluster cluster-plan cluster-stop status why plan check reference reference-all data \
        test test-all storm lint bench bench-scale deps build build-demo install package clean

help:
	@sed '$(if $(installed),/^Targets that need/$(comma)$$d)' pipeline/help.txt

# ---- the grid -----------------------------------------------------------------------------------
.PHONY: $(requested)
$(requested): $(or $(on_cluster),grid)
ifeq (,$(findstring n,$(letters))$(findstring q,$(letters)))
$(requested): ; @: # or make would say that there is nothing to be done
endif

grid: | $(programs)
	$(Q)+pipeline/run.sh '$(MAKE)'
demo: | $(programs)
	$(Q)+$(MAKE) --file=pipeline/demo.mk results='$(results)'

why: | $(programs)
	$(Q)$(BIN)/plan --looks --whole
plan: | $(programs)
	$(Q)$(BIN)/plan --looks --whole --format summary
status:
	$(Q)jobs/queue.sh '$(results)' | $(BIN)/status --queue /dev/stdin

cluster_choice = $(foreach name,CORES MINUTES JOBS GPU_PARTITION,'$(name)=$($(name))')
cluster: | $(programs)
	$(Q)jobs/submit.sh $(cluster_choice)
cluster-plan: | $(programs)
	$(Q)jobs/submit.sh --plan $(cluster_choice)
cluster-stop:
	$(Q)jobs/stop.sh '$(results)'

# Only the given variables select what is compared or stored.
lower_case = $(shell printf %s '$1' | tr A-Z a-z)
part       = $(foreach name,DATASETS METHODS RATIOS CLASSIFIERS SEEDS,\
               $(if $(filter $(name),$(given)),--$(call lower_case,$(name)) $($(name))))
compare    = $(BIN)/check --run $(results) --reference $(REFERENCE) $(part)
check: | $(programs)
	$(Q)$(compare) --tolerance $(TOLERANCE)
reference: | $(programs)
	$(Q)$(compare) --store
	$(Q)pipeline/keep_shown.sh $(results) $(REFERENCE)/$(PROTOCOL)
reference-all: | $(programs)
	$(Q)+DATA_DIR='$(DATA_DIR)' BIN='$(BIN)' pipeline/reference_all.sh '$(MAKE)'

data: | $(programs)
	$(Q)pipeline/download.sh '$(DATA_DIR)' $(or $(DATASETS),cwru)

# ---- building -----------------------------------------------------------------------------------
# Builds `programs tests benches` or `demo`, after installing the packages for them.
drawing    = all figures report readings transfer verdicts
draws      = $(filter demo $(drawing) results/%,$(or $(goals),$(on_cluster:%=all)))
build_them = pipeline/deps.sh $(LIBTORCH) $1 $(if $(draws),figures) && \
  pipeline/build.sh $(ARCH) $(LIBTORCH) $1

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

# abspath would take each word of PREFIX for a folder.
$(if $(word 2,$(PREFIX)),$(error PREFIX: contains a space, which is not allowed; name another folder))
# Installed programs are found in their folder, whatever BIN is.
install:
	$(Q)$(call build_them,programs)
	$(Q)DESTDIR='$(DESTDIR)' cmake --install build --prefix '$(abspath $(PREFIX))' --strip >build/install.log
	@echo 'installed: $(DESTDIR)$(abspath $(PREFIX))/bin/piae-dt'

# A package runs on any processor of the last ten years, unless ARCH= is given.
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

# Builds the programs as users have them, and the readers with the sanitizers, too.
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
