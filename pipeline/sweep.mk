# The hyper-parameters (paper, Section 4.5.5 and Fig. 19): one setting of piae-dt at a time is moved,
# all others stay where pipeline/protocol.toml has them.
#
#   A B C D -> sweep/<factor>-<value>/model.h5 -> E.h5 -> score.h5
#                                           \----------\-> <ratio>/diagnosis.h5 -> sweep.csv, sweep.md
#
# What is tried stands in [sweep] of the protocol. The value that the protocol has anyway is not
# computed again: its cells are those of the grid.

# The paper does not say at which ratio it compared. At 1:1 generated windows weigh most.
sweep_ratios := $(filter-out $(nothing_generated),$(if $(filter command,$(origin RATIOS)),$(RATIOS),1to1))

# (Of a job on a cluster the goals are files.)
ifneq (,$(filter sweep,$(MAKECMDGOALS))$(findstring /sweep,$(MAKECMDGOALS:$(results)/%=%)))

$(if $(filter-out $(RATIOS),$(sweep_ratios))$(if $(sweep_ratios),,x),$(error make sweep: RATIOS must have others than $(nothing_generated), at which nothing is generated))
swept := $(call fact,swept)
$(if $(filter $(swept),$(generators)),,$(error make sweep moves the settings of $(swept): METHODS must have it))
$(if $(call fact,sweep-point),,$(error make sweep: no points in [sweep] of pipeline/protocol.toml))

sweep_centre := $(call fact,sweep-centre)
sweep_moved  := $(filter-out $(sweep_centre),$(call fact,sweep-point))
sweep_cells  := $(swept) $(foreach point,$(sweep_moved),sweep/$(subst =,-,$(point)))
sweep_choice := $(addprefix --centre ,$(sweep_centre)) --ratios $(sweep_ratios) --seeds $(SEEDS)

settings_names += $(DATASETS:%=sweep.%)

sweep_scores    = $(foreach folder,$(seed_folders),$(sweep_cells:%=$(folder)/%/score.h5))
sweep_diagnoses = $(foreach folder,$(seed_folders),$(foreach cell,$(sweep_cells),\
                    $(sweep_ratios:%=$(folder)/$(cell)/%/diagnosis.h5)))
# The table is of all that the run holds, as those of the grid are (pipeline/grid.mk).
held_sweep      = $(wildcard $1/seed*/sweep/*/*/diagnosis.h5 $1/seed*/$(swept)/*/diagnosis.h5)
sweep_tables    = $(results)/$1/sweep.csv $(results)/$1/sweep.md

define find_swept_besides # data set, its folder
swept_besides.$1  := $(filter-out $(call sweep_diagnoses,$1),$(call held_sweep,$2))
swept_left_out.$1 := $$(if $$(swept_besides.$1),$$(call out_of_date,$2,$(PROTOCOL),sweep))
swept_left_out.$1 := $$(call concerning,$2,$$(swept_besides.$1),$$(swept_left_out.$1))
swept_besides.$1  := $$(call up_to_date,$2,$$(swept_besides.$1),$$(swept_left_out.$1))
options.sweep.$1  := $$(words $(call sweep_diagnoses,$1) $$(swept_besides.$1)) cells, $(addprefix --centre ,$(sweep_centre))
endef
$(if $(only_asking),,$(foreach dataset,$(DATASETS),$(eval $(call find_swept_besides,$(dataset),$(results)/$(dataset)))))

define sweep_rule # data set
.PRECIOUS: $(call sweep_tables,$1)
$(call sweep_tables,$1) &: $(call sweep_diagnoses,$1) $(swept_besides.$1) $(settings)/sweep.$1.toml
	$$(step) sweep $$(config) --run $(results) --dataset $1 $(call leave_out,$(swept_left_out.$1))$(sweep_choice) \
	  -- $(call sweep_tables,$1)
endef

define moved_rules # seed, its folder, factor, value
$(call generator_rules,$1,$2,sweep/$3-$4,$(swept),--$3 $4)
$(call diagnosis_rule,$1,$2,sweep/$3-$4,$(paper_classifier))
endef

$(foreach dataset,$(DATASETS),\
  $(eval $(call sweep_rule,$(dataset)))\
  $(foreach seed,$(SEEDS),$(eval folder := $(results)/$(dataset)/seed$(seed))\
    $(foreach point,$(sweep_moved),\
      $(eval $(call moved_rules,$(seed),$(folder),$(firstword $(subst =, ,$(point))),$(lastword $(subst =, ,$(point))))))))

sweep: $(foreach dataset,$(DATASETS),$(call sweep_scores,$(dataset)) $(call sweep_tables,$(dataset)))
	@cat $(filter %/sweep.md,$^)

endif
