# raypro: two commands make a picture and a green test run: script/setup.sh, then make test.
#   make            the programs, under build/ (another place: make BUILD=elsewhere)
#   make test       the layer check, all tests, and a few pictures of the writeup
#   make unit T=R3/Csg  builds and runs one test file, with nothing but the sources that it needs
#   make night      the tests with millions of cases; GTEST=--gtest_filter=... for some of them
#   make check      who may include whom; that elementary functions are our own; that all who name packages name the same
#   make tidy       clang-tidy over the library; TIDY=clang-tidy-19 for another one
#   make asan tsan  the tests again under the sanitizers
#   make web        the page that renders in a browser, under build/web; make web-test tests it, make site adds the docs
#   make fuzz       the fuzz targets, with clang, under build/fuzz; script/fuzz.sh runs them
#   make fuzz-scenes  random scenes: hits in exact arithmetic, bounds on light, one mean; SCENES=100000 from SEED=1 on,
#                   SEED=2 STEP=3 for those whose surfaces touch
#   make bench      the benchmark programs
#   make tiny       the smallest tracer, as source and as executable, and how small it is
#   make tradeoff   error over seconds for every knob, as CSV and plots under build/tradeoff; FULL=1 for hours
#   make install    PREFIX=/usr/local DESTDIR= bindir= datadir= mandir= docdir=; make uninstall undoes it
#   make installcheck  both of them, tried in a folder for it
#   make dist       what is committed, as build/raypro-VERSION.tar.gz
# HAS_EXR=no, HAS_YAML=no and CONTEXTS= (or CONTEXTS="egl osmesa") leave out what could be built here.
# CXX, CXXFLAGS, CPPFLAGS and LDFLAGS given by the user come after ours and so win.

ifeq ($(origin CXX),default)
CXX := g++
endif
BUILD ?= build
ifneq ($(words $(BUILD)),1)
$(error BUILD must be one word, without blanks, not "$(BUILD)"; the folder of the sources may have some)
endif
PREFIX ?= /usr/local
bindir ?= $(PREFIX)/bin
datadir ?= $(PREFIX)/share
mandir ?= $(datadir)/man
docdir ?= $(datadir)/doc/raypro
VERSION := 0.1.0
OPTIMIZE ?= -O2
# What a user adds may not change how numbers are rounded: rays would leak between triangles, or pictures differ.
UNSAFE := $(filter -ffast-math -Ofast -ffp-contract=fast -ffp-contract=on -funsafe-math-optimizations -fassociative-math \
                   -freciprocal-math -ffinite-math-only -fno-signed-zeros,$(CXXFLAGS) $(CPPFLAGS) $(OPTIMIZE))
ifneq ($(strip $(UNSAFE)),)
$(error $(strip $(UNSAFE)) changes how numbers are rounded, and with it what rays hit. Build without it)
endif

include script/features.mk

# -ffp-contract=off: a*b+c keeps its two roundings everywhere, so every build gives the same picture.
# -fno-math-errno -fno-trapping-math: nobody asks for errno or for floating-point exceptions, so that a square root is one
# instruction and loops over samples become vector instructions; no result changes.
# -fno-tree-slp-vectorize: g++ 12 otherwise drops the rounding in double(float(x)) of neighboring members.
CLANG := $(shell $(CXX) --version 2>/dev/null | grep clang)
NUMERIC := -ffp-contract=off -fno-math-errno -fno-trapping-math $(if $(CLANG),-fno-slp-vectorize,-fno-tree-slp-vectorize)
WARNINGS := -Wall -Wextra -Wpedantic -Wshadow -Wconversion
OUR_CPPFLAGS := -I. -MD -MP -DRAYPRO_VERSION='"$(VERSION)"'
ifeq ($(HAS_EXR),yes)
OUR_CPPFLAGS += -DRAYPRO_EXR $(EXR_CFLAGS)
endif
ifeq ($(HAS_YAML),yes)
OUR_CPPFLAGS += -DRAYPRO_YAML $(YAML_CFLAGS)
endif
# Only for files that draw, or say what can be drawn: the others need not be compiled again once the viewer's packages
# are installed.
FEATURE_CPPFLAGS := -DRAYPRO_FEATURES='"$(FEATURES)"' $(if $(CONTEXTS),$(IMGUI_CFLAGS)) \
                    $(if $(filter glfw,$(CONTEXTS)),-DRAYVIEW_GLFW) $(if $(filter egl,$(CONTEXTS)),-DRAYVIEW_EGL) \
                    $(if $(filter osmesa,$(CONTEXTS)),-DRAYVIEW_OSMESA)
