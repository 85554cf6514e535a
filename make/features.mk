# Which packages this machine has: sets HAS_..., CONTEXTS, FEATURES, and the flags of OpenEXR, yaml-cpp and Dear ImGui
# for the Makefile, which includes it, and stops where a package that everything needs is missing.

pkg = $(shell pkg-config $(1) $(2) 2>/dev/null)

EXR_CFLAGS := $(or $(call pkg,--cflags,OpenEXR),-isystem /usr/include/OpenEXR -isystem /usr/include/Imath)
EXR_CFLAGS := $(patsubst -I%,-isystem%,$(EXR_CFLAGS))
EXR_LIBS := $(or $(call pkg,--libs,OpenEXR),-lOpenEXR -lImath -lIex)
YAML_CFLAGS := $(patsubst -I%,-isystem%,$(call pkg,--cflags,yaml-cpp))
YAML_LIBS := $(or $(call pkg,--libs,yaml-cpp),-lyaml-cpp)
IMGUI_CFLAGS := $(patsubst -I%,-isystem%,$(or $(call pkg,--cflags,imgui),-I/usr/include/imgui))
# Debian's Dear ImGui leaves fonts to a library of their own, which only pkg-config would tell.
STB := $(if $(filter /%,$(shell $(CXX) -print-file-name=libstb.so 2>/dev/null)),-lstb)
IMGUI_LIBS := $(or $(call pkg,--libs,imgui),-limgui $(STB))

ifneq ($(filter-out clean uninstall check dist,$(or $(MAKECMDGOALS),all)),)
FOUND := $(shell $(CXX) $(CPPFLAGS) $(EXR_CFLAGS) $(YAML_CFLAGS) $(IMGUI_CFLAGS) -std=c++20 -E -P -x c++ make/features.h)
ifeq ($(filter compiler,$(FOUND)),)
$(error $(CXX) does not work as a compiler of C++20. Run script/setup.sh, or name another one: make CXX=clang++)
endif
has = $(if $(filter $(1),$(FOUND)),yes,no)
HAS_EXR := $(call has,exr)
HAS_YAML := $(call has,yaml)
MISSING := $(if $(filter jpeg,$(FOUND)),,libjpeg-dev) $(if $(filter png,$(FOUND)),,libpng-dev) \
           $(if $(filter tbb,$(FOUND)),,libtbb-dev) $(if $(filter hwy,$(FOUND)),,libhwy-dev) \
           $(if $(filter json,$(FOUND)),,nlohmann-json3-dev)
ifneq ($(strip $(MISSING)),)
$(error These packages are missing: $(strip $(MISSING)). Run script/setup.sh, or install them and try again)
endif
# The viewer needs libepoxy, which finds OpenGL, Dear ImGui, which lays out all that is written, and at least one way to
# draw.
CONTEXTS := $(if $(and $(filter epoxy,$(FOUND)),$(filter imgui,$(FOUND))),$(filter $(FOUND),glfw egl osmesa))
empty :=
VIEWER := $(or $(subst $(empty) ,+,$(CONTEXTS)),no (install libepoxy-dev libimgui-dev and, for windows, libglfw3-dev))
FEATURES := jpeg=yes png=yes exr=$(if $(filter yes,$(HAS_EXR)),yes,no (install libopenexr-dev)) \
            yaml=$(if $(filter yes,$(HAS_YAML)),yes,no (install libyaml-cpp-dev)) rayview=$(VIEWER)
$(info features: $(FEATURES))
endif
