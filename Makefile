# raypro: two commands make a picture and a green test run: script/setup.sh, then make test.
#   make            the programs, under build/ (another place: make BUILD=elsewhere)
#   make test       the layer check, all tests, and a few pictures of the writeup
#   make night      the tests with millions of cases; GTEST=--gtest_filter=... for some of them
#   make check      the layer check alone: who may include whom; and that the patches of script/price apply
#   make asan tsan  the tests again under the sanitizers
#   make bench      the benchmark programs
#   make tradeoff   error over seconds for every knob, as CSV and plots under build/tradeoff; FULL=1 for hours
#   make price      what features cost scenes that do not use them
#   make install    PREFIX=/usr/local DESTDIR= bindir= datadir= mandir= docdir=; make uninstall undoes it
#   make installcheck  both of them, tried in a folder for it
#   make dist       what is committed, as build/raypro-VERSION.tar.gz
# HAS_EXR=no and CONTEXTS= (or CONTEXTS="egl osmesa") leave out what could be built here.
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

# What is on this machine. The compiler itself is asked, on empty input: a shell test of the header's
# name would have to know where compilers look.
probe = $(shell $(CXX) $(CPPFLAGS) $(3) -std=c++20 -include $(2) -fsyntax-only -x c++ /dev/null >/dev/null 2>&1 && echo yes || echo no)
pkg = $(shell pkg-config $(1) $(2) 2>/dev/null)

EXR_CFLAGS := $(or $(call pkg,--cflags,OpenEXR),-isystem /usr/include/OpenEXR -isystem /usr/include/Imath)
EXR_CFLAGS := $(patsubst -I%,-isystem%,$(EXR_CFLAGS))
EXR_LIBS := $(or $(call pkg,--libs,OpenEXR),-lOpenEXR -lImath -lIex)

NEEDS_COMPILER := $(if $(filter clean uninstall check dist,$(MAKECMDGOALS)),,yes)
ifeq ($(NEEDS_COMPILER),yes)
HAS_JPEG := $(call probe,jpeg,jpeglib.h,-include stdio.h)
HAS_PNG := $(call probe,png,png.h,)
HAS_TBB := $(call probe,tbb,tbb/parallel_for.h,)
HAS_HWY := $(call probe,hwy,hwy/highway.h,)
HAS_JSON := $(call probe,json,nlohmann/json.hpp,)
HAS_EXR := $(call probe,exr,ImfOutputFile.h,$(EXR_CFLAGS))
MISSING := $(if $(filter yes,$(HAS_JPEG)),,libjpeg-dev) $(if $(filter yes,$(HAS_PNG)),,libpng-dev) \
           $(if $(filter yes,$(HAS_TBB)),,libtbb-dev) $(if $(filter yes,$(HAS_HWY)),,libhwy-dev) $(if $(filter yes,$(HAS_JSON)),,nlohmann-json3-dev)
ifneq ($(strip $(MISSING)),)
$(error These packages are missing: $(strip $(MISSING)). Run script/setup.sh, or install them and try again)
endif
# The viewer needs libepoxy, which finds OpenGL, and at least one way to draw.
HAS_EPOXY := $(call probe,epoxy,epoxy/gl.h,)
ifeq ($(HAS_EPOXY),yes)
HAS_GLFW := $(call probe,glfw,GLFW/glfw3.h,-DGLFW_INCLUDE_NONE)
HAS_EGL := $(call probe,egl,epoxy/egl.h,)
HAS_OSMESA := $(call probe,osmesa,GL/osmesa.h,)
endif
CONTEXTS := $(if $(filter yes,$(HAS_GLFW)),glfw) $(if $(filter yes,$(HAS_EGL)),egl) $(if $(filter yes,$(HAS_OSMESA)),osmesa)
CONTEXTS := $(strip $(CONTEXTS))
empty :=
VIEWER := $(or $(subst $(empty) ,+,$(CONTEXTS)),no (install libepoxy-dev and, for windows, libglfw3-dev))
FEATURES := jpeg=yes png=yes exr=$(if $(filter yes,$(HAS_EXR)),yes,no (install libopenexr-dev)) rayview=$(VIEWER)
$(info features: $(FEATURES))
endif

