# What a condition is worth in points of accuracy: two runs side by side that differ in it alone.
#
# They are of all cells by the paper's classifier that both runs hold; METHODS, RATIOS and SEEDS say which must be there.
#
#   RUN and RUN-blocked      -> <dataset>/protocols.md      the overlap of windows in the split `random`
#   cwru-as-published, cwru  -> cwru-as-published/rates.md  the mixed sample rates; where both are in
#                                                           DATASETS
#
# Each protocol has a make of its own for its cells. The tables cost nothing and are made each time.

one_protocol = $(MAKE) --file=pipeline/grid.mk PROTOCOL=$1 results=$2 CLASSIFIERS=$(paper_classifier) cells
# Folder and name of the table, the two runs' folders.
contrast     = $(Q)pipeline/step.sh $1 contrast --with $3 --without $4 \
  $(call contrast_choice,$3) $(call leave_out,$(sort $(call out_of_date_side,$3) $(call out_of_date_side,$4)))--output $1/$2.md
# Of what a side holds besides what is asked for, that which is out of date.
# Folder of the data set: of METHODS those that have cells by that classifier.
contrast_methods = $(strip $(foreach method,$(METHODS),$(if $(filter $(method)/$(paper_classifier),$(call pairs,$(notdir $1))),$(method))))
contrast_choice  = --methods $(contrast_methods) --ratios $(RATIOS) --seeds $(SEEDS)
asked_in     = $(patsubst $(results)/$(notdir $1)/%,$1/%,$(call cell_files,$(notdir $1)))
besides_in   = $(call besides,$1,$(call asked_in,$1))
protocol_of  = $(if $(filter $(run_folder)-blocked/%,$1),blocked,random)
out_of_date_side = $(if $(besides_in),$(call \
  concerning,$1,$(besides_in),$(call out_of_date,$1,$(protocol_of),cells)))
both_rates   = $(filter 2,$(words $(filter cwru cwru-as-published,$(DATASETS))))
run_folder   = results/$(RUN)
contrast_tables = $(DATASETS:%=$(run_folder)/%/protocols.md) \
  $(if $(both_rates),$(run_folder)/cwru-as-published/rates.md)

define newline


endef

contrast:
	$(Q)+$(call one_protocol,random,$(run_folder))
	$(Q)+$(call one_protocol,blocked,$(run_folder)-blocked)
	$(foreach dataset,$(DATASETS),$(call \
	  contrast,$(run_folder)/$(dataset),protocols,$(run_folder)/$(dataset),$(run_folder)-blocked/$(dataset))$(newline))
	$(if $(both_rates),$(call \
	  contrast,$(run_folder)/cwru-as-published,rates,$(run_folder)/cwru-as-published,$(run_folder)/cwru))
	@cat $(contrast_tables)
