#pragma once

namespace ray {

/// Functions for values of several kinds, put together for std::visit.
template <class... Lambda>
struct Overloaded : Lambda... {
  using Lambda::operator()...;
};
template <class... Lambda>
Overloaded(Lambda...) -> Overloaded<Lambda...>;

}  // namespace ray
