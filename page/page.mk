# The page in a browser: the engine as WebAssembly, with clang 22, and what stands around it. Included by the Makefile.
#   make web        build/web/, which any static file server can serve: python3 -m http.server -d build/web
#   make site       build/site/: the page, the writeup, the gallery and the docs, with links between them
#   make web-test   its tests in Node and, where it is found, in Chromium
# WEB_CXX names another compiler that knows the target wasm32-wasi, WEB_HEADERS where hwy/ and nlohmann/ are, WEB_YAML the
# sources of yaml-cpp, which page/yaml.sh fetches. Without those the page does not read YAML.

WEB_CXX ?= $(firstword $(wildcard /usr/bin/clang++-22 /usr/bin/clang++-23) clang++-22)
WEB_HEADERS ?= /usr/include
WEB_YAML ?= $(BUILD)/yaml-cpp
WEB := $(BUILD)/web-objects
WEB_PAGE := $(BUILD)/web
# Nothing of the programs but their options and what -check says.
WEB_SOURCES := $(filter-out %/jpeg.cpp %/png.cpp %/exr.cpp %/ReadFile.cpp %/Threads.cpp %/OpenImageDenoise.cpp, \
                 $(wildcard R1/*.cpp R2/*.cpp R2/image_files/*.cpp R3/*.cpp R3/*/*.cpp \
                   $(foreach d,text sample scene parse accelerate integrate film render, \
                     source/$(d)/*.cpp source/$(d)/*/*.cpp source/$(d)/*/*/*.cpp) \
                   source/app/options/*.cpp source/app/manual/*.cpp page/*.cpp page/shim/*.cpp)) \
               $(foreach f,Check ContactCheck LampCheck Questions SceneSummary Memory,source/app/report/$(f).cpp) \
               source/inspect/ImageLines.cpp source/app/PreparedScene.cpp source/app/files/LayerImages.cpp
WEB_ALONE := $(filter $(ALONE),$(WEB_SOURCES))
WEB_TOGETHER := $(filter-out $(WEB_ALONE),$(WEB_SOURCES))
WEB_OBJECTS := $(WEB_ALONE:%.cpp=$(WEB)/obj/%.o) $(patsubst %,$(WEB)/obj/%all.o,$(sort $(dir $(WEB_TOGETHER))))
# Of yaml-cpp the parser alone: what makes events of a text.
YAML_PARSER := depthguard directives exceptions exp null parser regex_yaml scanner scanscalar scantag scantoken \
               simplekey singledocparser stream tag
HAS_WEB_YAML := $(if $(wildcard $(WEB_YAML)/src/parser.cpp),yes)
WEB_OBJECTS += $(if $(HAS_WEB_YAML),$(YAML_PARSER:%=$(WEB)/yaml/%.o))
# Exceptions in the older of two forms, which every browser since 2022 runs, and Node 20.
WEB_TARGET := --target=wasm32-wasi -Wno-deprecated
WEB_FLAGS := $(WEB_TARGET) -std=c++20 -O2 -ffp-contract=off -fno-math-errno -fno-trapping-math -fno-slp-vectorize \
             -msimd128 -fwasm-exceptions -mllvm -wasm-use-legacy-eh=true $(WARNINGS) -Wno-gnu-include-next
WEB_CPPFLAGS := -MD -MP -I. -Ipage/shim -isystem $(WEB)/include \
                -DRAYPRO_VERSION='"$(VERSION)"' -DRAYPRO_FEATURES='"web"' \
                $(if $(HAS_WEB_YAML),-DRAYPRO_YAML -isystem $(WEB_YAML)/include)
WEB_LINK := -mexec-model=reactor -Wl,-z,stack-size=8388608 -Wl,--max-memory=4294967296 -Wl,--strip-all
TBB_HEADERS := blocked_range enumerable_thread_specific global_control info parallel_for parallel_reduce task_arena \
               task_group

.PHONY: web web-test site
WEB_FILES := $(filter-out package.json,$(notdir $(wildcard page/browser/*)))
web: $(WEB_PAGE)/raypro.wasm $(WEB_PAGE)/examples.json $(WEB_FILES:%=$(WEB_PAGE)/%)
	@$(if $(HAS_WEB_YAML),true,echo "without YAML: page/yaml.sh fetches the sources of yaml-cpp")
	@echo "$(WEB_PAGE): python3 -m http.server -d $(WEB_PAGE), then http://localhost:8000"
$(WEB_PAGE)/%: page/browser/%
	@mkdir -p $(@D) && cp $< $@
$(WEB_PAGE)/examples.json: page/examples.py $(shell find scenes writeup/scenes -type f)
	@mkdir -p $(@D) && python3 $< scenes writeup/scenes > $@.new && mv $@.new $@

site: web
	@python3 page/site.py $(WEB_PAGE) $(BUILD)/site
web-test: site raypro rayimg
	@sh page/tests/run.sh $(BUILD)

# Names the packages that are missing before anything is compiled; where no dpkg says which, all of them.
WEB_PACKAGES := clang-22 lld-22 libc++-22-dev-wasm32 libc++abi-22-dev-wasm32 libclang-rt-22-dev-wasm32 wasi-libc \
                libhwy-dev nlohmann-json3-dev
WEB_ABSENT = $(or $(strip $(foreach p,$(WEB_PACKAGES),$(if $(shell dpkg-query -W -f='$${Status}' $(p) 2>/dev/null | \
               grep 'ok installed'),,$(p)))),$(WEB_PACKAGES))
WEB_PROBE = echo 'int main() {}' | $(WEB_CXX) $(WEB_TARGET) -include vector -x c++ - -o /dev/null 2>&1 || echo no
HAS_WEB_HEADERS = $(and $(wildcard $(WEB_HEADERS)/hwy/highway.h),$(wildcard $(WEB_HEADERS)/nlohmann/json.hpp))
HAS_WEB = $(if $(shell $(WEB_PROBE)),,$(HAS_WEB_HEADERS))
$(WEB)/flags: $(if $(filter web web-test site,$(MAKECMDGOALS)),web-tools)
.PHONY: web-tools
web-tools:
	@$(if $(HAS_WEB),true,echo "make web needs a compiler for WebAssembly and headers: apt-get install $(WEB_ABSENT)" >&2; exit 1)

$(WEB)/flags: FORCE
	$(call write,'$(subst ','\'',$(WEB_CXX) $(WEB_CPPFLAGS) $(WEB_FLAGS))')
# Highway and nlohmann's JSON are headers alone here; oneTBB is a loop.
$(WEB)/include/ready: $(WEB)/flags
	@mkdir -p $(WEB)/include/tbb
	@for headers in hwy nlohmann; do ln -sfn $(WEB_HEADERS)/$$headers $(WEB)/include/$$headers; done
	@for header in $(TBB_HEADERS); do echo '#include "page/shim/SerialTbb.h"' > $(WEB)/include/tbb/$$header.h; done
	@touch $@
$(WEB)/jumbo/%/all.cpp: FORCE
	$(call write,$(patsubst %,'#include "%"',$(filter $(wildcard $*/*.cpp),$(WEB_TOGETHER))))
