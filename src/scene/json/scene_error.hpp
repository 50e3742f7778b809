#pragma once
#include "base/error.hpp"
#include "scene/json/json_node.hpp"

#include <string>
#include <vector>

namespace simreel::scene {

/// Returns the dotted path of the innermost value whose key or text contains a place:
/// "objects.flag.cloth.size". Items of lists are numbered from 0. Empty if no member contains it.
[[nodiscard]] std::string pathAt(const Node& root, Place place);

/// All errors of a scene text. The message lists them for people, and a list holds them for programs.
class SceneError : public UserError {
 public:
  /// `root`: the scene, from which paths are computed; null if the text has no values.
  SceneError(const Diagnostics& diagnostics, const Node* root);
  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

}  // namespace simreel::scene
