#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace ray {

/// Objects with stable addresses that are released in reverse order.
template <typename Thing>
class Arena {
 public:
  Thing& Add(const Thing& thing) {
    if (count_ == chunks_.size() * chunk) chunks_.push_back(std::make_unique<Thing[]>(chunk));
    Thing& place = chunks_[count_ / chunk][count_ % chunk];
    ++count_;
    return place = thing;
  }
  std::size_t Count() const { return count_; }
  /// Releases all objects except the first `count`.
  void Shrink(std::size_t count) { count_ = count; }

 private:
  static constexpr std::size_t chunk = 64;

  std::vector<std::unique_ptr<Thing[]>> chunks_;
  std::size_t count_ = 0;
};

}  // namespace ray
