# The grader of students' programs, raygrade, and its tests. Included by the Makefile; rayimg diff uses the files next
# to it.
MAINS += grader/raygrade.cpp
PROGRAMS += raygrade
LIBRARY_SOURCES += $(filter-out $(MAINS),$(wildcard grader/*.cpp grader/mistakes/*.cpp grader/raygrade/*.cpp))
TEST_SOURCES += $(wildcard grader/tests/*.cpp)

$(BUILD)/raygrade: $(BUILD)/obj/grader/raygrade.o $(BUILD)/libray.a
	$(call link)
