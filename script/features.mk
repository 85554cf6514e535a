# Which packages this machine has: sets HAS_..., CONTEXTS, FEATURES, and the flags of OpenEXR, yaml-cpp and Dear ImGui
# for the Makefile, which includes it, and stops where a package that everything needs is missing.

# What is on this machine. The compiler itself is asked, on empty input: a shell test of the header's
# name would have to know where compilers look.
probe = $(shell $(CXX) $(CPPFLAGS) $(3) -std=c++20 -include $(2) -fsyntax-only -x c++ /dev/null >/dev/null 2>&1 && echo yes || echo no)
pkg = $(shell pkg-config $(1) $(2) 2>/dev/null)

EXR_CFLAGS := $(or $(call pkg,--cflags,OpenEXR),-isystem /usr/include/OpenEXR -isystem /usr/include/Imath)
EXR_CFLAGS := $(patsubst -I%,-isystem%,$(EXR_CFLAGS))
EXR_LIBS := $(or $(call pkg,--libs,OpenEXR),-lOpenEXR -lImath -lIex)
YAML_CFLAGS := $(patsubst -I%,-isystem%,$(call pkg,--cflags,yaml-cpp))
YAML_LIBS := $(or $(call pkg,--libs,yaml-cpp),-lyaml-cpp)
IMGUI_CFLAGS := $(patsubst -I%,-isystem%,$(or $(call pkg,--cflags,imgui),-I/usr/include/imgui))
IMGUI_LIBS := $(or $(call pkg,--libs,imgui),-limgui)

ifneq ($(filter-out clean uninstall check dist,$(or $(MAKECMDGOALS),all)),)
HAS_JPEG := $(call probe,jpeg,jpeglib.h,-include stdio.h)
HAS_PNG := $(call probe,png,png.h,)
HAS_TBB := $(call probe,tbb,tbb/parallel_for.h,)
HAS_HWY := $(call probe,hwy,hwy/highway.h,)
HAS_JSON := $(call probe,json,nlohmann/json.hpp,)
HAS_EXR := $(call probe,exr,ImfOutputFile.h,$(EXR_CFLAGS))
HAS_YAML := $(call probe,yaml,yaml-cpp/parser.h,$(YAML_CFLAGS))
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
# Its panels need Dear ImGui.
HAS_IMGUI := $(if $(CONTEXTS),$(call probe,imgui,imgui.h,$(IMGUI_CFLAGS)),no)
empty :=
VIEWER := $(or $(subst $(empty) ,+,$(CONTEXTS)),no (install libepoxy-dev and, for windows, libglfw3-dev))
FEATURES := jpeg=yes png=yes exr=$(if $(filter yes,$(HAS_EXR)),yes,no (install libopenexr-dev)) \
            yaml=$(if $(filter yes,$(HAS_YAML)),yes,no (install libyaml-cpp-dev)) rayview=$(VIEWER) \
            panels=$(if $(filter yes,$(HAS_IMGUI)),yes,no (install libimgui-dev))
$(info features: $(FEATURES))
endif
