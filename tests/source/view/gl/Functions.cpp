#include "source/view/gl/Functions.h"

#include <gtest/gtest.h>

#include "tests/source/view/contexts/Usable.h"

namespace {

/// A driver that lacks a function.
class Lacking : public ray::Context {
 public:
  Lacking(const ray::Context& whole, std::string missing) : whole_(whole), missing_(std::move(missing)) {}
  std::string Name() const override { return "old"; }
  Function Find(const char* name) const override { return name == missing_ ? nullptr : whole_.Find(name); }

 private:
  const ray::Context& whole_;
  std::string missing_;
};

void SayTwoPointOne(GLenum what, GLint* value) { *value = what == GL_MAJOR_VERSION ? 2 : 1; }

/// One that has them all, but only in name.
class Outdated : public ray::Context {
 public:
  std::string Name() const override { return "old"; }
  Function Find(const char*) const override { return reinterpret_cast<Function>(SayTwoPointOne); }
};

std::string Complaint(const ray::Context& context) {
  try {
    const ray::Functions functions(context);
  } catch (const ray::ContextError& error) {
    return error.what();
  }
  return "";
}

class Functions : public ray::testing::WithContext {};

TEST_P(Functions, AreAllFound) { EXPECT_EQ(Complaint(*context), ""); }

TEST_P(Functions, OfWhichOneIsMissingAreRefusedWithItsName) {
  EXPECT_EQ(Complaint(Lacking(*context, "glDrawArrays")), "old lacks the function glDrawArrays; OpenGL 3.3 is needed");
}

// A call through null would crash much later, where nobody knows why.
TEST_P(Functions, AreEachMissedWhenMissing) {
#define FUNCTION(name) EXPECT_NE(Complaint(Lacking(*context, "gl" #name)).find("gl" #name), std::string::npos);
#include "source/view/gl/functions.def"
#undef FUNCTION
}

TEST(OldOpenGl, IsRefusedWithItsVersion) { EXPECT_EQ(Complaint(Outdated()), "old has OpenGL 2.1; 3.3 is needed"); }

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Functions);
INSTANTIATE_TEST_SUITE_P(EveryKind, Functions, ::testing::ValuesIn(ray::OffscreenContextKinds()), ray::testing::KindOf);

}  // namespace
