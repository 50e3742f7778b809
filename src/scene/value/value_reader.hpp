#pragma once
#include "scene/json/diagnostics.hpp"
#include "scene/json/json_node.hpp"
#include "scene/value/fields.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::scene {

/// Converts nodes to values of the field `name`. If a function finds an error, it reports the error and
/// returns nullopt.
class ValueReader {
 public:
  ValueReader(const char* name, Range range, const char* unit, Diagnostics& diagnostics)
      : name_(name),
        range_{std::max(range.min, -maxMagnitude), std::min(range.max, maxMagnitude)},
        unit_(unit),
        diagnostics_(diagnostics) {}
  ValueReader(const char* name, Diagnostics& diagnostics) : ValueReader(name, Range{}, "", diagnostics) {}

  [[nodiscard]] std::optional<bool> boolean(const Node& node) const;
  [[nodiscard]] std::optional<double> number(const Node& node) const;
  [[nodiscard]] std::optional<int> integer(const Node& node) const;
  [[nodiscard]] std::optional<std::string> text(const Node& node) const;
  [[nodiscard]] std::optional<glm::vec3> vector(const Node& node, Flat flat = {}) const;
  /// Reads a list of three numbers, or the text of a colour (colorOf).
  [[nodiscard]] std::optional<glm::vec3> color(const Node& node) const;
  [[nodiscard]] std::optional<glm::ivec2> pair(const Node& node) const;
  [[nodiscard]] std::optional<int> oneOf(const Node& node, std::span<const char* const> names) const;

  /// True if the node is a list; otherwise reports that `expected` was expected.
  [[nodiscard]] bool isList(const Node& node, const char* expected) const;
  /// True if the node has the kind; otherwise reports "expected <expected>, found ...".
  [[nodiscard]] bool expect(const Node& node, Node::Kind kind, const char* expected) const;

 private:
  [[nodiscard]] bool inRange(const Node& node) const;
  [[nodiscard]] std::optional<int> wholeNumber(const Node& node, const char* expected) const;

  /// Limit on numbers without a declared range. A float can hold it.
  static constexpr double maxMagnitude = 1e30;

  const char* name_;
  Range range_;
  const char* unit_;
  Diagnostics& diagnostics_;
};

/// Returns the range in words: "between 0 and 1 m", "at least 0 s", "greater than 0", "at most 3". Returns
/// an empty string for an unlimited range. Leaves out bounds beyond 1e9, because they only keep the
/// arithmetic finite.
[[nodiscard]] std::string rangeText(Range range, const char* unit);

}  // namespace simreel::scene
