# The experiment as a graph: data set x seed x method x ratio x classifier.
#
#   records.h5 -> A B C D -> model.h5 -> E.h5 -> score.h5
#                        \-------------------\-> <ratio>/<classifier>/diagnosis.h5 -> accuracy.csv, tables.md, ...
#
# A file under its final name is complete, since every stage writes beside it and renames; so a run
# can be stopped at any moment, killed even, and the same command goes on where it was.
#
# METHODS, RATIOS, CLASSIFIERS and SEEDS say what must be there. Tables are of all cells that the run holds, so that
# a part that is asked for never takes the place of the tables of the whole.
#
# What makes a step run again: its inputs, and its settings, which are compared by content (the
# program `settings`). The programs are no prerequisites: building them again does not throw away days
# of results. The raw recordings are compared by content, too, whatever their folder is; those that are
# not there have not changed.
#
# The front door (Makefile) builds the programs, and then has this file made into rules.

# What make calls its default shell it does without where a line asks for nothing of it, as those of steps do.
SHELL := /bin/sh
MAKEFLAGS += --no-builtin-rules --no-print-directory
Q := $(if $(V),,@)
export BIN SUBMIT
# A step that another make has done since then is not done once more (step.sh).
export ASKED_AT := $(shell date +%s.%6N)

# ---- what there is ------------------------------------------------------------------------------
$(if $(wildcard $(BIN)/settings),,$(error the programs must be built first: `make build`))
facts := $(shell $(BIN)/settings --facts)
$(if $(filter 0,$(.SHELLSTATUS)),,$(error pipeline/ cannot be used as it is, see above))
fact   = $(patsubst $1:%,%,$(filter $1:%,$(facts)))

paper_classifier  := $(call fact,paper-classifier)
paper_method      := $(call fact,paper-method)
METHODS := $(call fact,default)
RATIOS  := $(call fact,ratio)
CLASSIFIERS := $(paper_classifier)
baseline          := $(call fact,baseline)
# Not a method but a ceiling: learns from D what all others may not see. A score would compare D with
# itself, so it has none.
ceilings          := $(call fact,ceiling)
inferring         := $(call fact,infers)
# What learns of the machine's background from healthy windows, too.
hearing           := $(call fact,hears)
nothing_generated := $(call fact,nothing-generated)
# What a classifier reaches that needs neither a generator nor a training: it stands beside the baseline.
bar               := $(call fact,bar)
simulated         := $(call fact,simulated)
# The data sets of which no fault window is known, and which methods have cells by which classifiers there and
# elsewhere: METHOD/CLASSIFIER (src/run/grid.hpp).
nothing_known     := $(call fact,nothing-known)
all_pairs         := $(call fact,pair)
pairs_of_nothing  := $(call fact,pair-of-nothing)
pairs              = $(if $(filter $1,$(nothing_known)),$(pairs_of_nothing),$(all_pairs))
says_nothing_known = $(patsubst %,--nothing-known % ,$(filter $1,$(nothing_known)))

# The data sets of a group and the methods of which an input is recorded (pipeline/transfer.mk).
in_group           = $(patsubst $2/%,%,$(filter $2/%,$(call fact,group-$1)))
in_any_group       = $(notdir $(call fact,group-$1))

# ---- what is asked for --------------------------------------------------------------------------
# Where nothing else is: all groups, the methods that have an input recorded, by all inputs of WDCNN and by the bar, with
# the most windows.
ifneq (,$(filter transfer,$(MAKECMDGOALS)))
$(if $(call fact,group),,$(error make transfer: [transfer] of pipeline/protocol.toml names no group of data sets))
DATASETS    := $(filter $(call in_any_group,dataset),$(call fact,dataset))
METHODS     := $(filter $(call in_any_group,method),$(call fact,method))
RATIOS      := $(nothing_generated) $(lastword $(call fact,ratio))
CLASSIFIERS := $(filter $(paper_classifier) $(paper_classifier)-% $(bar),$(call fact,classifier))
endif
define check_words # name, words, known words
$(if $2,,$(error $1: is empty))\
$(foreach word,$(filter-out $3,$2),$(error $1: unknown '$(word)'; there are: $3))\
$(if $(filter-out $(words $2),$(words $(sort $2))),$(error $1: '$2' names one twice))
endef
$(call check_words,DATASETS,$(DATASETS),$(call fact,dataset))
$(call check_words,RATIOS,$(RATIOS),$(call fact,ratio))
$(call check_words,METHODS,$(METHODS),$(call fact,method))
$(call check_words,CLASSIFIERS,$(CLASSIFIERS),$(call fact,classifier))
$(call check_words,SEEDS,$(SEEDS),$(SEEDS))
$(if $(shell printf '%s\n' $(SEEDS) | grep -vxE '0|[1-9][0-9]*'),\
  $(error SEEDS: whole numbers from 0 up, not '$(SEEDS)'))
