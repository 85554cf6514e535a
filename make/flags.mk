# How everything is compiled and linked. CXX, CXXFLAGS, CPPFLAGS and LDFLAGS given by the user come after ours and so win.

# What a user adds may not change how numbers are rounded: rays would leak between triangles, or pictures differ.
UNSAFE := $(filter -ffast-math -Ofast -ffp-contract=fast -ffp-contract=on -funsafe-math-optimizations -fassociative-math \
                   -freciprocal-math -ffinite-math-only -fno-signed-zeros,$(CXXFLAGS) $(CPPFLAGS) $(OPTIMIZE))
ifneq ($(strip $(UNSAFE)),)
$(error $(strip $(UNSAFE)) changes how numbers are rounded, and with it what rays hit. Build without it)
endif

include make/features.mk

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
