# The smallest tracer, benchmarks, and what accuracy costs.
.PHONY: tiny bench tradeoff

# The smallest tracer. Its C is of 1989, where what is not declared is an int.
MACHINE := $(shell $(CXX) -dumpmachine 2>/dev/null)
TINY := $(BUILD)/tiny/tiny $(if $(and $(filter x86_64%,$(MACHINE)),$(findstring linux,$(MACHINE))),$(BUILD)/tiny/small)
tiny: $(TINY)
	@echo "tiny/tiny.c: $$(wc -c < tiny/tiny.c) characters"
	@$(if $(filter %/small,$(TINY)),echo "$(BUILD)/tiny/small: $$(wc -c < $(BUILD)/tiny/small) bytes")
$(BUILD)/tiny/tiny: tiny/tiny.c
	@mkdir -p $(@D) && $(CXX) -x c -std=gnu89 -w -Wno-psabi -O2 -ffp-contract=off $< -x none -lm -o $@
$(BUILD)/tiny/small: tiny/small.S
	@mkdir -p $(@D) && $(CXX) -c $< -o $@.o && ld -Ttext=0x3b000000 --oformat binary -e 0 $@.o -o $@ && chmod +x $@

bench: $(patsubst bench/%.cpp,$(BUILD)/bench/%,$(call present,$(BENCH_SOURCES))) raypro

# The scripts say what they measure and which options they take: TRADEOFF="-search 50 hello lens".
tradeoff: $(PROGRAMS)
	$(FOR_TESTS) sh script/tradeoff.sh $(if $(FULL),-full) $(TRADEOFF)
