#include "scene/json/scene_error.hpp"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

/// Finds the innermost node that contains a place. A node of an override lies within nodes of other
/// sources.
bool find(const Node& node, Place place, std::string& path) {
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const Node& child = node.children[i];
    const std::string step = node.kind == Node::Kind::list ? std::to_string(i) : child.key;
    std::string inner = path.empty() ? step : fmt::format("{}.{}", path, step);
    if (find(child, place, inner)) {
      path = inner;
      return true;
    }
  }
  const std::size_t begin = node.keyEnd > node.keyBegin ? std::min(node.keyBegin, node.begin) : node.begin;
  return node.source == place.source && begin <= place.begin && place.begin < node.end;
}

}  // namespace

std::string pathAt(const Node& root, Place place) {
  std::string path;
  return find(root, place, path) ? path : std::string();
}

SceneError::SceneError(const Diagnostics& diagnostics, const Node* root)
    : UserError(ExitCode::usage, diagnostics.report(), Form::report),
      problems_(diagnostics.problems(
          [&](Place place) { return root == nullptr ? std::string() : pathAt(*root, place); })) {}

}  // namespace simreel::scene
