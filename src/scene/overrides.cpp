#include "scene/overrides.hpp"

#include <charconv>
#include <optional>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

std::optional<std::size_t> listIndex(const std::string& step) {
  std::size_t index = 0;
  const auto [end, code] = std::from_chars(step.data(), step.data() + step.size(), index);
  if (code != std::errc() || end != step.data() + step.size()) return std::nullopt;
  return index;
}

/// Moves a parsed value's places behind "path=".
void shift(Node& node, std::size_t by) {
  node.place.begin += by;
  node.place.end += by;
  for (Place& place : node.keyPlaces) {
    place.begin += by;
    place.end += by;
  }
  for (Node& item : node.items) shift(item, by);
}

Node parseValue(const Override& override_, std::size_t source) {
  Node node;
  JsonError error;
  if (!parseJson(override_.value, source, node, error)) {
    node = {};
    node.kind = Node::Kind::text;
    node.text = override_.value;
    node.place = {source, 0, override_.value.size()};
  }
  shift(node, override_.path.size() + 1);
  return node;
}

/// The member or item `step` of `node`, made if an object lacks it; null when there cannot be one.
Node* descend(Node& node, const std::string& step, Place place) {
  if (node.kind == Node::Kind::list) {
    const auto index = listIndex(step);
    return index && *index < node.items.size() ? &node.items[*index] : nullptr;
  }
  if (node.kind != Node::Kind::object) return nullptr;
  if (Node* found = node.find(step)) return found;
  node.keys.push_back(step);
  node.keyPlaces.push_back(place);
  Node& made = node.items.emplace_back();
  made.kind = Node::Kind::object;
  made.place = place;
  return &made;
}

}  // namespace

std::string overrideText(const Override& override_) {
  return override_.path + "=" + override_.value;
}

void applyOverrides(Node& root, std::span<const Override> overrides, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < overrides.size(); ++i) {
    const std::string& path = overrides[i].path;
    Node* node = &root;
    std::size_t begin = 0;
    while (node != nullptr && begin <= path.size()) {
      const std::size_t dot = std::min(path.find('.', begin), path.size());
      const Place place{i + 1, begin, dot};
      const std::string step = path.substr(begin, dot - begin);
      Node* next = step.empty() ? nullptr : descend(*node, step, place);
      if (next == nullptr)
        diagnostics.error(place, step.empty() ? std::string("the path has an empty part")
                                              : fmt::format("there is no \"{}\" in {}", step,
                                                            node->kind == Node::Kind::list
                                                                ? fmt::format("a list of {} items", node->items.size())
                                                                : kindName(node->kind)));
      node = next;
      begin = dot + 1;
    }
    if (node != nullptr) *node = parseValue(overrides[i], i + 1);
  }
}

}  // namespace simreel::scene