OUR_CXXFLAGS := -std=c++20 $(OPTIMIZE) -g1 $(NUMERIC) $(WARNINGS) $(SANITIZE)
LIBS := -ljpeg -lpng -lz -ltbb -lhwy $(if $(filter yes,$(HAS_EXR)),$(EXR_LIBS)) $(if $(filter yes,$(HAS_YAML)),$(YAML_LIBS)) \
        -pthread
# Numbers of 113 bits for the tests; where this is missing, long double has them.
QUADMATH := $(if $(filter x86_64% i%86%,$(shell $(CXX) -dumpmachine 2>/dev/null)),-lquadmath)
# For those that draw. OSMesa is loaded only when it is asked for: it brings a whole compiler along.
VIEWER_LIBS := $(if $(CONTEXTS),-lepoxy) $(if $(filter glfw,$(CONTEXTS)),-lglfw) $(if $(filter osmesa,$(CONTEXTS)),-ldl) \
               $(if $(CONTEXTS),$(IMGUI_LIBS))

.DEFAULT_GOAL := all
MAINS := $(wildcard source/app/ray*.cpp) source/rayimg/rayimg.cpp
# rayview is built where there is something to draw with.
PROGRAMS := raypro rayimg $(if $(CONTEXTS),rayview)
LIBRARY_SOURCES := $(filter-out $(MAINS),$(wildcard R1/*.cpp R2/*.cpp R2/*/*.cpp R3/*.cpp R3/*/*.cpp source/*/*.cpp \
                     source/*/*/*.cpp source/*/*/*/*.cpp))
TEST_SOURCES := $(wildcard tests/*.cpp tests/R1/*.cpp tests/R2/*.cpp tests/R2/*/*.cpp tests/R3/*.cpp \
                  tests/source/*/*.cpp tests/source/*/*/*.cpp tests/source/*/*/*/*.cpp \
                  $(foreach d,every agree extremes closed_form bad_scenes regressions images,tests/$(d)/*.cpp))
include grader/grader.mk
BENCH_SOURCES := $(wildcard bench/*.cpp)
FUZZ_SOURCES := $(wildcard fuzz/*.cpp)
FUZZ_CXX ?= clang++
# What this machine lacks leaves these out.
ABSENT := $(if $(filter yes,$(HAS_EXR)),,R2/image_files/exr.cpp) \
          $(patsubst %,source/draw/contexts/%.cpp,$(filter-out $(CONTEXTS),glfw egl osmesa)) \
          $(if $(CONTEXTS),,source/draw/gl/% source/draw/contexts/% source/view/panels/% source/view/Viewer% source/view/KeyBindings.cpp \
                            source/app/rayview/ViewSession.cpp source/app/rayview/PanelOptions.cpp \
                            source/app/rayview/LoadingWindow.cpp tests/source/app/rayview/% tests/source/draw/% tests/source/view/% \
                            bench/view.cpp)
# The .cpp files of a folder are compiled as one, since most of what compiling takes is their headers. These are not:
# files that use the same local names in the same folder, since they are variations of one thing, and files that
# Highway includes once for each instruction set. JUMBO=no compiles each file by itself.
JUMBO ?= yes
ALONE := fuzz/% \
         source/draw/gl/% source/draw/contexts/% source/accelerate/grid.cpp source/accelerate/wide/Kernels.cpp \
         source/film/denoise/LocalFit.cpp source/app/manual/Version.cpp \
         $(if $(UNIT)$(filter-out file,$(origin TEST_SOURCES)),tests/% grader/tests/%) $(if $(filter yes,$(JUMBO)),,%)
present = $(filter-out $(ABSENT),$(1))
alone = $(filter $(ALONE),$(call present,$(1)))
together = $(filter-out $(ALONE),$(call present,$(1)))
objects = $(patsubst %.cpp,$(BUILD)/obj/%.o,$(call alone,$(1))) \
          $(patsubst %,$(BUILD)/obj/%all.o,$(sort $(dir $(call together,$(1)))))

.PHONY: all $(PROGRAMS) test unit unit-program night check tidy asan tsan fuzz fuzz-targets fuzz-scenes bench tiny tradeoff \
        install uninstall installcheck dist clean compile_commands test-binary FORCE
.PRECIOUS: $(BUILD)/obj/%.o $(BUILD)/jumbo/%/all.cpp
all: $(PROGRAMS) $(BUILD)/compile_commands.json
$(PROGRAMS): %: $(BUILD)/%

# Written only when it says something else than before.
write = @mkdir -p $(@D) && printf '%s\n' $(1) | cmp -s - $@ || printf '%s\n' $(1) > $@
# A change of compiler or flags rebuilds everything: the flags are kept in a file that objects depend on.
FLAGS_LINE := $(CXX) $(OUR_CPPFLAGS) $(CPPFLAGS) $(OUR_CXXFLAGS) $(CXXFLAGS)
$(BUILD)/flags: FORCE
	$(call write,'$(subst ','\'',$(FLAGS_LINE))')
$(BUILD)/features: FORCE
	$(call write,'$(subst ','\'',$(FEATURE_CPPFLAGS))')
# The commit that -version names; empty where these files lie in nobody's checkout or in another project's. Images and
# reports do not name it, so that they stay the same bytes.
COMMIT = $(shell prefix=$$(git rev-parse --show-prefix 2>/dev/null) && [ -z "$$prefix" ] && \
                 GIT_OPTIONAL_LOCKS=0 git describe --always --exclude='*' --abbrev=10 --dirty=-modified)
$(BUILD)/commit: FORCE
	$(call write,'$(COMMIT)')
$(BUILD)/jumbo/%/all.cpp: FORCE
	$(call write,$(patsubst %,'#include "%"',$(call together,$(filter-out $(MAINS),\
	  $(if $(UNIT),$(filter $(UNIT),$(wildcard $*/*.cpp)),$(wildcard $*/*.cpp))))))
FORCE:

compile = @mkdir -p $(@D) && echo "  c++   $(1)" && \
          $(CXX) $(OUR_CPPFLAGS) $(FEATURES_HERE) $(CPPFLAGS) $(OUR_CXXFLAGS) $(OPTIMIZE_HERE) $(CXXFLAGS) -c $< -o $@
# What runs once in a run is compiled the faster for it; where samples are made many at a time, loops become vector
# instructions.
$(BUILD)/obj/source/app/% $(BUILD)/obj/source/rayimg/% $(BUILD)/obj/source/parse/%: OPTIMIZE_HERE := $(if $(filter -O2 -O3,$(OPTIMIZE)),-O1)
$(BUILD)/obj/source/sample/% $(BUILD)/obj/source/scene/% $(BUILD)/obj/source/integrate/all.o \
$(BUILD)/obj/source/integrate/lights/% $(BUILD)/obj/source/integrate/shading/% $(BUILD)/obj/R3/shapes/%: \
  OPTIMIZE_HERE := $(if $(filter -O2 -O3,$(OPTIMIZE)),-ftree-vectorize $(if $(CLANG),,-fvect-cost-model=dynamic))
OF_FEATURES := $(filter source/app/manual/% source/app/rayview/% source/draw/% source/view/% tests/%, \
                 $(LIBRARY_SOURCES) $(TEST_SOURCES))
OF_FEATURES := $(call objects,$(OF_FEATURES)) $(BUILD)/obj/source/app/rayview.o $(BUILD)/obj/bench/view.o
$(OF_FEATURES): FEATURES_HERE := $(FEATURE_CPPFLAGS)
$(OF_FEATURES): $(BUILD)/features
$(BUILD)/obj/source/app/manual/Version.o: FEATURES_HERE = $(FEATURE_CPPFLAGS) -DRAYPRO_COMMIT='"$(shell cat $(BUILD)/commit)"'
$(BUILD)/obj/source/app/manual/Version.o: $(BUILD)/commit
$(BUILD)/obj/%/all.o: $(BUILD)/jumbo/%/all.cpp $(BUILD)/flags
	$(call compile,$*/*.cpp)
