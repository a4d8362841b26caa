# Which cells a data set has, of what is asked for: `classifiers_of`, `methods_of` and `generators_of`. Not every method
# goes together with every classifier, and fewer do where no fault window is known. What is asked for and has no cells
# in a data set is left out, with one line that says so.

# Data set, method.
classifiers_of = $(strip $(foreach classifier,$(CLASSIFIERS) $(if $(filter $(baseline),$2),$(filter-out $(CLASSIFIERS),$(bar))),\
                   $(if $(filter $2/$(classifier),$(call pairs,$1)),$(classifier))))
# Data set.
methods_of     = $(methods.$1)
generators_of  = $(filter-out $(baseline),$(methods.$1))
$(foreach dataset,$(DATASETS),$(eval methods.$(dataset) := \
  $(foreach method,$(methods),$(if $(call classifiers_of,$(dataset),$(method)),$(method)))))

# Methods, and classifiers, that have no cell in a data set; no name is both a method's and a classifier's.
without_cells  = $(filter-out $(methods_of),$(methods)) $(foreach classifier,$(CLASSIFIERS),\
                   $(if $(filter $(methods:%=%/$(classifier)),$(call pairs,$1)),,$(classifier)))
# Those of them that would have one where faults are known.
asked_pairs    = $(foreach method,$(methods),$(CLASSIFIERS:%=$(method)/%))
known_pairs   := $(filter $(asked_pairs),$(all_pairs))
has_elsewhere  = $(foreach name,$1,$(if $(filter $(name)/% %/$(name),$(known_pairs)),$(name)))

empty :=
comma := ,
listed         = $(subst $(empty) $(empty),$(comma) ,$(strip $1))
left_out_by    = $(if $(strip $2),$1: $(call listed,$2))
reasons        = $(call left_out_by,no fault window is known$(comma) so these are left out,$(call has_elsewhere,$1)) \
                 $(call left_out_by,rules are run with $(baseline) alone$(comma) so these are left out,$(filter-out $(call has_elsewhere,$1),$1))
left_out_line  = $(if $1,'$2: $(strip $(call reasons,$1))')
left_out_lines = $(foreach dataset,$(DATASETS),$(call left_out_line,$(strip $(call without_cells,$(dataset))),$(dataset)))

# Who only looks at a run asks for no cell.
looks := $(filter figures report,$(MAKECMDGOALS))
methods_in     = $(sort $(foreach pair,$1,$(firstword $(subst /, ,$(pair)))))
classifiers_in = $(sort $(foreach pair,$1,$(lastword $(subst /, ,$(pair)))))
refuse_nothing = $(error $1: nothing is left to be made; $(strip $(call reasons,$(call without_cells,$1))); choose of \
  METHODS="$(call methods_in,$(call pairs,$1))" CLASSIFIERS="$(call classifiers_in,$(call pairs,$1))")
$(if $(looks),,$(foreach dataset,$(DATASETS),$(if $(methods.$(dataset)),,$(call refuse_nothing,$(dataset)))))

# A make within another one has nothing new to say.
$(if $(looks)$(only_asking)$(LEFT_OUT_IS_SAID),,$(if $(strip $(left_out_lines)),$(shell printf '%s\n' $(left_out_lines) >&2)))
export LEFT_OUT_IS_SAID := yes
