# The figures of a run, drawn from what it holds: nothing of the grid is computed for them.
#
#   cells of <dataset> -> figures/NAME.csv -> figures/NAME.svg, figures/NAME.pdf
#
# A figure whose cells are missing is named and left out, the others are drawn. pipeline/grid.mk calls
# this; the rules of the cells are not here, so that none of them is made.

SHELL := /bin/bash
MAKEFLAGS += --no-builtin-rules --no-print-directory
Q := $(if $(V),,@)

cells   = $(wildcard $(patsubst %,$(results)/$1/seed*/%,C.h5 D.h5 */model.h5 */E.h5 */score.h5 */*/*/diagnosis.h5 */*/*/features.h5))
# What some figures show beside the cells of the grid: sweeps, the truth, the run with the other split.
beside  = $(wildcard $(patsubst %,$(results)/$1/%,seed*/sweep/*/model.h5 seed*/sweep/*/*/*/diagnosis.h5 \
            seed*/sweep@*/*/*/*/diagnosis.h5 sweep@*.csv scatter.csv identifiability.csv) \
            $(results)-blocked/$1/seed*/*/*/*/diagnosis.h5)
shown   := $(foreach dataset,$(DATASETS),$(if $(call cells,$(dataset)),$(dataset)))
folders := $(shown:%=$(results)/%)

.PHONY: figures draw FORCE
figures: $(folders:%=%/figures.log)
	$(Q)+$(MAKE) --keep-going --file=pipeline/figures.mk draw

# The log of the step says when the numbers were made, of which cells, whether that went well, and which
# files there must be.
step       = pipeline/step.sh $(results)/$1 figures --run $(results) --dataset $1 $(selection) $(nothing_known.$1)$(leave_out.$1)--published results/published
command    = $(BIN)/figures $(wordlist 4,999,$(call step,$1))
is_as_made = $(shell log=$(results)/$1/figures.log; [[ -f $$log && $$(head -n 1 $$log) == *'$(strip $(call command,$1))' \
               && $$(tail -n 1 $$log) == 'step: exit 0 '* ]] && \
               sed -nE 's,^wrote (.*\.csv)$$$$,$(results)/$1/figures/\1,p' $$log | xargs -r ls >/dev/null 2>&1 && echo yes)
define numbers_rule # data set
$(results)/$1/figures.log: $(results)/.settings/tabulate.$1.toml $(call cells,$1) $(call beside,$1) $(if $(call is_as_made,$1),,FORCE)
	$(Q)$(call step,$1)
endef
$(foreach dataset,$(shown),$(eval $(call numbers_rule,$(dataset))))

# A make of its own, which sees what numbers there are now.
numbers  := $(wildcard $(folders:%=%/figures/*.csv))
pictures := $(numbers:.csv=.svg) $(numbers:.csv=.pdf)
no_more  := $(filter-out $(pictures),$(wildcard $(foreach kind,svg pdf,$(folders:%=%/figures/*.$(kind)))))
draw: $(numbers:.csv=.svg)
	@$(if $(no_more),rm -f $(no_more),:)

# What is common to all scripts is a prerequisite of each picture: a new style draws all again.
$(numbers:.csv=.svg): %.svg: %.csv $(wildcard pipeline/figures/*)
	$(Q)pipeline/figures/draw.sh $<
