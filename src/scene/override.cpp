#include "scene/override.hpp"

#include "base/error.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel::scene {

namespace {

/// Parses the value as JSON, or uses it as a bare string. A value that begins like a list, object or string
/// must be valid JSON, so that `[1,2` is an error.
std::optional<Node> parseValue(const std::string& value, int source, std::size_t base,
                               Diagnostics& diagnostics) {
  const std::size_t first = value.find_first_not_of(' ');
  const bool opensJson =
      first != std::string::npos && std::string_view("[{\"").find(value[first]) != std::string::npos;
  if (opensJson || nlohmann::json::accept(value)) return parseJson(value, source, base, diagnostics);
  Node node;
  node.kind = Node::Kind::text;
  node.source = source;
  node.text = value;
  node.begin = static_cast<std::uint32_t>(base);
  node.end = static_cast<std::uint32_t>(base + value.size());
  return node;
}

Node* listItem(Node& list, std::string_view segment, Place place, Diagnostics& diagnostics) {
  std::size_t index = 0;
  const auto [rest, error] = std::from_chars(segment.data(), segment.data() + segment.size(), index);
  if (error != std::errc() || rest != segment.data() + segment.size()) {
    diagnostics.add(place,
                    fmt::format("{} is not an index; this part of the scene is a list", inQuotes(segment)));
    return nullptr;
  }
  if (index >= list.children.size()) {
    diagnostics.add(
        place, fmt::format("no item {}; the list has {}, counted from 0", index, list.children.size()));
    return nullptr;
  }
  return &list.children[index];
}

/// Reports an error and returns true if an override of a single member would create a missing object, light
/// or list item around it.
bool addsSilently(const Node& object, const std::string& path, std::size_t begin, std::size_t end,
                  int source, Diagnostics& diagnostics) {
  const std::string_view segment = std::string_view(path).substr(begin, end - begin);
  if (end == path.size()) return false;  // The override gives the whole member.
  const std::string_view next = std::string_view(path).substr(end + 1, path.find('.', end + 1) - end - 1);
  for (const auto& [prefix, one] : {std::pair("objects.", "object"), {"lights.", "light"}}) {
    if (!path.starts_with(prefix) || begin > std::string_view(prefix).size()) continue;
    if (begin == 0 && end + 1 + next.size() == path.size()) return false;
    std::vector<std::string> names;
    if (begin > 0)
      for (const Node& child : object.children) names.push_back(child.key);
    const std::string_view name = begin > 0 ? segment : next;
    const std::size_t at = static_cast<std::size_t>(name.data() - path.data());
    diagnostics.add(
        {source, at, at + name.size()},
        fmt::format("no {} is named {}; {} (-D {}{}={{...}} adds one)", one, inQuotes(name),
                    names.empty() ? "the scene has none" : suggestion(name, names), prefix, name));
    return true;
  }
  if (next.empty() || next.find_first_not_of("0123456789") != std::string_view::npos) return false;
  diagnostics.add({source, begin, end},
                  fmt::format("{} is not given, so it has no item {}; give all of it: -D {}=[...]",
                              inQuotes(segment), next, path.substr(0, end)));
  return true;
}

Node* member(Node& object, std::string_view segment, Place place) {
  if (Node* found = object.find(segment)) return found;
  Node& made = object.children.emplace_back();
  made.kind = Node::Kind::object;
  made.source = place.source;
  made.key = segment;
  made.begin = made.keyBegin = static_cast<std::uint32_t>(place.begin);
  made.end = made.keyEnd = static_cast<std::uint32_t>(place.end);
  return &made;
}

/// True if the path has the form a.b.c. Otherwise reports an error. Must be called before nodes are
/// created.
bool checkPath(const std::string& path, int source, Diagnostics& diagnostics) {
  std::size_t depth = 0;
  for (std::size_t begin = 0; begin <= path.size(); ++depth) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    if (begin == end || depth >= maxDepth) {
      diagnostics.add({source, begin, end},
                      begin == end ? "a name is missing in this path" : "this path is too deep");
      return false;
    }
    begin = end + 1;
  }
  return true;
}

/// Returns the node that `path` names, or null after an error. Creates missing members.
Node* walk(Node& scene, const std::string& path, int source, Diagnostics& diagnostics) {
  Node* node = &scene;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string_view segment = std::string_view(path).substr(begin, end - begin);
    const Place place{source, begin, end};
    if (node->kind == Node::Kind::list) {
      node = listItem(*node, segment, place, diagnostics);
      if (node == nullptr) return nullptr;
    } else if (node->kind == Node::Kind::object) {
      if (node->find(segment) == nullptr && addsSilently(*node, path, begin, end, source, diagnostics))
        return nullptr;
      node = member(*node, segment, place);
    } else {
      diagnostics.add(place, fmt::format("{} is {}, which holds nothing named {}",
                                         begin == 0 ? "the scene" : inQuotes(path.substr(0, begin - 1)),
                                         node->kindText(), inQuotes(segment)));
      return nullptr;
    }
    begin = end + 1;
  }
  return node;
}

}  // namespace

void applyOverride(Node& scene, const Override& change, Diagnostics& diagnostics) {
  const int source = diagnostics.addOverride(change.path + "=" + change.value);
  const std::size_t valueAt = change.path.size() + 1;
  if (!isUtf8(change.path) || !isUtf8(change.value)) {
    diagnostics.add({source, 0, 1}, "not valid UTF-8");
    return;
  }
  std::optional<Node> value = parseValue(change.value, source, valueAt, diagnostics);
  if (!value || !checkPath(change.path, source, diagnostics)) return;
  Node* place = walk(scene, change.path, source, diagnostics);
  if (place == nullptr) return;
  const std::size_t dot = change.path.rfind('.');
  if (value->kind == Node::Kind::null) {
    Node* parent =
        dot == std::string::npos ? &scene : walk(scene, change.path.substr(0, dot), source, diagnostics);
    const std::string key = place->key;
    if (parent->kind == Node::Kind::object)
      std::erase_if(parent->children, [&](const Node& child) { return child.key == key; });
    return;
  }
  value->key = place->key;
  // Errors about the key, such as an unknown name, also refer to the text of the -D option.
  value->keyBegin = static_cast<std::uint32_t>(dot == std::string::npos ? 0 : dot + 1);
  value->keyEnd = static_cast<std::uint32_t>(change.path.size());
  *place = std::move(*value);
}

std::string asArguments(std::span<const std::string> overrides) {
  std::string words;
  for (const std::string& change : overrides)
    words += (words.empty() ? "-D " : " -D ") + inShellQuotes(change);
  return words;
}

Override parseOverride(std::string_view argument) {
  const std::size_t equals = argument.find('=');
  if (equals == std::string_view::npos || equals == 0)
    fail(ExitCode::usage, "-D {}: expected path=value, for example -D time.fps=30", argument);
  return {std::string(argument.substr(0, equals)), std::string(argument.substr(equals + 1))};
}

}  // namespace simreel::scene
