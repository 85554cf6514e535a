# raypro: two commands make a picture and a green test run: script/setup.sh, then make test.
#   make            the programs, under build/ (another place: make BUILD=elsewhere)
#   make test       make check, all tests, and a few pictures of the writeup
#   make unit T=R3/Csg  one test file, in a program of its own, linked with what is built
#   make check      who may include whom; that elementary functions are our own; that all who name packages name the same;
#                   the English of comments
#   make clean      removes build/
# With more cases, under sanitizers, by other tools (make/checks.mk):
#   make night      the tests with millions of cases; GTEST=--gtest_filter=... for some of them
#   make asan       the tests again under address and undefined-behavior sanitizers
#   make tsan       the tests again under ThreadSanitizer
#   make tidy       clang-tidy over the library; TIDY=clang-tidy-19 for another one
#   make fuzz       the fuzz targets, with clang, under build/fuzz; script/fuzz.sh runs them
#   make fuzz-scenes  random scenes: hits in exact arithmetic, bounds on light, one mean; SCENES=100000 from SEED=1 on,
#                   SEED=2 STEP=3 for those whose surfaces touch
# Measurements (make/measure.mk):
#   make bench      the benchmark programs
#   make tiny       the smallest tracer, as source and as executable, and how small it is
#   make tradeoff   error over seconds for every knob, as CSV and plots under build/tradeoff; FULL=1 for hours
# To be handed on (make/install.mk, page/page.mk):
#   make install    PREFIX=/usr/local DESTDIR= bindir= datadir= mandir= docdir=
#   make uninstall  removes what that installed
#   make installcheck  both of them, tried in a folder for it
#   make dist       what is committed, as build/raypro-VERSION.tar.gz
#   make web        the page that renders in a browser, under build/web
#   make web-test   its tests
#   make site       the page with the writeup, the gallery and the docs
# HAS_EXR=no, HAS_YAML=no and CONTEXTS= (or CONTEXTS="egl osmesa") leave out what could be built here.

.DEFAULT_GOAL := all
ifeq ($(origin CXX),default)
CXX := g++
endif
BUILD ?= build
ifneq ($(words $(BUILD)),1)
$(error BUILD must be one word, without blanks, not "$(BUILD)"; the folder of the sources may have some)
endif
VERSION := 0.1.0
OPTIMIZE ?= -O2
JOBS ?= $(shell nproc 2> /dev/null || getconf _NPROCESSORS_ONLN)
include make/flags.mk

MAINS := $(wildcard source/app/ray*.cpp)
# rayview is built where there is something to draw with.
PROGRAMS := raypro $(if $(CONTEXTS),rayview)
LIBRARY_SOURCES := $(filter-out $(MAINS),$(wildcard R1/*.cpp R2/*.cpp R2/*/*.cpp R3/*.cpp R3/*/*.cpp source/*/*.cpp \
                     source/*/*/*.cpp source/*/*/*/*.cpp))
TEST_SOURCES := $(wildcard tests/*.cpp tests/R1/*.cpp tests/R2/*.cpp tests/R2/*/*.cpp tests/R3/*.cpp \
                  tests/source/*/*.cpp tests/source/*/*/*.cpp tests/source/*/*/*/*.cpp \
                  $(foreach d,every agree extremes closed_form bad_scenes regressions images,tests/$(d)/*.cpp))
BENCH_SOURCES := $(wildcard bench/*.cpp)
FUZZ_SOURCES := $(wildcard fuzz/*.cpp)
include grader/grader.mk
include rayimg/rayimg.mk

.PHONY: all $(PROGRAMS) test check clean test-binary compile_commands FORCE
all: $(PROGRAMS) compile_commands
$(PROGRAMS): %: $(BUILD)/%
test-binary: $(BUILD)/raytests
compile_commands: $(BUILD)/compile_commands.json

include make/compile.mk
include make/measure.mk
include make/install.mk
include page/page.mk

# Tests find the programs and the project's files through these. The shell names the folders: make takes blanks in
# their names for ends of words.
FOR_TESTS := build=$$(cd $(BUILD) && pwd) && RAYPRO="$$build/raypro" RAYIMG="$$build/rayimg" RAYGRADE="$$build/raygrade" \
             RAYPRO_ROOT="$$(pwd)" TINY="$$build/tiny" $(if $(filter rayview,$(PROGRAMS)),RAYVIEW="$$build/rayview")
include make/checks.mk

# Compiles and runs on all cores, unless -j said on how many. Benchmarks that need no further package are compiled too,
# lest nobody notice that they no longer do. A page that was built is brought up to date and tested as well.
test: $(if $(wildcard $(BUILD)/web/raypro.wasm),web)
	$(MAKE) $(if $(findstring jobserver,$(MAKEFLAGS)),,-j$(JOBS)) check test-binary $(PROGRAMS) $(TINY) \
	  $(patsubst %.cpp,$(BUILD)/obj/%.o,$(call present,bench/live.cpp bench/trade.cpp bench/view.cpp))
	$(FOR_TESTS) JOBS=$(JOBS) sh script/run_tests.sh $(BUILD)/raytests $(GTEST)
	$(FOR_TESTS) sh script/runray.sh -fast
	@sh page/tests/run.sh $(BUILD)

# Benches need libraries that not every machine has; this one needs none to be compiled.
check: $(BUILD)/obj/bench/kernels.o
	@sh script/check_layers.sh
	@sh script/check_functions.sh
	@sh script/check_packages.sh
	@sh script/check_english.sh

clean:
	rm -rf $(BUILD)
