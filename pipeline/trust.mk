# Classifiers that are kept, for `classify` and `monitor`, and how far they are to be believed. The grid keeps none
# unasked: a cell's takes a megabyte, and five more trainings.
#
#   A.h5 B.h5 C.h5 E.h5 -> <ratio>/<classifier>/classifier.h5 -> trust.csv, trust.md

kept_of = $(patsubst %/diagnosis.h5,%/classifier.h5,$(call diagnoses,$1))
trust_tables = $(addprefix $(results)/$1/,trust.csv trust.md)

ifneq (,$(filter trust,$(MAKECMDGOALS))$(filter %/classifier.h5,$(MAKECMDGOALS)))
settings_names += $(DATASETS:%=trust.%)
$(foreach dataset,$(DATASETS),$(eval options.trust.$(dataset) := $(words $(call kept_of,$(dataset))) classifiers))

define kept_rule # seed, its folder, cell, classifier
precious.$2 += $(patsubst %/diagnosis.h5,%/classifier.h5,$(call diagnoses_of,$2/$3,$3,$4))
$(patsubst %/diagnosis.h5,%/classifier.h5,$(call diagnoses_of,$2/$3,$3,$4)): $2/$3/%/$4/classifier.h5: \
    $(call windows,$2) $(if $(filter $(baseline),$3),,$2/$3/E.h5) $(settings)/diagnose.toml
	$(Q)STEP_LOG=classifier pipeline/step.sh $$(@D) diagnose $$(config) --test $2/A.h5 --normal $2/B.h5 --known $2/C.h5 \
	  $(if $(filter $(baseline),$3),,--generated $2/$3/E.h5 )--ratio $$* $(call by_classifier,$4)--seed $1 --keep-classifier $$@ -- $$@
endef

define trust_rule # data set
.PRECIOUS: $(call trust_tables,$1)
$(call trust_tables,$1) &: $(settings)/trust.$1.toml $(call kept_of,$1)
	$$(step) trust $$(config) --run $(results) --dataset $1 $(call says_nothing_known,$1)$(whole_selection) -- $(call trust_tables,$1)
endef

$(foreach dataset,$(DATASETS),\
  $(eval $(call trust_rule,$(dataset)))\
  $(foreach seed,$(SEEDS),$(eval folder := $(results)/$(dataset)/seed$(seed))\
    $(foreach method,$(call methods_of,$(dataset)),$(foreach classifier,$(call classifiers_of,$(dataset),$(method)),\
      $(eval $(call kept_rule,$(seed),$(folder),$(method),$(classifier)))))))

trust: $(foreach dataset,$(DATASETS),$(call trust_tables,$(dataset)))
	@cat $(filter %.md,$^)
endif
