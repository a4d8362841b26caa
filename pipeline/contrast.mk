# What a condition is worth: two runs side by side that differ in it alone, paired by seed.
#
#   RUN and RUN-blocked      -> <dataset>/protocols.md     what the overlap of the split random is worth
#   cwru-as-published, cwru  -> cwru-as-published/rates.md what the mixed sample rates are worth
#
# The cells of both protocols are made by a make each. The tables cost nothing, and are made each time.

contrast_grid = --methods $(METHODS) --ratios $(RATIOS) --seeds $(SEEDS)
contrast_run  = results/$(RUN)/$1
other_choice  = $(filter-out 'PROTOCOL=%,$(choice))

ifneq (,$(filter contrast %.protocols %.rates,$(MAKECMDGOALS)))

.PHONY: contrast both_protocols
both_protocols: | $(programs)
	$(Q)+$(MAKE) $(other_choice) PROTOCOL=random cells
	$(Q)+$(MAKE) $(other_choice) PROTOCOL=blocked cells

