# One setting of a method at a time is moved, all others stay where pipeline/protocol.toml has them: the
# hyper-parameters of the paper's method (Section 4.5.5 and Fig. 19), and what each part of another is worth.
#
#   A B C D -> sweep/<factor>-<value>/model.h5 -> E.h5 -> score.h5
#                                           \----------\-> <ratio>/<classifier>/diagnosis.h5 -> sweep.csv, sweep.md
#
# What is tried stands in [sweep] of the protocol, for the paper's method, and in [sweep.METHOD] for others,
# which have the classifier that it names, and sweep@METHOD wherever the paper's has sweep. Those of METHODS
# are swept that have such a table. The value that the protocol has anyway is not computed again: its cells
# are those of the grid.

# The paper does not say at which ratio it compared. At 1:1 generated windows weigh most.
sweep_ratios := $(filter-out $(nothing_generated),$(if $(filter command,$(origin RATIOS)),$(RATIOS),1to1))

# (Of a job on a cluster the goals are files.)
ifneq (,$(filter sweep,$(MAKECMDGOALS))$(findstring /sweep,$(MAKECMDGOALS:$(results)/%=%)))

$(if $(filter-out $(RATIOS),$(sweep_ratios))$(if $(sweep_ratios),,x),$(error make sweep: RATIOS must have others than $(nothing_generated), at which nothing is generated))
swept := $(filter $(generators),$(call fact,swept))
$(if $(call fact,swept),,$(error make sweep: no points in [sweep] of pipeline/protocol.toml))
$(if $(swept),,$(error make sweep moves the settings of $(call fact,swept): METHODS must have one of them))

sweep_judge = $(call fact,sweep-classifier:$1)
# Of a data set: those that have cells by the classifier of their sweep there.
swept_of = $(strip $(foreach method,$(swept),$(if $(filter $(method)/$(call sweep_judge,$(method)),$(call pairs,$1)),$(method))))
$(foreach dataset,$(DATASETS),$(if $(call swept_of,$(dataset)),,$(error make sweep: $(dataset): no fault window is known, and \
  none of $(swept) works there by the classifier of its sweep)))

# Of a method: what its sweep is called, points, cells.
sweep_name   = sweep$(addprefix @,$(filter-out $(paper_method),$1))
sweep_centre = $(call fact,sweep-centre:$1)
sweep_moved  = $(filter-out $(call sweep_centre,$1),$(call fact,sweep-point:$1))
moved_cell   = $(call sweep_name,$1)/$(subst =,-,$2)
sweep_cells  = $1 $(foreach point,$(call sweep_moved,$1),$(call moved_cell,$1,$(point)))
centres      = $(addprefix --centre ,$(call sweep_centre,$1))
sweep_choice = $(addprefix --method ,$(filter-out $(paper_method),$1)) $(call centres,$1) --ratios $(sweep_ratios) --seeds $(SEEDS)

settings_names += $(foreach dataset,$(DATASETS),$(foreach method,$(call swept_of,$(dataset)),$(call sweep_name,$(method)).$(dataset)))

# Of a data set and a method.
sweep_scores    = $(foreach folder,$(seed_folders),$(patsubst %,$(folder)/%/score.h5,$(call sweep_cells,$2)))
sweep_diagnoses = $(foreach folder,$(seed_folders),$(foreach cell,$(call sweep_cells,$2),\
                    $(sweep_ratios:%=$(folder)/$(cell)/%/$(call sweep_judge,$2)/diagnosis.h5)))
sweep_tables    = $(addprefix $(results)/$1/$(call sweep_name,$2),.csv .md)
# The table is of all that the run holds, as those of the grid are (pipeline/grid.mk). Folder of the data set, method.
held_sweep      = $(foreach cells,$(call sweep_name,$2)/* $2,$(wildcard $1/seed*/$(cells)/*/$(call sweep_judge,$2)/diagnosis.h5))

define find_swept_besides # data set, method, name of the sweep, folder of the data set
besides.$3.$1  := $(filter-out $(call sweep_diagnoses,$1,$2),$(call held_sweep,$4,$2))
left_out.$3.$1 := $$(if $$(besides.$3.$1),$$(call out_of_date,$4,$(PROTOCOL),sweep))
left_out.$3.$1 := $$(call concerning,$4,$$(besides.$3.$1),$$(left_out.$3.$1))
besides.$3.$1  := $$(call up_to_date,$4,$$(besides.$3.$1),$$(left_out.$3.$1))
options.$3.$1  := $$(words $(call sweep_diagnoses,$1,$2) $$(besides.$3.$1)) cells, $(call centres,$2)
endef
$(if $(only_asking),,$(foreach dataset,$(DATASETS),$(foreach method,$(call swept_of,$(dataset)),\
  $(eval $(call find_swept_besides,$(dataset),$(method),$(call sweep_name,$(method)),$(results)/$(dataset))))))

# Each table has a log of its own, as there may be several.
define sweep_rule # data set, method, name of the sweep
.PRECIOUS: $(call sweep_tables,$1,$2)
$(call sweep_tables,$1,$2) &: $(call sweep_diagnoses,$1,$2) $(besides.$3.$1) $(settings)/$3.$1.toml
	$(Q)$(if $(filter-out sweep,$3),STEP_LOG=$3 )pipeline/step.sh $$(@D) sweep $$(config) --run $(results) --dataset $1 $(call leave_out,$(left_out.$3.$1))$(call sweep_choice,$2) \
	  -- $(call sweep_tables,$1,$2)
endef

define moved_rules # seed, its folder, method, point
$(call generator_rules,$1,$2,$(call moved_cell,$3,$4),$3,--$(subst =, ,$4))
$(call diagnosis_rule,$1,$2,$(call moved_cell,$3,$4),$(call sweep_judge,$3))
endef

# Where the grid is not asked for this classifier, it has no rule for the cells of the method itself.
define centre_rule # seed, its folder, method, data set
$(if $(filter $(call sweep_judge,$3),$(call classifiers_of,$4,$3)),,$(call diagnosis_rule,$1,$2,$3,$(call sweep_judge,$3)))
endef

$(foreach dataset,$(DATASETS),$(foreach method,$(call swept_of,$(dataset)),\
  $(eval $(call sweep_rule,$(dataset),$(method),$(call sweep_name,$(method))))\
  $(foreach seed,$(SEEDS),$(eval folder := $(results)/$(dataset)/seed$(seed))\
    $(eval $(call centre_rule,$(seed),$(folder),$(method),$(dataset)))\
    $(foreach point,$(call sweep_moved,$(method)),\
      $(eval $(call moved_rules,$(seed),$(folder),$(method),$(point)))))))

sweep: $(foreach dataset,$(DATASETS),$(foreach method,$(call swept_of,$(dataset)),\
         $(call sweep_scores,$(dataset),$(method)) $(call sweep_tables,$(dataset),$(method))))
	@cat $(filter %.md,$^)

endif
