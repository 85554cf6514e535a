#pragma once

namespace ray {

/// A set of functions for values of several types, for std::visit.
template <class... Lambda>
struct Overloaded : Lambda... {
  using Lambda::operator()...;
};
template <class... Lambda>
Overloaded(Lambda...) -> Overloaded<Lambda...>;

}  // namespace ray
