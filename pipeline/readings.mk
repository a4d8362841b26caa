# Readings of the paper: settings of piae-dt where its words leave a choice, one or several at a time. What
# is tried stands in [readings] of pipeline/protocol.toml, on seeds that no result is reported of.
#
#   A B C D -> readings/<name>/model.h5 -> E.h5 -> score.h5
#                                      \----------\-> <ratio>/<classifier>/diagnosis.h5 -> readings.csv, .md, .svg
#
# A reading has all settings of base but those that its name says otherwise, so that it stays what it is when
# the settings of piae-dt change.

readings_ratios := $(filter-out $(nothing_generated),$(if $(filter command,$(origin RATIOS)),$(RATIOS),10to1 1to1))

# (Of a job on a cluster the goals are files.)
ifneq (,$(filter readings,$(MAKECMDGOALS))$(findstring /readings,$(MAKECMDGOALS:$(results)/%=%)))

$(if $(readings_ratios),,$(error make readings: RATIOS must have others than $(nothing_generated), at which nothing is generated))
$(if $(call fact,reading),,$(error make readings: [readings] of pipeline/protocol.toml names none))
$(foreach dataset,$(DATASETS),$(if $(filter $(paper_method)/$(paper_classifier),$(call pairs,$(dataset))),,$(error make \
  readings: $(dataset): no fault window is known, and $(paper_method) learns from those)))
readings_base := $(call fact,reading-base)
all_readings  := base $(call fact,reading)

# "batches=class+space=class": its settings, the options of train, the folder of its cells.
settings_of    = $(if $(filter base,$1),,$(subst +, ,$1))
factor_of      = $(firstword $(subst =, ,$1))
not_said_by    = $(foreach setting,$(readings_base),$(if $(filter $(call factor_of,$(setting))=%,$1),,$(setting)))
reading_train  = $(foreach setting,$1 $(call not_said_by,$1),--$(subst =, ,$(setting)))
reading_folder = readings/$(subst =,-,$1)

# Readings are ranked by what they are worth on recordings, where there are any.
readings_real  := $(filter-out $(simulated),$(DATASETS))

settings_names += $(DATASETS:%=readings.%)
readings_tables = $(results)/$1/readings.csv $(results)/$1/readings.md
readings_cells  = $(foreach folder,$(seed_folders),$(foreach reading,$(all_readings),\
                    $(folder)/$(call reading_folder,$(reading))/score.h5 \
                    $(readings_ratios:%=$(folder)/$(call reading_folder,$(reading))/%/$(paper_classifier)/diagnosis.h5)))

# The table is of the seeds and ratios that are asked for, so these are settings of it.
readings_choice := --ratios $(readings_ratios) --seeds $(SEEDS)
$(foreach dataset,$(DATASETS),$(eval options.readings.$(dataset) := $(readings_choice)))

define readings_rule # data set
.PRECIOUS: $(call readings_tables,$1)
$(call readings_tables,$1) &: $(call readings_cells,$1) $(published) \
                              $(settings)/readings.$1.toml
	$$(step) readings $$(config) --run $(results) --dataset $1 $(readings_choice) \
	  --published results/published -- $(call readings_tables,$1)
$(results)/$1/readings.svg $(results)/$1/readings.pdf &: $(results)/$1/readings.csv $(wildcard pipeline/figures/*)
	$$(Q)pipeline/figures/draw.sh $$<
endef

define reading_rules # seed, its folder, reading
$(call generator_rules,$1,$2,$(call reading_folder,$3),$(paper_method),$(call reading_train,$(call settings_of,$3)))
$(call diagnosis_rule,$1,$2,$(call reading_folder,$3),$(paper_classifier))
endef

$(foreach dataset,$(DATASETS),\
  $(eval $(call readings_rule,$(dataset)))\
  $(foreach seed,$(SEEDS),$(eval folder := $(results)/$(dataset)/seed$(seed))\
    $(foreach reading,$(all_readings),$(eval $(call reading_rules,$(seed),$(folder),$(reading))))))

readings: $(foreach dataset,$(DATASETS),$(call readings_tables,$(dataset)) $(results)/$(dataset)/readings.svg)
	@cat $(filter %/readings.md,$^)
	@echo 'Mean accuracy over $(or $(readings_real),$(DATASETS)) and $(readings_ratios), percent:'
	@awk -f pipeline/rank_readings.awk $(patsubst %,$(results)/%/readings.csv,$(or $(readings_real),$(DATASETS)))

endif
