// raygrade grades students' ray tracers. Its options are in raygrade/Table.cpp.
#include <string>
#include <vector>

#include "source/app/Answers.h"
#include "source/app/GuardedMain.h"
#include "source/app/Status.h"
#include "source/app/options/CommandLine.h"
#include "grader/raygrade/GradeClass.h"

namespace ray {
namespace {

int Run(const std::vector<std::string>& words) {
  const auto options = ReadCommandLine<raygrade::GradeOptions>(Program::raygrade, words);
  if (!options.request) return raygrade::Grade(options);
  AnswerRequest(options);
  return status::done;
}

}  // namespace
}  // namespace ray

int main(int argc, char** argv) { return ray::GuardedMain(ray::Program::raygrade, argc, argv, ray::Run); }
