# Whether the twin's (k, c) are those of the bearing: the models of the methods that infer them, compared
# with the truth on windows that were simulated with known ones.
#
#   model.h5, D.h5 -> identifiability.csv, scatter.csv, identifiability.md

# Of METHODS those that infer.
identify_methods  := $(filter $(inferring),$(methods))
identify_datasets := $(filter $(simulated),$(DATASETS))
identify_tables    = $(addprefix $(results)/$1/,identifiability.csv scatter.csv identifiability.md)

ifneq (,$(filter identify,$(MAKECMDGOALS)))
$(if $(identify_datasets),,$(error make identify: DATASETS must have one that is simulated ($(simulated)), whose (k, c) are known))
$(if $(identify_methods),,$(error make identify: METHODS must have one of $(inferring)))

identify_choice := --methods $(identify_methods) --seeds $(SEEDS)
settings_names += $(identify_datasets:%=identify.%)
$(foreach dataset,$(identify_datasets),$(eval options.identify.$(dataset) := $(identify_choice)))

define identify_rule # data set
$(call identify_tables,$1) &: $(settings)/identify.$1.toml \
    $(foreach folder,$(call seed_folders,$1),$(call windows,$(folder)) $(identify_methods:%=$(folder)/%/model.h5))
	$$(step) identify $$(config) --run $(results) --dataset $1 $(identify_choice)
endef
$(foreach dataset,$(identify_datasets),$(eval $(call identify_rule,$(dataset))))

identify: $(foreach dataset,$(identify_datasets),$(call identify_tables,$(dataset)))
	@cat $(filter %.md,$^)
endif