$(if $(findstring /,$(RUN)),$(error RUN: the name of a folder under results/, not a path: '$(RUN)'))
$(if $(filter . .. published reference,$(RUN)),$(error RUN: '$(RUN)' cannot be the name of a run))
$(if $(filter 1,$(words $(RUN))),,$(error RUN: one word, the name of a folder under results/))

# Methods that need what a description does not say of its faults. Where nobody has chosen them, the others are run.
unsaid_of   = $(foreach what,bearing rhythm size,$(if $(filter $1,$(call fact,without-$(what))),$(what)))
unsaid     := $(sort $(foreach dataset,$(DATASETS),$(call unsaid_of,$(dataset))))
cannot_run := $(filter $(foreach what,$(unsaid),$(call fact,needs-$(what))),$(METHODS))
can_run    := $(filter-out $(cannot_run),$(METHODS))
why_not     = the description of $(foreach dataset,$(DATASETS),$(if $(call unsaid_of,$(dataset)),$(dataset))) does not say what they need: \
  $(foreach what,$(unsaid),$(if $(filter-out $(firstword $(unsaid)),$(what)),and )$(patsubst size,defect_size_mm of every fault,$(patsubst rhythm,faults in a raceway or a ball (not "other"),$(patsubst bearing,[bearing],$(what)))))
# (Who only looks at a run, or as out_of_date.sh asks what would be done, may name any.)
only_asked := $(filter figures report,$(MAKECMDGOALS))$(only_asking)
ifneq (,$(cannot_run))
ifneq (,$(filter command,$(firstword $(origin METHODS))))
$(if $(only_asked),,$(error METHODS: $(cannot_run) cannot be run; $(why_not); choose METHODS="$(can_run)"))
else
$(if $(only_asked)$(LEFT_OUT_IS_SAID),,$(shell printf '%s\n' 'left out: $(cannot_run); $(why_not)' >&2))
METHODS := $(can_run)
endif
endif

# `none` is the case without generated windows, and so is the ratio 100to1.
method_ratios = $(if $(filter $(baseline),$1),$(filter $(nothing_generated),$(RATIOS)),$(filter-out $(nothing_generated),$(RATIOS)))
methods       := $(foreach method,$(METHODS),$(if $(call method_ratios,$(method)),$(method)))
generators    := $(filter-out $(baseline),$(methods))
$(if $(methods),,$(error no cells: METHODS="$(METHODS)" RATIOS="$(RATIOS)"; $(baseline) is run at $(nothing_generated) only, the others at all other ratios))

