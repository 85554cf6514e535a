#include <gtest/gtest.h>

#include "source/draw/contexts/Context.h"
#include "tests/Folder.h"
#include "tests/Sanitizers.h"
#include "tests/source/draw/contexts/Usable.h"

// Called by the leak sanitizer: OSMesa 22.3 keeps 160 bytes for every context that was ever current, even after its
// destruction.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa.so"; }

// Leaks are searched at the end, when the driver of a window is unloaded. Memory referenced only by its variables would
// count as a leak: 128 bytes, from Mesa 22.3.
#ifdef RAYTESTS_ADDRESS_SANITIZER
extern "C" int dlclose(void*) { return 0; }
#endif

namespace {

using ray::ContextError;

std::string Complaint(const std::string& kind) {
  return project::MessageOf<ContextError>([&] { ray::MakeOffscreenContext(kind); });
}

TEST(Contexts, AnUnknownKindListsTheAvailableOnes) {
  EXPECT_EQ(Complaint("vulkan"), "unknown context 'vulkan'; choose one of auto, egl, osmesa");
}

TEST(Contexts, AKindNotBuiltInNamesItsPackage) {
  const std::string again = " and rebuild";
#ifdef RAYVIEW_EGL
  EXPECT_EQ(Complaint("egl").find("not built in"), std::string::npos);
#else
  EXPECT_EQ(Complaint("egl"), "egl is not built in; install libepoxy-dev" + again);
#endif
#ifdef RAYVIEW_OSMESA
  EXPECT_EQ(Complaint("osmesa").find("not built in"), std::string::npos);
#else
  EXPECT_EQ(Complaint("osmesa"), "osmesa is not built in; install libosmesa6-dev" + again);
#endif
#ifdef RAYVIEW_GLFW
  EXPECT_TRUE(ray::HasWindows());
#else
  EXPECT_FALSE(ray::HasWindows());
  EXPECT_THROW(ray::MakeWindow(10, 10, ""), ContextError);
#endif
}

// Without a requested kind, there must be an image wherever any kind works.
TEST(Contexts, AutoWorksWhereAnyKindDoes) {
  std::string works;
  for (const std::string& kind : ray::OffscreenContextKinds())
    if (works.empty() && Complaint(kind).empty()) works = kind;
  if (works.empty()) {
    EXPECT_EQ(Complaint("auto").find('\n'), std::string::npos);
    GTEST_SKIP() << "no kind of context works on this machine";
  }
  EXPECT_EQ(ray::MakeOffscreenContext("auto")->Name().substr(0, works.size() + 1), works + ":");
}

class ContextOfKind : public ray::testing::WithContext {};

TEST_P(ContextOfKind, NamesItsKindAndRenderer) {
  EXPECT_EQ(context->Name().substr(0, GetParam().size() + 2), GetParam() + ": ");
  EXPECT_NE(context->Name().find("OpenGL "), std::string::npos) << context->Name();
  EXPECT_EQ(context->Name().find("unknown"), std::string::npos) << context->Name();
}

TEST_P(ContextOfKind, CanBeCreatedAgainAndNextToAnother) {
  const std::string name = context->Name();
  context.reset();
  context = ray::MakeOffscreenContext(GetParam());
  {
    const auto other = ray::MakeOffscreenContext(GetParam());
    EXPECT_EQ(other->Name(), name);
  }
  context.reset();
  EXPECT_EQ(ray::MakeOffscreenContext(GetParam())->Name(), name);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ContextOfKind);
INSTANTIATE_TEST_SUITE_P(EveryKind, ContextOfKind, ::testing::ValuesIn(ray::OffscreenContextKinds()),
                         ray::testing::KindOf);

}  // namespace