# -ffp-contract=off: a*b+c keeps its two roundings everywhere, so every build gives the same picture.
# -fno-tree-slp-vectorize: g++ 12 otherwise drops the rounding in double(float(x)) of neighbouring members.
NUMERIC := -ffp-contract=off $(shell $(CXX) --version 2>/dev/null | grep -q clang && echo -fno-slp-vectorize || echo -fno-tree-slp-vectorize)
WARNINGS := -Wall -Wextra -Wpedantic -Wshadow -Wconversion
OUR_CPPFLAGS := -I. -MD -MP -DRAYPRO_VERSION='"$(VERSION)"' -DRAYPRO_FEATURES='"$(FEATURES)"'
ifeq ($(HAS_EXR),yes)
OUR_CPPFLAGS += -DRAYPRO_EXR $(EXR_CFLAGS)
endif
OUR_CPPFLAGS += $(if $(filter glfw,$(CONTEXTS)),-DRAYVIEW_GLFW) $(if $(filter egl,$(CONTEXTS)),-DRAYVIEW_EGL) \
                $(if $(filter osmesa,$(CONTEXTS)),-DRAYVIEW_OSMESA)
OUR_CXXFLAGS := -std=c++20 $(OPTIMIZE) -g1 $(NUMERIC) $(WARNINGS) $(SANITIZE)
LIBS := -ljpeg -lpng -lz -ltbb -lhwy $(if $(filter yes,$(HAS_EXR)),$(EXR_LIBS)) -pthread
# For those that draw. OSMesa is loaded only when it is asked for: it brings a whole compiler along.
VIEWER_LIBS := $(if $(CONTEXTS),-lepoxy) $(if $(filter glfw,$(CONTEXTS)),-lglfw) $(if $(filter osmesa,$(CONTEXTS)),-ldl)