# What the paper publishes stands in the tables, and is tracked in results/, which may have been removed as a whole.
published       := $(wildcard results/published/*.csv)
shows_published := $(filter all tables figures report draw page readings,$(MAKECMDGOALS))
$(if $(only_asking)$(published),,$(if $(shows_published),$(error results/published holds no table: what the paper publishes is shown \
  beside our results; `git checkout results/published` brings it back)))

include pipeline/left_out.mk

# Since 0.1.0 every classifier has a folder (src/run/layout.cpp checks the same). Without this line make would compute
# all diagnoses of an older run again.
old_cell_of = $(firstword $(wildcard $(foreach cells,* sweep/* sweep@*/* readings/*,$1/seed*/$(cells)/*to1/diagnosis.h5)))
$(foreach folder,$(DATASETS:%=$(results)/%),$(foreach cell,$(call old_cell_of,$(folder)),$(error $(folder): \
  its cells are laid out as before 0.1.0 ($(cell:$(folder)/%=%)); pipeline/new_layout.sh $(results) moves them)))

# ---- settings -----------------------------------------------------------------------------------
# The names of the settings files, without .toml; which options that make gives count as settings, too.
settings        := $(results)/.settings
# A data set may have settings of its own for the split.
split_settings   = split$(addprefix .,$(filter $1,$(call fact,own-split)))
settings_names  := $(sort $(foreach dataset,$(DATASETS),$(call split_settings,$(dataset)))) generate score diagnose $(generators:%=train.%) $(DATASETS:%=datasets/%) $(DATASETS:%=tabulate.%)
# (Not all of what looks at cells knows of classifiers: some is about the paper's alone.)
selection       := --methods $(METHODS) --ratios $(RATIOS) --seeds $(SEEDS)
whole_selection := $(selection) --classifiers $(CLASSIFIERS)
$(foreach dataset,$(DATASETS),$(eval options.$(call split_settings,$(dataset)) := --protocol $(PROTOCOL)))

# ---- rules --------------------------------------------------------------------------------------
# What is there is complete, so make has no cause to remove it when it is interrupted: each rule calls what
# it makes precious. Make goes through all precious files whenever it is told of more of them: so those of a seed
# are noted, and told together at the end.

# A step runs a stage for the folder of its target. Its settings file is also what the stage reads. What it
# makes stands behind --output, or behind -- where that is several files.
step   = $(Q)pipeline/step.sh $(@D)
config = --config $(filter $(settings)/%,$^)

# A file of settings says of which recordings the records are. It is a prerequisite where it is there or must be
# made: records of an older project are without one, and stay. Who only looks notes nothing.
measured        := $(filter-out $(simulated),$(DATASETS))
recordings_file  = $(settings)/recordings/$1.toml
recordings_asked = 'recordings/$1.toml $(DATA_DIR)'
looks_only      := $(looks)$(only_asking)$(findstring n,$(filter-out --%,$(firstword -$(MAKEFLAGS))))
other_recordings := $(if $(measured),$(shell $(BIN)/settings --folder $(settings) $(if $(looks_only),,--note) \
  --outdated $(foreach dataset,$(measured),$(call recordings_asked,$(dataset)))))
$(if $(measured),$(if $(filter 0,$(.SHELLSTATUS)),,$(error pipeline/ cannot be used as it is, see above)))
recordings_of    = $(if $(filter recordings/$1.toml,$(other_recordings)),$(call recordings_file,$1),$(wildcard $(call recordings_file,$1)))
$(foreach dataset,$(measured),$(call recordings_file,$(dataset))): $(settings)/recordings/%.toml:
	$(Q)$(BIN)/settings --folder $(settings) --update $(call recordings_asked,$*)
$(other_recordings:%=$(settings)/%): FORCE

define records_rule # data set
.PRECIOUS: $(results)/$1/records.h5
$(results)/$1/records.h5: $(settings)/datasets/$1.toml $(call recordings_of,$1)
	$$(step) $(if $(filter $1,$(simulated)),simulate,ingest --data-dir '$(DATA_DIR)') --description $$< --output $$@
endef

# One split makes four files. What needs one of them names all, so that the loss of any one brings
# back the split before anything is computed from the others.
windows = $(patsubst %,$1/%.h5,A B C D)

# Where it only shows what it would do, make (4.3) takes the files of a group for as old as they were, and
# what is made of them for done. So there one of the four is made, and the others of it.
only_shows  := $(findstring n,$(filter-out --%,$(firstword -$(MAKEFLAGS))))
lost_windows = $(filter-out $(wildcard $(windows)),$(windows))
others_of_A  = $(filter-out %/A.h5,$(windows))

define split_rule # data set, seed, its folder
precious.$3 += $(call windows,$3)
$(if $(only_shows),$3/A.h5:,$(call windows,$3) &:) $(results)/$1/records.h5 $(settings)/$(call split_settings,$1).toml \
    $(if $(only_shows),$(if $(call lost_windows,$3),FORCE))
	$$(step) split $$(config) --records $$< --seed $2 --protocol $(PROTOCOL) --output-dir $$(@D) -- $(call windows,$3)
$(if $(only_shows),$(call others_of_A,$3): $3/A.h5 ;)
endef

define generator_rules # seed, its folder, cell; where that is not a method: the method, further options
precious.$2 += $(patsubst %,$2/$3/%.h5,model E score)
$2/$3/model.h5: $(call windows,$2) $(settings)/train.$(or $4,$3).toml
	$$(step) train $$(config) --method $(or $4,$3) $(if $5,$5 )$(if $(filter $(ceilings),$3),--real $2/D.h5 )$(if $(filter $(hearing),$(or $4,$3)),--healthy $2/B.h5 )--known $2/C.h5 --seed $1 --output $$@
$2/$3/E.h5: $2/$3/model.h5 $(settings)/generate.toml
	$$(step) generate $$(config) --model $$< --seed $1 --output $$@
$2/$3/score.h5: $2/$3/E.h5 $(call windows,$2) $(settings)/score.toml
	$$(step) score $$(config) --generated $$< --real $2/D.h5 --output $$@
endef

# Elapsed times are left out of what is stored (--reproducible), so that a cell computed again is
# equal byte for byte; the log beside it has them.
diagnoses_of = $(patsubst %,$1/%/$3/diagnosis.h5,$(call method_ratios,$2))
# diagnose takes the paper's classifier unless one is named.
by_classifier = $(if $(filter-out $(paper_classifier),$1),--classifier $1 )
define diagnosis_rule # seed, its folder, cell, classifier
precious.$2 += $(call diagnoses_of,$2/$3,$3,$4)
$(call diagnoses_of,$2/$3,$3,$4): $2/$3/%/$4/diagnosis.h5: \
    $(call windows,$2) $(if $(filter $(baseline),$3),,$2/$3/E.h5) $(settings)/diagnose.toml
	$$(step) diagnose $$(config) --test $2/A.h5 --normal $2/B.h5 --known $2/C.h5 \
	  $(if $(filter $(baseline),$3),,--generated $2/$3/E.h5 )--ratio $$* $(call by_classifier,$4)--seed $1 \
	  --reproducible --output $$@
endef

# What the paper's classifier makes of the test windows (Figs 20 and 21), of the lowest seed alone: each method
# at the ratio with the most generated windows. The training is that of the diagnosis beside it, done
# once more. It has a log of its own, as it is no cell of the grid.
features_ratio = $(lastword $(filter $(call method_ratios,$1),$(call fact,ratio)))
features_seed := $(firstword $(shell printf '%s\n' $(SEEDS) | sort -n))
has_features   = $(filter $(paper_classifier),$(call classifiers_of,$1,$2))
features       = $(foreach method,$(methods_of),$(if $(call has_features,$1,$(method)),$(results)/$1/seed$(features_seed)/$(method)/$(call features_ratio,$(method))/$(paper_classifier)/features.h5))

define features_rule # its folder, method, ratio
precious.$1 += $1/$2/$3/$(paper_classifier)/features.h5
$1/$2/$3/$(paper_classifier)/features.h5: $(call windows,$1) $(if $(filter $(baseline),$2),,$1/$2/E.h5) $(settings)/diagnose.toml
	$(Q)STEP_LOG=features pipeline/step.sh $$(@D) diagnose $$(config) --test $1/A.h5 --normal $1/B.h5 --known $1/C.h5 \
	  $(if $(filter $(baseline),$2),,--generated $1/$2/E.h5 )--ratio $3 --seed $(features_seed) --reproducible --keep-features --output $$@
endef

seed_folders = $(foreach seed,$(SEEDS),$(results)/$1/seed$(seed))
scores       = $(foreach folder,$(seed_folders),$(patsubst %,$(folder)/%/score.h5,$(filter-out $(ceilings),$(generators_of))))
diagnoses    = $(foreach folder,$(seed_folders),$(foreach method,$(methods_of),$(foreach classifier,$(call classifiers_of,$1,$(method)),\
                 $(call diagnoses_of,$(folder)/$(method),$(method),$(classifier)))))
cell_files   = $(call diagnoses,$1) $(call scores,$1)

# ---- what the run holds besides what is asked for ----------------------------------------------
held_cells = $(wildcard $1/seed*/*/score.h5 $(patsubst %,$1/seed*/*/*/%/diagnosis.h5,$(call fact,classifier)))
held_classifiers = $(or $(strip $(foreach name,$(call fact,classifier),$(if $(wildcard $1/seed*/*/*/$(name)/diagnosis.h5),$(name)))),$(paper_classifier))
# Folder of the data set, cells asked for.
besides    = $(filter-out $2,$(call held_cells,$1))