.PRECIOUS: $(WEB)/jumbo/%/all.cpp
web_compile = @mkdir -p $(@D) && echo "  wasm  $(1)" && $(WEB_CXX) $(WEB_CPPFLAGS) $(WEB_FLAGS) $(WEB_SMALL) -c $< -o $@
# What runs once, before an image is made, is to be small.
$(WEB)/obj/source/app/% $(WEB)/obj/source/parse/%: WEB_SMALL := -Os
$(WEB)/obj/%/all.o: $(WEB)/jumbo/%/all.cpp $(WEB)/include/ready
	$(call web_compile,$*/*.cpp)
$(WEB)/obj/%.o: %.cpp $(WEB)/include/ready
	$(call web_compile,$<)
$(WEB)/yaml/%.o: $(WEB_YAML)/src/%.cpp $(WEB)/flags
	@mkdir -p $(@D) && echo "  wasm  yaml-cpp/src/$*.cpp" && \
	  $(WEB_CXX) $(WEB_FLAGS) -Os -w -I$(WEB_YAML)/include -I$(WEB_YAML)/src -c $< -o $@
$(WEB_PAGE)/raypro.wasm: $(WEB_OBJECTS)
	@mkdir -p $(@D) && echo "  link  $@" && $(WEB_CXX) $(WEB_TARGET) $(WEB_LINK) $^ -o $@
-include $(shell find $(WEB)/obj -name '*.d' 2>/dev/null)