$(BUILD)/obj/%.o: %.cpp $(BUILD)/flags
	$(call compile,$<)

# What all programs share, and what is one program's own, so that raypro does not wait for the viewer.
OF_RAYVIEW := $(filter source/draw/% source/view/% source/app/rayview/%,$(LIBRARY_SOURCES))
OF_RAYIMG := $(filter source/rayimg/%,$(LIBRARY_SOURCES))
archive = @echo "  ar    $@" && rm -f $@ && $(AR) rcs $@ $^
$(BUILD)/libray.a: $(call objects,$(filter-out $(OF_RAYVIEW) $(OF_RAYIMG),$(LIBRARY_SOURCES)))
	$(archive)
$(BUILD)/librayview.a: $(call objects,$(OF_RAYVIEW))
	$(archive)

$(BUILD)/rayview $(BUILD)/raytests $(BUILD)/bench/view $(BUILD)/targets/%: LIBS += $(VIEWER_LIBS)

# What the archive of all holds is looked up last.
link = @mkdir -p $(@D) && echo "  link  $@" && $(CXX) $(OUR_CXXFLAGS) $(CXXFLAGS) \
       $(filter-out %/libray.a,$^) $(BUILD)/libray.a $(LDFLAGS) $(1) $(LIBS) -o $@