# Of what a folder holds, that which make would make again: it is neither made, as nobody has asked
# for it, nor shown. Folder of the data set, protocol, goal that has rules for what is there.
out_of_date = $(shell pipeline/out_of_date.sh $1 $(MAKE) --file=pipeline/grid.mk only_asking=yes \
  RUN='$(RUN)' DATASETS='$(notdir $1)' PROTOCOL='$2' DATA_DIR='$(DATA_DIR)' BIN='$(BIN)' \
  results='$(patsubst %/,%,$(dir $1))' METHODS='$(call fact,method)' RATIOS='$(call fact,ratio)' CLASSIFIERS='$(call held_classifiers,$1)' $3)$(if \
  $(filter 0,$(.SHELLSTATUS)),,$(error what is out of date in $1 cannot be told, see above))
# Folder, files in it, what is out of date in it: the files that are not; and of what is out of date
# that which concerns these files.
up_to_date  = $(filter-out $(addprefix $1/,$3 $(3:%=%/%)),$2)
concerning  = $(foreach name,$3,$(if $(filter $1/$(name) $1/$(name)/%,$2),$(name)))
leave_out   = $(if $(strip $1),--leave-out $(strip $1) )

# ---- tables -------------------------------------------------------------------------------------
table_names  := accuracy.csv gains.csv quality.csv comparisons.csv ranks.csv decisions.csv confidence.csv recommendation.csv tables.md tables.tex summary.txt
tables_of    = $(table_names:%=$(results)/$1/%)