ALL_PROGRAMS := raypro rayimg rayview
# rayview is built where there is something to draw with.
PROGRAMS := raypro rayimg $(if $(CONTEXTS),rayview)
PROGRAM_MAINS := $(ALL_PROGRAMS:%=source/app/%.cpp)
LIBRARY_SOURCES := $(filter-out $(PROGRAM_MAINS),$(wildcard R2/*.cpp R2/*/*.cpp R3/*.cpp R3/*/*.cpp source/*/*.cpp source/*/*/*.cpp))
ifneq ($(HAS_EXR),yes)
LIBRARY_SOURCES := $(filter-out R2/image_files/exr.cpp,$(LIBRARY_SOURCES))
endif
TEST_SOURCES := $(wildcard tests/*.cpp tests/R2/*.cpp tests/R2/*/*.cpp tests/R3/*.cpp tests/source/*.cpp tests/source/*/*.cpp tests/source/*/*/*.cpp \
                  $(foreach d,every agree extremes closed_form bad_scenes regressions images,tests/$(d)/*.cpp))
LIBRARY_SOURCES := $(filter-out $(patsubst %,source/view/contexts/%.cpp,$(filter-out $(CONTEXTS),glfw egl osmesa)),$(LIBRARY_SOURCES))
ifeq ($(CONTEXTS),)
LIBRARY_SOURCES := $(filter-out source/view/gl/% source/view/contexts/% source/app/ViewSession.cpp,$(LIBRARY_SOURCES))
TEST_SOURCES := $(filter-out tests/source/view/gl/% tests/source/view/contexts/%,$(TEST_SOURCES))
endif
BENCH_SOURCES := $(filter-out $(if $(CONTEXTS),,bench/view.cpp),$(wildcard bench/*.cpp))
objects = $(patsubst %.cpp,$(BUILD)/obj/%.o,$(1))

.PHONY: all $(PROGRAMS) test night check asan tsan bench tradeoff price install uninstall installcheck dist \
        clean compile_commands test-binary FORCE
.PRECIOUS: $(BUILD)/obj/%.o
all: $(PROGRAMS) $(BUILD)/compile_commands.json
$(PROGRAMS): %: $(BUILD)/%

# A change of compiler or flags rebuilds everything: the flags are kept in a file that objects depend on.
FLAGS_LINE := $(CXX) $(OUR_CPPFLAGS) $(CPPFLAGS) $(OUR_CXXFLAGS) $(CXXFLAGS)
$(BUILD)/flags: FORCE
	@mkdir -p $(BUILD)
	@printf '%s\n' '$(subst ','\'',$(FLAGS_LINE))' | cmp -s - $@ || printf '%s\n' '$(subst ','\'',$(FLAGS_LINE))' > $@
FORCE:

$(BUILD)/obj/%.o: %.cpp $(BUILD)/flags
	@mkdir -p $(@D)
	@echo "  c++   $<"
	@$(CXX) $(OUR_CPPFLAGS) $(CPPFLAGS) $(OUR_CXXFLAGS) $(CXXFLAGS) -c $< -o $@
	@printf '{"directory":"%s","file":"%s","command":"%s"},\n' "$$(pwd)" '$<' \
	  "$$(printf '%s' '$(subst ','\'',$(FLAGS_LINE)) -c $< -o $@' | sed 's/[\\"]/\\&/g')" > $(@:.o=.cmd)

$(BUILD)/libray.a: $(call objects,$(LIBRARY_SOURCES))
	@echo "  ar    $@"
	@rm -f $@ && $(AR) rcs $@ $^

$(BUILD)/rayview $(BUILD)/raytests $(BUILD)/bench/view: LIBS += $(VIEWER_LIBS)

$(PROGRAMS:%=$(BUILD)/%): $(BUILD)/%: $(BUILD)/obj/source/app/%.o $(BUILD)/libray.a
	@echo "  link  $@"
	@$(CXX) $(OUR_CXXFLAGS) $(CXXFLAGS) $^ $(LDFLAGS) $(LIBS) -o $@

$(BUILD)/raytests: $(call objects,$(TEST_SOURCES)) $(BUILD)/libray.a
	@echo "  link  $@"
	@$(CXX) $(OUR_CXXFLAGS) $(CXXFLAGS) $^ $(LDFLAGS) -lgtest $(LIBS) -o $@

$(BUILD)/bench/%: $(BUILD)/obj/bench/%.o $(BUILD)/libray.a
	@mkdir -p $(@D)
	@echo "  link  $@"
	@$(CXX) $(OUR_CXXFLAGS) $(CXXFLAGS) $^ $(LDFLAGS) -lbenchmark $(LIBS) -o $@

# Tests find the programs and the project's files through these. The shell names the folders: make takes blanks in
# their names for ends of words.
FOR_TESTS := build=$$(cd $(BUILD) && pwd) && RAYPRO="$$build/raypro" RAYIMG="$$build/rayimg" RAYPRO_ROOT="$$(pwd)" \
             $(if $(filter rayview,$(PROGRAMS)),RAYVIEW="$$build/rayview")

# The same tests with millions of cases where a commit has thousands; hours.
night: test-binary $(PROGRAMS)
	RAYPRO_NIGHT=1 $(FOR_TESTS) $(BUILD)/raytests $(GTEST)

# Every object leaves a fragment; editors read the sum.
$(BUILD)/compile_commands.json: $(PROGRAMS:%=$(BUILD)/%)
	@{ echo '['; find $(BUILD)/obj -name '*.cmd' -exec cat {} + | sed '$$ s/,$$//'; echo ']'; } > $@

test: check test-binary $(PROGRAMS)
	$(FOR_TESTS) $(BUILD)/raytests $(GTEST)
	$(FOR_TESTS) sh script/runray.sh -fast
test-binary: $(BUILD)/raytests

check:
	@sh script/check_layers.sh
	@sh script/check_patches.sh

asan:
	$(MAKE) BUILD=$(BUILD)/asan OPTIMIZE=-O1 SANITIZE="-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer" test
tsan:
	$(MAKE) BUILD=$(BUILD)/tsan OPTIMIZE=-O1 SANITIZE="-fsanitize=thread" test

bench: $(patsubst bench/%.cpp,$(BUILD)/bench/%,$(BENCH_SOURCES)) raypro

# The scripts say what they measure and which options they take: TRADEOFF="-search 50 hello lens".
tradeoff: $(PROGRAMS)
	$(FOR_TESTS) sh script/tradeoff.sh $(if $(FULL),-full) $(TRADEOFF)
price: raypro
	BUILD=$(BUILD) sh script/price_of_features.sh $(PRICE)

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
