// share/python: the module raypro.py and its notebook, run by the Python that is installed.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/Project.h"

namespace {

void ExpectSuccessOf(const std::string& script, const std::string& words = {}) {
  if (!std::getenv("RAYPRO")) GTEST_SKIP() << "RAYPRO is not set";
  if (std::system("python3 -c 'import sys; sys.exit(sys.version_info < (3, 9))' > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "python3, of 3.9 or later, is not installed";
  const std::filesystem::path root = std::filesystem::absolute(project::Root());
  const std::string command = "PYTHONDONTWRITEBYTECODE=1 python3 '" + (root / "tests/python" / script).string() + "'" +
                              (words.empty() ? "" : " '" + (root / words).string() + "'");
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

TEST(Python, TheModuleDoesWhatItsTestsSay) { ExpectSuccessOf("test_raypro.py"); }

TEST(Python, AWheelOfTheProgramsRendersWhereItIsUnpacked) { ExpectSuccessOf("test_wheel.py"); }

TEST(Python, CellsOfTheNotebookRunOneAfterTheOther) {
  ExpectSuccessOf("run_notebook.py", "share/python/first_steps.ipynb");
}

}  // namespace
