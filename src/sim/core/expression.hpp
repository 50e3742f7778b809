#pragma once
#include "scene/expression/tree.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace simreel::sim {

/// Scene expression evaluated on numbers, without access to neighbour cells. Sums, products, quotients,
/// square roots and powers with small integer exponents use double. The functions exp, log, sin, cos, tanh
/// and other powers use the single-precision functions of glsl/common/exact.glsl. The result therefore has
/// the same bits on every machine.
class Expression {
 public:
  /// Maps a variable name to the variable's index in the `values` argument of at(); returns -1 if the name
  /// is unknown.
  using Place = std::function<int(const std::string& name)>;

  /// Parses `text`; throws scene::ExpressionMistake. `names` lists the allowed names for the error message
  /// about an unknown name. `lookups` is passed to parseExpression().
  Expression(std::string_view text, const Place& place, const std::vector<std::string>& names,
             std::span<const char* const> lookups = {});

  /// Evaluates the expression; `place` of the constructor gives each variable's index in `values`.
  /// `element` and `seed` determine the result of random(k).
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
