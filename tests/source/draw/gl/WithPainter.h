#pragma once

#include <memory>

#include "source/draw/gl/Painter.h"
#include "tests/source/draw/contexts/Usable.h"

namespace ray::testing {

/// A painter in a context without a window, created before each test.
class WithPainter : public WithContext {
 protected:
  void SetUp() override {
    WithContext::SetUp();
    if (context) painter = std::make_unique<Painter>(Canvas::Target::own);
  }
  // In reverse order of construction.
  void TearDown() override { painter.reset(); }

  std::unique_ptr<Painter> painter;
};

}  // namespace ray::testing
