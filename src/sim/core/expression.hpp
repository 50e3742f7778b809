#pragma once
#include "scene/expression/tree.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace simreel::sim {

/// An expression of a scene as numbers are put in, without neighbours. Sums, products, quotients and roots
/// are in double; exp, log, sin, cos, tanh and powers that are no small whole number are the
/// single-precision functions of glsl/common/exact.glsl. So the result has the same bits on every machine.
class Expression {
 public:
  /// Returns the place among the values of a name; -1 where it is unknown.
  using Place = std::function<int(const std::string& name)>;

  /// Throws scene::ExpressionMistake. `lookups` as parseExpression(); `names`: lists what may be used, for
  /// the message at an unknown name.
  Expression(std::string_view text, const Place& place, const std::vector<std::string>& names,
             std::span<const char* const> lookups = {});

  /// Returns the value for `values`, by place. `element` and `seed` choose what random(k) gives.
  [[nodiscard]] double at(std::span<const double> values, std::uint32_t element = 0,
                          std::uint32_t seed = 0) const;

 private:
  struct Node {
    scene::Operation operation = scene::Operation::number;
    double number = 0;
    int place = -1;
    int arguments[3] = {-1, -1, -1};
  };
  std::vector<Node> nodes_;
  mutable std::vector<double> results_;
};

}  // namespace simreel::sim
