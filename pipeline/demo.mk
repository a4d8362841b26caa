# `make demo`: three questions about a simulated machine, each a small grid in results/demo/.
#
#   three grids -> tables, figures, report.html
#   the rule of the third grid, a new recording -> recording.svg
#   all three -> the answers
#
# Three seeds suffice because the margins are wide: the words of the answers are the same on any processor.

SHELL := /bin/bash
MAKEFLAGS += --no-builtin-rules --no-print-directory
Q := $(if $(V),,@)

slower    := simulated-small-slower
no_fault  := simulated-small-types-zero
rule      := $(results)/$(no_fault)/seed0/none/100to1/exclusion-rule/classifier.h5
recording := $(results)/recording
grid       = $(Q)+GOALS='$1' DATASETS='$2' METHODS='$3' CLASSIFIERS='$4' $(if $5,SEEDS=$5) \
  pipeline/run.sh '$(MAKE)'

.PHONY: demo no_fault same_speed other_speed
demo: $(recording).svg same_speed other_speed
	$(call grid,report,simulated-small)
	$(Q)$(BIN)/demo_answers --run $(results) --same-speed simulated-small --other-speed $(slower) \
	  --no-fault $(no_fault) --diagnosis $(recording).h5 --true-class outer
	@printf '%s\n' '' 'Open $(results)/report.html    tables and figures' \
	  '     $(recording).svg  the diagnosis of recording.txt'

no_fault:
	$(call grid,tables $(rule),$(no_fault),none,exclusion-rule)
same_speed:
	$(call grid,tables features,simulated-small,none piae-dt shift)
other_speed:
	$(call grid,tables,$(slower),none shift strike-twin,wdcnn-spectra)

# 4 s of a machine with a damaged outer race, one number per line. Simultaneous makes write separate files.
$(recording).txt: pipeline/datasets/$(no_fault).toml
	$(Q)mkdir -p $(@D) && set -o pipefail && part=$@.$$$$ && \
	  $(BIN)/simulate --description $< --stream outer --duration-s 4 --output - | \
	  od --address-radix=n --output-duplicates --format=f4 --width=4 >$$part && mv $$part $@
$(recording).svg: $(recording).txt no_fault
	$(Q)$(BIN)/classify --classifier $(rule) --recording $< --variable 1 --sample-rate-hz 12000 \
	  --speed-rpm 1797 --output $(recording).h5 --picture $@ >$(recording).log
