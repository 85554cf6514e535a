#pragma once

#include <string>

#include "source/view/live/TracedPictures.h"

namespace ray {

/// How far the image that is rendered has come, in words that change slowly enough to be read.
class RenderStatus {
 public:
  /// `now`: in seconds of ticks.
  void Update(const TracedPictures& pictures, double now);
  /// "4 of 16 samples 31 % 0.5 Mrays/s 12 s left"; empty without any image.
  const std::string& Text() const { return text_; }

 private:
  struct Seen {
    std::uint64_t job = 0;
    int samples = 0;
    bool has_ended = false;
    friend bool operator==(const Seen&, const Seen&) = default;
  };
  std::string text_;
  Seen seen_;          // what the text was made for
  double since_ = -1;  // seconds of ticks
};

}  // namespace ray