$(BUILD)/rayview: $(BUILD)/librayview.a
$(BUILD)/rayimg: $(BUILD)/obj/source/rayimg/rayimg.o $(call objects,$(OF_RAYIMG)) $(BUILD)/libray.a
	$(call link)
$(patsubst source/app/%.cpp,$(BUILD)/%,$(filter source/app/%,$(MAINS))): $(BUILD)/%: $(BUILD)/obj/source/app/%.o $(BUILD)/libray.a
	$(call link)
$(BUILD)/raytests: $(call objects,$(TEST_SOURCES) $(OF_RAYIMG)) $(BUILD)/librayview.a $(BUILD)/libray.a
	$(call link,-lgtest $(QUADMATH))
$(BUILD)/bench/%: $(BUILD)/obj/bench/%.o $(BUILD)/librayview.a $(BUILD)/libray.a
	$(call link,$(if $(shell grep -l benchmark/benchmark.h bench/$*.cpp),-lbenchmark))

include page/page.mk

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

JOBS ?= $(shell nproc 2> /dev/null || getconf _NPROCESSORS_ONLN)

# Tests find the programs and the project's files through these. The shell names the folders: make takes blanks in
# their names for ends of words.
FOR_TESTS := build=$$(cd $(BUILD) && pwd) && RAYPRO="$$build/raypro" RAYIMG="$$build/rayimg" RAYGRADE="$$build/raygrade" RAYPRO_ROOT="$$(pwd)" TINY="$$build/tiny" \
             $(if $(filter rayview,$(PROGRAMS)),RAYVIEW="$$build/rayview")

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

# For editors: every file by itself, as JUMBO=no compiles it.
$(BUILD)/compile_commands.json: $(BUILD)/flags $(BUILD)/features
	@for file in $(call present,$(LIBRARY_SOURCES) $(TEST_SOURCES) $(BENCH_SOURCES) $(MAINS)); do \
	  printf ',\n{"directory":"%s","file":"%s","command":"%s -c %s"}' "$$PWD" $$file \
	    "$$(cat $(BUILD)/flags $(BUILD)/features | tr '\n' ' ' | sed 's/[\"]/\\&/g')" $$file; done | sed '1s/,/[/; $$s/$$/\n]/' > $@

# Compiles and runs on all cores, unless -j said on how many. Benchmarks that need no further package are compiled too,
# lest nobody notice that they no longer do. A page that was built is brought up to date and tested as well.
test: $(if $(wildcard $(BUILD)/web/raypro.wasm),web)
	$(MAKE) $(if $(findstring jobserver,$(MAKEFLAGS)),,-j$(JOBS)) check test-binary $(PROGRAMS) $(TINY) \
	  $(patsubst %.cpp,$(BUILD)/obj/%.o,$(call present,bench/live.cpp bench/trade.cpp bench/view.cpp))
	$(FOR_TESTS) JOBS=$(JOBS) sh script/run_tests.sh $(BUILD)/raytests $(GTEST)
	$(FOR_TESTS) sh script/runray.sh -fast
	@sh page/tests/run.sh $(BUILD)
test-binary: $(BUILD)/raytests

