// Many machines, through the engines that classes and labs have: the tests start their own on loopback.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace {

constexpr int something_is_missing = 77;

void RunScript(const std::string& script, const std::string& what) {
  const std::string command = "CASE=" + what + " '" + (project::Root() / "tests/farm" / script).string() + "'";
  const int status = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(status)) << command;
  if (WEXITSTATUS(status) == something_is_missing) GTEST_SKIP() << script << " needs more than is installed here";
  EXPECT_EQ(WEXITSTATUS(status), 0) << command;
}

TEST(Parallel, NothingThatHappensToAPartChangesTheImage) {
  NEEDS_THE_PROGRAM();
  RunScript("parallel.sh", "accidents");
}

TEST(Parallel, AMachineThatVanishesIsDoneWithout) {
  NEEDS_THE_PROGRAM();
  RunScript("parallel.sh", "host");
}

TEST(Parallel, MachinesNeedNoCommonFolder) {
  NEEDS_THE_PROGRAM();
  RunScript("parallel.sh", "copy");
}

TEST(Parallel, APartThatAlwaysFailsIsNamed) {
  NEEDS_THE_PROGRAM();
  RunScript("parallel.sh", "hopeless");
}

TEST(Parallel, ATimeLimitIsThatOfAllMachinesTogether) {
  NEEDS_THE_PROGRAM();
  RunScript("parallel.sh", "time");
}

TEST(Parallel, FramesOfAMovieAreThoseOfOneMachine) {
  NEEDS_THE_PROGRAM();
  RunScript("parallel.sh", "movie");
}

TEST(Parallel, AJobThatAnotherOfItsNameOvertookBeginsAgain) {
  NEEDS_THE_PROGRAM();
  RunScript("parallel.sh", "overtaken");
}

TEST(Parallel, TwoJobsOfOneNameDoNoHarm) {
  NEEDS_THE_PROGRAM();
  RunScript("parallel.sh", "twice");
}

TEST(Slurm, NothingThatHappensToAPartChangesTheImage) {
  NEEDS_THE_PROGRAM();
  RunScript("slurm.sh", "accidents");
}

TEST(Slurm, AnErrorTargetIsReachedInRounds) {
  NEEDS_THE_PROGRAM();
  RunScript("slurm.sh", "rounds");
}

TEST(Slurm, ATimeLimitIsThatOfAllMachinesTogether) {
  NEEDS_THE_PROGRAM();
  RunScript("slurm.sh", "time");
}

TEST(Slurm, FramesOfAMovieAreThoseOfOneMachine) {
  NEEDS_THE_PROGRAM();
  RunScript("slurm.sh", "movie");
}

TEST(Slurm, AJobThatAnotherOfItsNameOvertookBeginsAgain) {
  NEEDS_THE_PROGRAM();
  RunScript("slurm.sh", "overtaken");
}

TEST(Slurm, TwoJobsOfOneNameDoNoHarm) {
  NEEDS_THE_PROGRAM();
  RunScript("slurm.sh", "twice");
}

TEST(Slurm, ANodeThatVanishesIsDoneWithout) {
  NEEDS_THE_PROGRAM();
  RunScript("slurm.sh", "node");
}

TEST(Slurm, APartThatAlwaysFailsIsNamed) {
  NEEDS_THE_PROGRAM();
  RunScript("slurm.sh", "hopeless");
}

}  // namespace
