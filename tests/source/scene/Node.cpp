#include "source/scene/Node.h"
#include "R3/ShapeKind.h"

#include <gtest/gtest.h>
#include <pthread.h>

namespace {

ray::Node Chain(int levels) {
  ray::Node node;
  node.shape = R3::MakeShape("sphere", {0, 0, 0, 1});
  SetBounds(node);
  for (int i = 0; i < levels; ++i) {
    ray::Node group;
    group.children.push_back(std::move(node));
    SetBounds(group);
    node = std::move(group);
  }
  return node;
}

TEST(Node, BoundsAreInTheParentsCoordinates) {
  ray::Node group;
  group.transform.m = {{{2, 0, 0, 10}, {0, 0, -1, 0}, {0, 1, 0, 0}}};  // doubled along x, a quarter turn about x
  ray::Node box;
  box.shape = R3::MakeShape("box", {0, 0, 0, 1, 2, 3});
  SetBounds(box);
  EXPECT_EQ(box.bounds, (R3::Box{{0, 0, 0}, {1, 2, 3}}));
  group.children.push_back(std::move(box));
  SetBounds(group);
  EXPECT_EQ(group.bounds, (R3::Box{{10, -3, 0}, {12, 0, 2}}));
}

TEST(Node, AnEmptyGroupHasAnEmptyBoxWhateverItsTransform) {
  ray::Node group;
  group.transform.m[0][3] = 5;
  SetBounds(group);
  EXPECT_TRUE(group.bounds.IsEmpty());
}

TEST(Node, ALineCountsInTheBounds) {
  ray::Node node;
  node.line = std::make_unique<R3::Segment>(R3::Segment{{3, 0, 0}, {0, 4, -1}});
  SetBounds(node);
  EXPECT_EQ(node.bounds, (R3::Box{{0, 0, -1}, {3, 4, 0}}));
}

void* BuildAndDestroy(void*) {
  { const ray::Node chain = Chain(1'000'000); }
  return nullptr;
}

TEST(Extremes, H1_AMillionLevelsAreBuiltAndDestroyedWithLittleStack) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, 256 * 1024), 0);
  pthread_t thread;
  ASSERT_EQ(pthread_create(&thread, &attributes, BuildAndDestroy, nullptr), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

}  // namespace