# That a cell has been removed, no file's time tells: so the number of cells counts as a setting.
# Where a run is only looked at, nothing is asked for. If all of it is out of date then, it is at least of one
# kind, and shown: so is a run that was copied without its intermediate files.
shows_cells := $(looks)$(filter tables draw page $(foreach dataset,$(DATASETS),$(call tables_of,$(dataset))),$(MAKECMDGOALS))
define find_besides # data set, its folder
besides.$1  := $(if $(shows_cells),$(call besides,$2,$(if $(looks),,$(call cell_files,$1))))
left_out.$1 := $$(if $$(besides.$1),$$(call out_of_date,$2,$(PROTOCOL),cells))
left_out.$1 := $$(call concerning,$2,$$(besides.$1),$$(left_out.$1))
left_out.$1 := $$(if $$(or $(if $(looks),,all),$$(call up_to_date,$2,$$(besides.$1),$$(left_out.$1))),$$(left_out.$1))
besides.$1  := $$(call up_to_date,$2,$$(besides.$1),$$(left_out.$1))
options.tabulate.$1 := $$(words $(if $(looks),,$(call cell_files,$1)) $$(besides.$1)) cells
endef
$(foreach dataset,$(DATASETS),$(eval $(call find_besides,$(dataset),$(results)/$(dataset))))

define tables_rule # data set
.PRECIOUS: $(call tables_of,$1)
$(call tables_of,$1) &: $(call cell_files,$1) $(besides.$1) $(published) $(settings)/tabulate.$1.toml
	$$(step) tabulate $$(config) --run $(results) --dataset $1 $(whole_selection) $(call says_nothing_known,$1)$(call leave_out,$(left_out.$1))--published results/published \
	  -- $(call tables_of,$1)
endef

# A rule holds nothing that make would expand a second time, apart from what $$ defers.
$(foreach dataset,$(DATASETS),\
  $(eval $(call records_rule,$(dataset)))\
  $(eval $(call tables_rule,$(dataset)))\
  $(foreach method,$(call methods_of,$(dataset)),$(eval $(call features_rule,$(results)/$(dataset)/seed$(features_seed),$(method),$(call features_ratio,$(method)))))\
  $(foreach seed,$(SEEDS),$(eval folder := $(results)/$(dataset)/seed$(seed))\
    $(eval $(call split_rule,$(dataset),$(seed),$(folder)))\
    $(foreach method,$(call generators_of,$(dataset)),$(eval $(call generator_rules,$(seed),$(folder),$(method))))\
    $(foreach method,$(call methods_of,$(dataset)),$(foreach classifier,$(call classifiers_of,$(dataset),$(method)),\
      $(eval $(call diagnosis_rule,$(seed),$(folder),$(method),$(classifier)))))))

