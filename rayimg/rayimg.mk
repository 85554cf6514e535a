# The image tool, rayimg, and its tests. Included by the Makefile.
OF_RAYIMG := $(filter-out rayimg/rayimg.cpp,$(wildcard rayimg/*.cpp))
MAINS += rayimg/rayimg.cpp
PROGRAMS += rayimg
LIBRARY_SOURCES += $(OF_RAYIMG)
TEST_SOURCES += $(wildcard rayimg/tests/*.cpp)

$(BUILD)/rayimg: $(BUILD)/obj/rayimg/rayimg.o $(BUILD)/librayimg.a $(BUILD)/libray.a
	$(call link)
