# From sources to objects, archives and programs.
.PRECIOUS: $(BUILD)/obj/%.o $(BUILD)/jumbo/%/all.cpp

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
         $(if $(filter-out file,$(origin TEST_SOURCES)),tests/% grader/tests/% rayimg/tests/%) $(if $(filter yes,$(JUMBO)),,%)
present = $(filter-out $(ABSENT),$(1))
alone = $(filter $(ALONE),$(call present,$(1)))
together = $(filter-out $(ALONE),$(call present,$(1)))
objects = $(patsubst %.cpp,$(BUILD)/obj/%.o,$(call alone,$(1))) \
          $(patsubst %,$(BUILD)/obj/%all.o,$(sort $(dir $(call together,$(1)))))

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
	$(call write,$(patsubst %,'#include "%"',$(call together,$(filter-out $(MAINS),$(wildcard $*/*.cpp)))))
FORCE:

compile = @mkdir -p $(@D) && echo "  c++   $(1)" && \
          $(CXX) $(PRECOMPILED_HERE) $(OUR_CPPFLAGS) $(FEATURES_HERE) $(CPPFLAGS) $(OUR_CXXFLAGS) $(OPTIMIZE_HERE) $(CXXFLAGS) -c $< -o $@
# What runs once in a run is compiled the faster for it; where samples are made many at a time, loops become vector
# instructions.
$(BUILD)/obj/source/app/% $(BUILD)/obj/rayimg/% $(BUILD)/obj/source/parse/% $(BUILD)/obj/tests/% $(BUILD)/obj/grader/tests/% $(BUILD)/obj/rayimg/tests/% $(BUILD)/unit/%: \
  OPTIMIZE_HERE := $(if $(filter -O2 -O3,$(OPTIMIZE)),-O1)
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
# What most tests include is compiled once. Compiler caches need to be told that they may trust it.
PRECOMPILED := $(BUILD)/tests.h.gch
export CCACHE_SLOPPINESS ?= pch_defines,time_macros
$(PRECOMPILED): tests/Headers.h $(BUILD)/flags
	$(call compile,$<)
$(PRECOMPILED): FEATURES_HERE :=
$(PRECOMPILED): OPTIMIZE_HERE = -x c++-header $(if $(filter -O2 -O3,$(OPTIMIZE)),-O1)
OF_TESTS := $(call objects,$(TEST_SOURCES)) $(TEST_SOURCES:%.cpp=$(BUILD)/unit/%.o)
$(OF_TESTS): private PRECOMPILED_HERE := -include $(PRECOMPILED:.gch=)
$(OF_TESTS): $(PRECOMPILED)
$(BUILD)/unit/%.o: %.cpp $(BUILD)/flags $(BUILD)/features
	$(call compile,$<)
$(BUILD)/unit/%.o: FEATURES_HERE := $(FEATURE_CPPFLAGS)
$(BUILD)/obj/%/all.o: $(BUILD)/jumbo/%/all.cpp $(BUILD)/flags
	$(call compile,$*/*.cpp)
$(BUILD)/obj/%.o: %.cpp $(BUILD)/flags
	$(call compile,$<)

# What all programs share, and what is one program's own, so that raypro does not wait for the viewer.
OF_RAYVIEW := $(filter source/draw/% source/inspect/% source/view/% source/app/rayview/%,$(LIBRARY_SOURCES))
archive = @echo "  ar    $@" && rm -f $@ && $(AR) rcs $@ $^
$(BUILD)/libray.a: $(call objects,$(filter-out $(OF_RAYVIEW) $(OF_RAYIMG),$(LIBRARY_SOURCES)))
	$(archive)
$(BUILD)/librayview.a: $(call objects,$(OF_RAYVIEW))
	$(archive)
$(BUILD)/librayimg.a: $(call objects,$(OF_RAYIMG))
	$(archive)

$(BUILD)/rayview $(BUILD)/raytests $(BUILD)/unit/% $(BUILD)/bench/view $(BUILD)/targets/%: LIBS += $(VIEWER_LIBS)

# What the archive of all holds is looked up last.
link = @mkdir -p $(@D) && echo "  link  $@" && $(CXX) $(OUR_CXXFLAGS) $(CXXFLAGS) \
       $(filter-out %/libray.a,$^) $(BUILD)/libray.a $(LDFLAGS) $(1) $(LIBS) -o $@
$(BUILD)/rayview: $(BUILD)/librayview.a
$(patsubst source/app/%.cpp,$(BUILD)/%,$(filter source/app/%,$(MAINS))): $(BUILD)/%: $(BUILD)/obj/source/app/%.o $(BUILD)/libray.a
	$(call link)
$(BUILD)/raytests: $(call objects,$(TEST_SOURCES)) $(BUILD)/librayimg.a $(BUILD)/librayview.a $(BUILD)/libray.a
	$(call link,-lgtest $(QUADMATH))
$(BUILD)/bench/%: $(BUILD)/obj/bench/%.o $(BUILD)/librayview.a $(BUILD)/libray.a
	$(call link,$(if $(shell grep -l benchmark/benchmark.h bench/$*.cpp),-lbenchmark))

# For editors: every file by itself, as JUMBO=no compiles it.
$(BUILD)/compile_commands.json: $(BUILD)/flags $(BUILD)/features
	@for file in $(call present,$(LIBRARY_SOURCES) $(TEST_SOURCES) $(BENCH_SOURCES) $(MAINS)); do \
	  printf ',\n{"directory":"%s","file":"%s","command":"%s -c %s"}' "$$PWD" $$file \
	    "$$(cat $(BUILD)/flags $(BUILD)/features | tr '\n' ' ' | sed 's/[\"]/\\&/g')" $$file; done | sed '1s/,/[/; $$s/$$/\n]/' > $@

# A test file by itself, and what it may need.
$(BUILD)/unit/%: $(BUILD)/unit/%.o $(BUILD)/unit/tests/Main.o $(BUILD)/unit/tests/source/app/Program.o $(BUILD)/librayimg.a \
                 $(BUILD)/librayview.a $(BUILD)/libray.a
	$(call link,-lgtest $(QUADMATH))

-include $(shell find $(BUILD)/obj $(BUILD)/unit $(BUILD)/tests.h.d -name '*.d' 2>/dev/null)
