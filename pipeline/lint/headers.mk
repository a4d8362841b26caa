# Compiles each of HEADERS alone. STAMPS/<header>.ok records success; else <header>.log has the errors.

stamps := $(HEADERS:%=$(STAMPS)/%.ok)
.PHONY: all
all: $(stamps)

$(STAMPS)/%.ok: % $(STAMPS)/flags
	mkdir -p $(@D)
	rm -f $@
	if $(if $(filter src/libtorch/%,$<),$(LIBTORCH_FLAGS),$(FLAGS)) -fsyntax-only \
	    -MMD -MP -MF $(@:.ok=.d) -MT $@ -x c++ -include $< /dev/null >$(@:.ok=.log) 2>&1; then touch $@; fi

-include $(stamps:.ok=.d)
