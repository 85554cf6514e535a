# The same tests with more cases, under sanitizers or by themselves; clang-tidy; fuzzing.

# The same tests with millions of cases where a commit has thousands; hours.
night: test-binary $(PROGRAMS)
	RAYPRO_NIGHT=1 $(FOR_TESTS) $(BUILD)/raytests $(GTEST)

# clang-tidy over the library, of which a folder is looked at as it is compiled. Version 16 or later, since earlier ones
# cannot read the ranges of g++ 12.
TIDY ?= clang-tidy
TIDIED := $(patsubst $(BUILD)/obj/%.o,%.cpp,$(call objects,$(LIBRARY_SOURCES)))
TIDIED := $(patsubst %/all.cpp,$(BUILD)/jumbo/%/all.cpp,$(TIDIED))
tidy: $(TIDIED)
	@printf '%s\n' $^ | xargs -P $(JOBS) -I{} $(TIDY) --quiet {} -- $(filter-out -MD -MP,$(OUR_CPPFLAGS)) $(FEATURE_CPPFLAGS) \
	  $(CPPFLAGS) -std=c++20 $(filter -ffp%,$(NUMERIC))

# One test file: this and the folder that it tests are all that an edit of them compiles. Programs that it runs are
# brought up to date.
.PHONY: unit night tidy asan tsan fuzz fuzz-targets fuzz-scenes
UNIT := $(BUILD)/unit/$(basename $(firstword $(wildcard tests/$(T).cpp $(T).cpp)))
unit:
	@[ "$(T)" ] || { echo "which test? For tests/R3/Csg.cpp: make unit T=R3/Csg" >&2; exit 1; }
	@[ -f "$(UNIT:$(BUILD)/unit/%=%).cpp" ] || { echo "there is no tests/$(T).cpp" >&2; exit 1; }
	@$(MAKE) $(if $(findstring jobserver,$(MAKEFLAGS)),,-j$(JOBS)) $(UNIT) \
	  $(if $(shell grep -sE '/(Program|Place|Rayimg)\.h"|getenv' $(UNIT:$(BUILD)/unit/%=%).cpp),$(PROGRAMS))
	$(FOR_TESTS) $(UNIT) $(GTEST)

# g++ says itself that its sanitizers make it warn of variables that it takes for uninitialized, and that ThreadSanitizer
# does not know fences; oneTBB's headers have some.
asan:
	$(MAKE) BUILD=$(BUILD)/asan OPTIMIZE=-O1 test \
	  SANITIZE="-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer$(if $(CLANG),, -Wno-maybe-uninitialized)"
# script/tsan_tbb.sh makes the library without which ThreadSanitizer reports races within oneTBB. Programs find it beside
# them, also where they are started by ssh. script/tsan.supp names the libraries whose reports are not looked at.
tsan:
	TSAN_OPTIONS="suppressions='$$(pwd)/script/tsan.supp' $$TSAN_OPTIONS" \
	$(MAKE) BUILD=$(BUILD)/tsan OPTIMIZE=-O1 SANITIZE="-fsanitize=thread$(if $(CLANG),, -Wno-tsan)" \
	  LDFLAGS="-Wl,-rpath,'\$$\$$ORIGIN/tbb' $(LDFLAGS)" test

# With clang, whose runtime finds the inputs. script/fuzz.sh runs the targets and makes their seeds.
FUZZ_CXX ?= clang++
fuzz:
	$(MAKE) BUILD=$(BUILD)/fuzz CXX="$(FUZZ_CXX)" OPTIMIZE=-O1 \
	  SANITIZE="-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer" fuzz-targets
fuzz-targets: $(FUZZ_SOURCES:fuzz/%.cpp=$(BUILD)/targets/%)
$(BUILD)/targets/%: $(BUILD)/obj/fuzz/%.o $(BUILD)/librayview.a $(BUILD)/libray.a
	$(call link,-fsanitize=fuzzer)

# An hour of one core for 100,000. The first scene that fails is kept and named.
fuzz-scenes: test-binary
	RAYTESTS_SCENES=$(or $(SCENES),100000) RAYTESTS_SEED=$(or $(SEED),1) RAYTESTS_STEP=$(or $(STEP),1) $(BUILD)/raytests --gtest_filter='RandomScenes.*'