# One test file, in a program of its own with nothing but the sources that it needs, compiled for speed of compiling.
UNIT_TEST = $(firstword $(wildcard tests/$(T).cpp $(T).cpp))
unit:
	@[ "$(T)" ] || { echo "which test? For tests/R3/Csg.cpp: make unit T=R3/Csg" >&2; exit 1; }
	@[ -f "$(UNIT_TEST)" ] || { echo "there is no tests/$(T).cpp" >&2; exit 1; }
	@$(MAKE) $(if $(findstring jobserver,$(MAKEFLAGS)),,-j$(JOBS)) BUILD=$(BUILD)/unit/$(T) \
	  OPTIMIZE=$(if $(findstring command,$(origin OPTIMIZE)),$(OPTIMIZE),-O0) \
	  UNIT="$$(sh script/unit_sources.sh $(UNIT_TEST))" unit-program
	$(FOR_TESTS) $(BUILD)/unit/$(T)/test $(GTEST)
unit-program: $(BUILD)/test
$(BUILD)/test: $(call objects,$(UNIT))
	@echo "  link  $@" && $(CXX) $(OUR_CXXFLAGS) $(CXXFLAGS) $^ $(LDFLAGS) -lgtest $(QUADMATH) $(LIBS) $(VIEWER_LIBS) -o $@

# Benches need libraries that not every machine has; this one needs none to be compiled.
check: $(BUILD)/obj/bench/kernels.o
	@sh script/check_layers.sh
	@sh script/check_functions.sh
	@sh script/check_packages.sh

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
fuzz:
	$(MAKE) BUILD=$(BUILD)/fuzz CXX="$(FUZZ_CXX)" OPTIMIZE=-O1 \
	  SANITIZE="-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer" fuzz-targets
fuzz-targets: $(FUZZ_SOURCES:fuzz/%.cpp=$(BUILD)/targets/%)
$(BUILD)/targets/%: $(BUILD)/obj/fuzz/%.o $(BUILD)/librayview.a $(BUILD)/libray.a
	$(call link,-fsanitize=fuzzer)

# An hour of one core for 100,000. The first scene that fails is kept and named.
fuzz-scenes: test-binary
	RAYTESTS_SCENES=$(or $(SCENES),100000) RAYTESTS_SEED=$(or $(SEED),1) RAYTESTS_STEP=$(or $(STEP),1) $(BUILD)/raytests --gtest_filter='RandomScenes.*'

bench: $(patsubst bench/%.cpp,$(BUILD)/bench/%,$(call present,$(BENCH_SOURCES))) raypro

# The scripts say what they measure and which options they take: TRADEOFF="-search 50 hello lens".
tradeoff: $(PROGRAMS)
	$(FOR_TESTS) sh script/tradeoff.sh $(if $(FULL),-full) $(TRADEOFF)

# The shell's quotes around anything.
quoted = '$(subst ','\'',$(1))'
INTO = DESTDIR=$(call quoted,$(DESTDIR)) bindir=$(call quoted,$(bindir)) datadir=$(call quoted,$(datadir)) \
       mandir=$(call quoted,$(mandir)) docdir=$(call quoted,$(docdir))
install: $(PROGRAMS)
	@$(INTO) sh script/install.sh $(BUILD) $(PROGRAMS)
uninstall:
	@$(INTO) sh script/uninstall.sh
installcheck: $(PROGRAMS)
	@sh tests/fresh/install.sh $(BUILD)

# Of what is committed, with the time of the commit, nobody's name and no time in the compressed file: the same bytes
# wherever it is made.
dist:
	@git rev-parse --git-dir >/dev/null || { echo "make dist packs what is committed; this is no checkout" >&2; exit 1; }
	@mkdir -p $(BUILD)
	@git -c tar.umask=0022 archive --format=tar --prefix=raypro-$(VERSION)/ HEAD > $(BUILD)/dist.tar
	@gzip -n -9 < $(BUILD)/dist.tar > $(BUILD)/raypro-$(VERSION).tar.gz && rm -f $(BUILD)/dist.tar
	@echo $(BUILD)/raypro-$(VERSION).tar.gz

clean:
	rm -rf $(BUILD)

-include $(shell find $(BUILD)/obj -name '*.d' 2>/dev/null)
