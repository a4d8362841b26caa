# What each method is worth where faults are known in one condition and tested in another: the mean over a group
# of such data sets, each method with the input of WDCNN that was chosen for it on other seeds: one for telling classes
# and one for telling kinds of defect. The groups and the choices stand in [transfer.GROUP] of pipeline/protocol.toml.
#
#   <dataset>/seed*/.../diagnosis.h5 -> transfer@<group>.csv, .md -> .svg, .pdf; transfer-comparisons@<group>.csv
#
# Groups are those all of whose data sets are in DATASETS. The tables are of the methods, classifiers and seeds that
# are asked for, at the last of RATIOS: a mean must be of the same seeds for all.

ifneq (,$(filter transfer,$(MAKECMDGOALS)))

# (What has no description is refused with its line when the settings of the group are asked for, below.)
transfer_datasets = $(filter $(call fact,dataset),$(call in_group,dataset,$1))
transfer_groups  := $(strip $(foreach group,$(call fact,group),$(if $(filter-out $(DATASETS),$(call transfer_datasets,$(group))),,$(group))))
$(if $(transfer_groups),,$(error make transfer: DATASETS must have all of a group: $(foreach \
  group,$(call fact,group),$(group) ($(call transfer_datasets,$(group))))))

transfer_ratio := $(lastword $(filter-out $(nothing_generated),$(filter $(RATIOS),$(call fact,ratio))))
$(if $(transfer_ratio),,$(error make transfer: RATIOS must have others than $(nothing_generated), at which nothing is generated))

# Before hours of cells: a table needs each method by the inputs that are recorded for it.
transfer_inputs = $(foreach method,$(METHODS),$(patsubst $(method)=%,%,$(filter $(method)=%,$(call in_group,input,$1))))
transfer_lacks  = $(sort $(filter-out $(CLASSIFIERS),$(call transfer_inputs,$1)))
$(foreach group,$(transfer_groups),$(if $(call transfer_lacks,$(group)),$(error make transfer: CLASSIFIERS must have \
  $(call transfer_lacks,$(group)), which [transfer.$(group)] of pipeline/protocol.toml names for these METHODS)))

settings_names += $(transfer_groups:%=transfer.%)
transfer_choice := --methods $(METHODS) --ratio $(transfer_ratio) --classifiers $(CLASSIFIERS) --seeds $(SEEDS)
$(foreach group,$(transfer_groups),$(eval options.transfer.$(group) := $(transfer_choice)))

# The diagnoses of a data set at the ratios that count.
transfer_cells  = $(foreach ratio,$(nothing_generated) $(transfer_ratio),$(foreach file,$(call diagnoses,$1),\
                    $(if $(findstring /$(ratio)/,$(file)),$(file))))
transfer_tables = $(patsubst %,$(results)/%,transfer@$1.csv transfer-comparisons@$1.csv transfer@$1.md)

define transfer_rule # group
.PRECIOUS: $(call transfer_tables,$1)
$(call transfer_tables,$1) &: $(foreach dataset,$(call transfer_datasets,$1),$(call transfer_cells,$(dataset))) \
                              $(settings)/transfer.$1.toml
	$(Q)STEP_LOG=transfer@$1 pipeline/step.sh $$(@D) transfer $$(config) --run $(results) --group $1 $(transfer_choice) \
	  -- $(call transfer_tables,$1)
$(results)/transfer@$1.svg $(results)/transfer@$1.pdf &: $(results)/transfer@$1.csv $(wildcard pipeline/figures/*)
	$$(Q)pipeline/figures/draw.sh $$<
endef
$(foreach group,$(transfer_groups),$(eval $(call transfer_rule,$(group))))

transfer: $(foreach group,$(transfer_groups),$(call transfer_tables,$(group)) $(results)/transfer@$(group).svg)
	@cat $(filter %.md,$^)
	@printf 'tables and picture: %s.{md,csv,svg,pdf}\n' $(transfer_groups:%=$(results)/transfer@%)

endif
