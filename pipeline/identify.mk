# Whether the twin's (k, c) are those of the bearing: the models of the methods that infer them, compared
# with the truth on windows that were simulated with known ones.
#
#   model.h5, D.h5 -> identifiability.csv, scatter.csv, identifiability.md

# Of METHODS those that infer.
identify_methods  := $(filter $(inferring),$(methods))
identify_datasets := $(filter-out $(nothing_known),$(filter $(simulated),$(DATASETS)))
identify_tables    = $(addprefix $(results)/$1/,identifiability.csv scatter.csv identifiability.md)

ifneq (,$(filter identify,$(MAKECMDGOALS)))
$(if $(identify_datasets),,$(error make identify: DATASETS must have one that is simulated ($(filter-out $(nothing_known),$(simulated))), whose (k, c) are known))
$(if $(identify_methods),,$(error make identify: METHODS must have one of $(inferring)))

identify_choice := --methods $(identify_methods) --seeds $(SEEDS)
settings_names += $(identify_datasets:%=identify.%)

# Of all models that the run holds, as the tables of the grid are of all its cells (pipeline/grid.mk).
identify_models = $(foreach folder,$(call seed_folders,$1),$(identify_methods:%=$(folder)/%/model.h5))
held_models     = $(wildcard $(inferring:%=$1/seed*/%/model.h5))
define find_other_models # data set, its folder
other_models.$1     := $(filter-out $(call identify_models,$1),$(call held_models,$2))
models_left_out.$1  := $$(if $$(other_models.$1),$$(call out_of_date,$2,$(PROTOCOL),identify))
models_left_out.$1  := $$(call concerning,$2,$$(other_models.$1),$$(models_left_out.$1))
other_models.$1     := $$(call up_to_date,$2,$$(other_models.$1),$$(models_left_out.$1))
options.identify.$1 := $$(words $(call identify_models,$1) $$(other_models.$1)) models
endef
$(if $(only_asking),,$(foreach dataset,$(identify_datasets),$(eval $(call find_other_models,$(dataset),$(results)/$(dataset)))))

define identify_rule # data set
.PRECIOUS: $(call identify_tables,$1)
$(call identify_tables,$1) &: $(settings)/identify.$1.toml $(call identify_models,$1) $(other_models.$1) \
    $(foreach folder,$(call seed_folders,$1),$(call windows,$(folder)))
	$$(step) identify $$(config) --run $(results) --dataset $1 $(call leave_out,$(models_left_out.$1))$(identify_choice) \
	  -- $(call identify_tables,$1)
endef
$(foreach dataset,$(identify_datasets),$(eval $(call identify_rule,$(dataset))))

identify: $(foreach dataset,$(identify_datasets),$(call identify_tables,$(dataset)))
	@cat $(filter %.md,$^)
endif
