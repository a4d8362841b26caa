# The experiment as a graph: data set x seed x method x ratio.
#
#   records.h5 -> A B C D -> model.h5 -> E.h5 -> score.h5
#                        \-------------------\-> <ratio>/diagnosis.h5 -> accuracy.csv, tables.md, ...
#
# A file under its final name is complete, since every stage writes beside it and renames; so a run
# can be stopped at any moment, killed even, and the same command goes on where it was.
#
# What makes a step run again: its inputs, and its settings, which are compared by content
# (pipeline/settings.sh). The programs come after a bar, as order-only prerequisites: building them
# again does not throw away days of results. The raw recordings are no prerequisites either: where
# the description gives their sha256 sums, ingest refuses any other file.

# The registry is the one place that knows the methods.
known_methods  := none $(shell sed -n 's/^ *{"\([a-z0-9-]*\)", \(make<\|\[\] {\).*/\1/p' src/augment/registry.cpp)
ratio_names    := 100to1 50to1 25to1 10to1 5to1 2to1 1to1
known_datasets := $(basename $(notdir $(wildcard pipeline/datasets/*.toml)))
simulated      := $(basename $(notdir $(shell grep -ls '^\[simulation' pipeline/datasets/*.toml)))

results := results/$(RUN)$(patsubst %,-%,$(filter blocked,$(PROTOCOL)))
# The same choice for another make.
choice  = $(foreach name,RUN DATASETS METHODS RATIOS SEEDS PROTOCOL BIN,'$(name)=$($(name))')

# The rules below are made only when a goal needs them: anything but these.
ifneq (,$(filter-out help deps build bench test data clean status check reference,$(MAKECMDGOALS)))

define check_words # name, words, known words
$(foreach word,$(filter-out $3,$2),$(error $1: unknown '$(word)'; there are: $3))\
$(if $(filter-out $(words $2),$(words $(sort $2))),$(error $1: '$2' names one twice))
endef
$(call check_words,DATASETS,$(DATASETS),$(known_datasets))
$(call check_words,RATIOS,$(RATIOS),$(ratio_names))
$(call check_words,PROTOCOL,$(PROTOCOL),random blocked)
$(call check_words,METHODS,$(METHODS),$(known_methods))
$(if $(filter 1,$(words $(PROTOCOL))),,$(error PROTOCOL: one of random and blocked))
$(foreach name,DATASETS METHODS RATIOS SEEDS,$(if $($(name)),,$(error $(name): is empty)))
$(if $(shell printf '%s\n' $(SEEDS) | grep -vxE '0|[1-9][0-9]*'),\
  $(error SEEDS: whole numbers from 0 up, not '$(SEEDS)'))
$(if $(filter-out $(words $(SEEDS)),$(words $(sort $(SEEDS)))),$(error SEEDS: '$(SEEDS)' names one twice))
$(if $(findstring /,$(RUN)),$(error RUN: the name of a folder under results/, not a path: '$(RUN)'))
$(if $(filter . .. published reference,$(RUN)),$(error RUN: '$(RUN)' cannot be the name of a run))
$(if $(filter 1,$(words $(RUN))),,$(error RUN: one word, the name of a folder under results/))

settings := $(results)/.settings

# `none` is the case without generated windows, and so is the ratio 100to1.
method_ratios = $(if $(filter none,$1),$(filter 100to1,$(RATIOS)),$(filter-out 100to1,$(RATIOS)))
methods       := $(foreach method,$(METHODS),$(if $(call method_ratios,$(method)),$(method)))
generators    := $(filter-out none,$(methods))
$(if $(methods),,$(error no cells: METHODS="$(METHODS)" RATIOS="$(RATIOS)"; none is run at 100to1 only, the others at all other ratios))

# ---- settings -----------------------------------------------------------------------------------
# file|source|tables|options that make gives on the command line
protocol       := pipeline/protocol.toml
# A table that nothing reads is a name mistyped.
$(call check_words,$(protocol),$(shell sed -n 's/^[ \t]*\[\([^]]*\)\].*/\1/p' $(protocol)),\
  split generate score diagnose tabulate train $(patsubst %,train.%,$(known_methods)))
selection      := --methods $(METHODS) --ratios $(RATIOS) --seeds $(SEEDS)
settings_files := \
  $(foreach dataset,$(DATASETS),'datasets/$(dataset).toml|pipeline/datasets/$(dataset).toml||') \
  $(foreach method,$(generators),'train.$(method).toml|$(protocol)|train train.$(method)|') \
  $(foreach stage,generate score diagnose,'$(stage).toml|$(protocol)|$(stage)|') \
  'split.toml|$(protocol)|split|--protocol $(PROTOCOL)' \
  $(foreach dataset,$(DATASETS),'tabulate.$(dataset).toml|$(protocol)|tabulate|$(selection)')
$(shell pipeline/settings.sh $(settings) $(settings_files))
$(if $(filter 0,$(.SHELLSTATUS)),,$(error the settings could not be written to $(settings)))

# ---- rules --------------------------------------------------------------------------------------
# What is there is complete, so make has no cause to remove it when it is interrupted.
.PRECIOUS: %.h5

# A step runs a stage for the folder of its target. Its settings file is also what the stage reads.
step   = $(Q)pipeline/step.sh $(@D)
config = --config $(filter $(settings)/%,$^)

define records_rule # data set
$(results)/$1/records.h5: $(settings)/datasets/$1.toml | $(programs)
	$$(step) $(if $(filter $1,$(simulated)),simulate,ingest --data-dir '$(DATA_DIR)') --description $$< --output $$@
endef

# One split makes four files. What needs one of them names all, so that the loss of any one brings
# back the split before anything is judged by the others.
windows = $(patsubst %,$1/%.h5,A B C D)

define split_rule # data set, seed, its folder
$(call windows,$3) &: $(results)/$1/records.h5 $(settings)/split.toml | $(programs)
	$$(step) split $$(config) --records $$< --seed $2 --protocol $(PROTOCOL) --output-dir $$(@D)
endef

# Not a method but a ceiling: learns from D what all others may not see. A score would compare D with
# itself, so it has none.
ceilings := oracle

define generator_rules # seed, its folder, cell; where that is not a method: the method, further options
$2/$3/model.h5: $(call windows,$2) $(settings)/train.$(or $4,$3).toml | $(programs)
	$$(step) train $$(config) --method $(or $4,$3) $(if $5,$5 )$(if $(filter $(ceilings),$3),--real $2/D.h5 )--known $2/C.h5 --seed $1 --output $$@
$2/$3/E.h5: $2/$3/model.h5 $(settings)/generate.toml | $(programs)
	$$(step) generate $$(config) --model $$< --seed $1 --output $$@
$2/$3/score.h5: $2/$3/E.h5 $(call windows,$2) $(settings)/score.toml | $(programs)
	$$(step) score $$(config) --generated $$< --real $2/D.h5 --output $$@
endef

# Elapsed times are left out of what is stored (--reproducible), so that a cell computed again is
# equal byte for byte; the log beside it has them.
define diagnosis_rule # seed, its folder, cell
$(patsubst %,$2/$3/%/diagnosis.h5,$(call method_ratios,$3)): $2/$3/%/diagnosis.h5: \
    $(call windows,$2) $(if $(filter none,$3),,$2/$3/E.h5) $(settings)/diagnose.toml | $(programs)
	$$(step) diagnose $$(config) --test $2/A.h5 --normal $2/B.h5 --known $2/C.h5 \
	  $(if $(filter none,$3),,--generated $2/$3/E.h5 )--ratio $$* --seed $1 --reproducible --output $$@
endef

seed_folders = $(foreach seed,$(SEEDS),$(results)/$1/seed$(seed))
scores       = $(foreach folder,$(seed_folders),$(patsubst %,$(folder)/%/score.h5,$(filter-out $(ceilings),$(generators))))
diagnoses    = $(foreach folder,$(seed_folders),$(foreach method,$(methods),\
                 $(patsubst %,$(folder)/$(method)/%/diagnosis.h5,$(call method_ratios,$(method)))))
cell_files   = $(call diagnoses,$1) $(call scores,$1)
lost_files   = $(filter-out $(wildcard $(cell_files)),$(cell_files))
old_files    = $(wildcard $(filter $(file <$(NOT_MADE)),$(cell_files)))
table_names := accuracy.csv quality.csv comparisons.csv tables.md
tabulate     = $(Q)pipeline/step.sh $(results)/$1 tabulate $(config) \
  --run $(results) --dataset $1 $(selection) --published results/published

# Asked for tables with holes, the same step names the holes and makes none. Cells that are there but
# were to be made again are holes, too: NOT_MADE is a file that lists what could not be made.
define tables_rule # data set
$(table_names:%=$(results)/$1/%) &: $(call cell_files,$1) \
    $(wildcard results/published/*.csv) $(settings)/tabulate.$1.toml | $(programs)
	$$(call tabulate,$1)
.PHONY: $1.holes
$1.holes: $(settings)/tabulate.$1.toml
	$$(if $$(call lost_files,$1)$$(call old_files,$1),\
	  $$(call tabulate,$1) $$(addprefix --outdated ,$$(call old_files,$1)),@:)
endef

# A rule holds nothing that make would expand a second time, apart from what $$ defers.
$(foreach dataset,$(DATASETS),\
  $(eval $(call records_rule,$(dataset)))\
  $(eval $(call tables_rule,$(dataset)))\
  $(foreach seed,$(SEEDS),$(eval folder := $(results)/$(dataset)/seed$(seed))\
    $(eval $(call split_rule,$(dataset),$(seed),$(folder)))\
    $(foreach method,$(generators),$(eval $(call generator_rules,$(seed),$(folder),$(method))))\
    $(foreach method,$(methods),$(eval $(call diagnosis_rule,$(seed),$(folder),$(method))))))

records: $(DATASETS:%=$(results)/%/records.h5)
cells: $(foreach dataset,$(DATASETS),$(call cell_files,$(dataset)))
tables: $(foreach dataset,$(DATASETS),$(table_names:%=$(results)/$(dataset)/%))
	@:
holes: $(DATASETS:%=%.holes)

# make does nothing more for a target when a prerequisite has failed. So a make of its own makes the
# tables; where that fails, another has the holes named.
all demo: | $(programs)
	$(Q)+pipeline/tables.sh $(MAKE) $(choice)
	@awk 'FNR == 1 { show = 1 } /^## / { show = /^## Accuracy o/ } show' $(DATASETS:%=$(results)/%/tables.md)
	@printf 'tables and artefacts: %s (gains, ranks and quality in its tables.md)\n' $(DATASETS:%=$(results)/%/)

include pipeline/sweep.mk
include pipeline/contrast.mk
include pipeline/identify.mk

endif
