# The figures of a run, drawn from what it holds: nothing of the grid is computed for them.
#
#   cells of <dataset> -> figures/NAME.csv -> figures/NAME.svg, figures/NAME.pdf
#
# A figure whose cells are missing is named and left out, the others are drawn. The numbers are made each
# time, since they cost a second; where they are the same as before, nothing is drawn again.

figure_folders := $(DATASETS:%=$(results)/%/figures)

.PHONY: figures figure-numbers draw $(DATASETS:%=figure-numbers-%)
figures: figure-numbers
	$(Q)+$(this_make) draw

figure-numbers: $(DATASETS:%=figure-numbers-%)
$(DATASETS:%=figure-numbers-%): figure-numbers-%:
	$(Q)pipeline/step.sh $(results)/$* figures --run $(results) --dataset $* $(selection) \
	  --published results/published

# A make of its own, which sees what numbers there are now.
numbers  := $(wildcard $(figure_folders:%=%/*.csv))
pictures := $(numbers:.csv=.svg) $(numbers:.csv=.pdf)
no_more  := $(filter-out $(pictures),$(wildcard $(figure_folders:%=%/*.svg) $(figure_folders:%=%/*.pdf)))
draw: $(numbers:.csv=.svg)
	$(if $(no_more),$(Q)rm -f $(no_more))
	$(Q)printf 'figures: %s\n' $(figure_folders)

# What is common to all scripts is a prerequisite of each picture: a new style draws all again.
$(numbers:.csv=.svg): %.svg: %.csv $(wildcard pipeline/figures/*)
	$(Q)pipeline/figures/draw.sh $<
