// raygrade grades students' ray tracers. Its options are in options/RaygradeTable.cpp.
#include <string>
#include <vector>

#include "source/app/GuardedMain.h"
#include "source/app/Status.h"
#include "source/app/Tasks.h"
#include "source/app/options/CommandLine.h"
#include "grader/raygrade/GradeClass.h"

namespace ray {
namespace {

int Run(const std::vector<std::string>& words) {
  const Options options = ReadCommandLine(Program::raygrade, words);
  if (options.task == Task::grade) return raygrade::Grade(options.grade);
  DoTask(options);
  return status::done;
}

}  // namespace
}  // namespace ray

int main(int argc, char** argv) { return ray::GuardedMain(ray::Program::raygrade, argc, argv, ray::Run); }