.DEFAULT_GOAL := cells
.PHONY: FORCE records cells features tables draw figures page report all list-cells sweep contrast identify readings transfer trust
records: $(DATASETS:%=$(results)/%/records.h5)
cells: $(foreach dataset,$(DATASETS),$(call cell_files,$(dataset)))
features: $(foreach dataset,$(DATASETS),$(call features,$(dataset)))
	@:
tables: $(foreach dataset,$(DATASETS),$(call tables_of,$(dataset)))
	@:

# make does nothing more for a target when a prerequisite has failed. So a make of its own makes the
# tables; where that fails, the cells that they lack are named.
this_make = $(MAKE) --file=pipeline/grid.mk
define show_summaries
	@cat $(DATASETS:%=$(results)/%/summary.txt)
	@printf 'tables and artefacts: %s\n' $(DATASETS:%=$(results)/%/)
endef
# Only what is asked for must be there: of a run that is looked at, only what was named. A report says what is
# missing, and shows pictures of what there is.
must_be_there := $(if $(looks),$(cells_given),$(whole_selection))
draw = $(MAKE) --file=pipeline/figures.mk results='$(results)' DATASETS='$(DATASETS)' selection='$1' \
  $(foreach dataset,$(DATASETS),'leave_out.$(dataset)=$(call leave_out,$(left_out.$(dataset)))' \
    'nothing_known.$(dataset)=$(call says_nothing_known,$(dataset))')
drawn := $(DATASETS:%=$(results)/%/figures)
draw figures: $(DATASETS:%=$(settings)/tabulate.%.toml)
	$(Q)+$(call draw,$(must_be_there))
	$(if $(looks),@ls -d $(drawn:%=%/) 2>/dev/null | sed 's/^/figures: /' | grep . || \
	  { echo '$(results) holds no cell of $(DATASETS)' >&2; exit 1; })
.PHONY: draw_all
# (Not beside `make figures`, which writes the same files.)
draw_all: $(DATASETS:%=$(settings)/tabulate.%.toml) $(filter figures,$(MAKECMDGOALS))
	$(Q)+$(call draw,) || echo 'the report is made without the figures that could not be drawn' >&2
report: draw_all
page report:
	$(Q)$(BIN)/report --run $(results) $(if $(looks),,--datasets $(DATASETS)) $(must_be_there) --published results/published \
	  $(foreach dataset,$(nothing_known),$(call says_nothing_known,$(dataset)))$(call leave_out,$(strip $(foreach dataset,$(DATASETS),$(left_out.$(dataset):%=$(dataset)/%))))
all:
	$(Q)+pipeline/tables.sh $(if $(findstring q,$(firstword -$(MAKEFLAGS))),,--show) $(this_make)
	$(show_summaries)

# For the tables of jobs in a dry run.
list-cells:
	@$(foreach dataset,$(DATASETS),$(foreach file,$(call cell_files,$(dataset)),$(info cell $(file)))):

include pipeline/sweep.mk
include pipeline/contrast.mk
include pipeline/identify.mk
include pipeline/readings.mk
include pipeline/transfer.mk
include pipeline/trust.mk

.PRECIOUS: $(foreach dataset,$(DATASETS),$(foreach folder,$(call seed_folders,$(dataset)),$(precious.$(folder))))

# ---- rules of the settings ----------------------------------------------------------------------
# Looking at the rules writes nothing. A file that does not hold what it should is written when a step
# needs it; where another make has just done so, it stays as it is.
request  = '$(strip $1.toml $(options.$1))'
outdated := $(shell $(BIN)/settings --folder $(settings) --outdated $(foreach name,$(settings_names),$(call request,$(name))))
$(if $(filter 0,$(.SHELLSTATUS)),,$(error pipeline/ cannot be used as it is, see above))

$(settings_names:%=$(settings)/%.toml): $(settings)/%.toml:
	$(Q)$(BIN)/settings --folder $(settings) --update $(call request,$*)
$(outdated:%=$(settings)/%): FORCE
.PHONY: FORCE
