# The hyper-parameters (paper, Section 4.5.5 and Fig. 19): one setting of piae-dt at a time is moved,
# all others stay where pipeline/protocol.toml has them.
#
#   A B C D -> sweep/<factor>-<value>/model.h5 -> E.h5 -> score.h5
#                                           \----------\-> <ratio>/diagnosis.h5 -> sweep.csv, sweep.md
#
# The value of the protocol is no cell of its own: there, piae-dt's of the grid are taken.

# Factors are options of train. Values: the project's notes; those that the paper's text names are among
# them (batch 1, 5, 10; depth 1, 3, 4, 5; learning rate 1e-4, 5e-4, 1e-3; loss weights by methods 1, 2, 3).
sweep_factors       := batch depth loss-weights learning-rate
sweep_batch         := 1 2 5 10 20
sweep_depth         := 1 2 3 4 5 6
sweep_loss-weights  := adaptive adaptive-without-log fixed
sweep_learning-rate := 1e-4 2e-4 5e-4 1e-3 5e-3

# The paper does not say at which ratio it compared. At 1:1 generated windows weigh most.
sweep_ratios := $(filter-out 100to1,$(if $(filter command,$(origin RATIOS)),$(RATIOS),1to1))

ifneq (,$(findstring sweep,$(MAKECMDGOALS)))

$(if $(filter-out $(RATIOS),$(sweep_ratios))$(if $(sweep_ratios),,x),$(error make sweep: RATIOS must have others than 100to1, at which nothing is generated))
$(if $(filter piae-dt,$(generators)),,$(error make sweep moves the settings of piae-dt: METHODS must have it))

# The value of a factor in the protocol, as piae-dt's settings file has it.
protocol_value = $(shell sed -n 's/^$1 *= *"\?\([^"]*\)"\?$$/\1/p' $(settings)/train.piae-dt.toml | tail -n 1)

sweep_points := $(foreach factor,$(sweep_factors),$(addprefix $(factor)=,$(sweep_$(factor))))
sweep_centre := $(filter $(foreach factor,$(sweep_factors),$(factor)=$(call protocol_value,$(factor))),$(sweep_points))
sweep_moved  := $(filter-out $(sweep_centre),$(sweep_points))
sweep_cells  := piae-dt $(foreach point,$(sweep_moved),sweep/$(subst =,-,$(point)))
sweep_choice := --points $(sweep_points) $(addprefix --centre ,$(sweep_centre)) --ratios $(sweep_ratios) --seeds $(SEEDS)

$(shell pipeline/settings.sh $(settings) $(foreach dataset,$(DATASETS),'sweep.$(dataset).toml|$(protocol)|sweep|$(sweep_choice)'))
$(if $(filter 0,$(.SHELLSTATUS)),,$(error the settings could not be written to $(settings)))

sweep_scores    = $(foreach folder,$(seed_folders),$(sweep_cells:%=$(folder)/%/score.h5))
sweep_diagnoses = $(foreach folder,$(seed_folders),$(foreach cell,$(sweep_cells),\
                    $(sweep_ratios:%=$(folder)/$(cell)/%/diagnosis.h5)))
sweep_tables    = $(results)/$1/sweep.csv $(results)/$1/sweep.md

define sweep_rule # data set
$(call sweep_tables,$1) &: $(call sweep_diagnoses,$1) $(settings)/sweep.$1.toml | $(programs)
	$$(step) sweep $$(config) --run $(results) --dataset $1 $(sweep_choice)
endef

define moved_rules # seed, its folder, factor, value
$(call generator_rules,$1,$2,sweep/$3-$4,piae-dt,--$3 $4)
$(call diagnosis_rule,$1,$2,sweep/$3-$4)
endef

$(foreach dataset,$(DATASETS),\
  $(eval $(call sweep_rule,$(dataset)))\
  $(foreach seed,$(SEEDS),$(eval folder := $(results)/$(dataset)/seed$(seed))\
    $(foreach factor,$(sweep_factors),\
      $(foreach value,$(patsubst $(factor)=%,%,$(filter $(factor)=%,$(sweep_moved))),\
        $(eval $(call moved_rules,$(seed),$(folder),$(factor),$(value)))))))

sweep: $(foreach dataset,$(DATASETS),$(call sweep_scores,$(dataset)) $(call sweep_tables,$(dataset)))
	@cat $(filter %/sweep.md,$^)

endif
