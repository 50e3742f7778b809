#include "scene/json/member_line.hpp"

#include "scene/json/diagnostics.hpp"
#include "scene/json/json_node.hpp"

#include <algorithm>
#include <cstddef>

namespace simreel::scene {

std::optional<int> memberLine(std::string_view text, std::span<const std::string> path) {
  Diagnostics ignored("", text);
  const std::optional<Node> root = parseJson(text, 0, 0, ignored);
  const Node* node = root ? &*root : nullptr;
  for (const std::string& step : path) {
    if (node == nullptr) break;
    if (node->kind == Node::Kind::list) {
      const auto item = std::find_if(node->children.begin(), node->children.end(), [&](const Node& child) {
        return std::to_string(&child - node->children.data()) == step;
      });
      node = item == node->children.end() ? nullptr : &*item;
    } else {
      node = node->find(step);
    }
  }
  if (node == nullptr) return std::nullopt;
  const std::string_view before = text.substr(0, node->headPlace().begin);
  return 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
}

}  // namespace simreel::scene
