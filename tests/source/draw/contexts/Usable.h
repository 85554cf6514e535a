#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "source/draw/contexts/Context.h"

namespace ray::testing {

/// A kind of context without a window, created before each test. The test is skipped if the machine does not support
/// it.
class WithContext : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    try {
      context = MakeOffscreenContext(GetParam());
    } catch (const ContextError& error) {
      GTEST_SKIP() << "this machine has no such context: " << error.what();
    }
  }

  std::unique_ptr<Context> context;
};

inline std::string KindOf(const ::testing::TestParamInfo<std::string>& info) { return info.param; }

}  // namespace ray::testing
