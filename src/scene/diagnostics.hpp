#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/json_node.hpp"

namespace simreel::scene {

/// Mistakes of one scene file and its overrides, reported all at once.
class Diagnostics {
 public:
  /// `overrides` are the texts of -D, "path=value".
  Diagnostics(std::string name, std::string_view text, std::vector<std::string> overrides)
      : name_(std::move(name)), sources_({std::string(text)}) {
    sources_.insert(sources_.end(), overrides.begin(), overrides.end());
  }

  void error(Place place, std::string message) { errors_.push_back({place, std::move(message)}); }
  [[nodiscard]] bool empty() const { return errors_.empty(); }
  /// Sorted by place, each "file:line:column: error: message", the line and a caret; at most 50, then a count.
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] std::string one(const JsonError& error) const;

  std::string name_;
  std::vector<std::string> sources_;
  std::vector<JsonError> errors_;
};

/// The name nearest to `wrong`, or empty when none is near.
[[nodiscard]] std::string nearest(std::string_view wrong, const std::vector<std::string>& names);
/// "did you mean "x"?" or "known: a, b, c".
[[nodiscard]] std::string suggestion(std::string_view wrong, const std::vector<std::string>& names);

}  // namespace simreel::scene
