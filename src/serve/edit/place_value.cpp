#include "serve/edit/place_value.hpp"

#include "base/error.hpp"
#include "scene/json/json_node.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

namespace simreel::serve {

namespace {

using scene::Node;

std::vector<std::string> segmentsOf(const std::string& path) {
  std::vector<std::string> segments;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    segments.push_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return segments;
}

/// Returns the list item with the index `segment`, or the object's member with the name `segment`. Returns
/// null if it does not exist.
const Node* childOf(const Node& node, const std::string& segment) {
  if (node.kind != Node::Kind::list) return node.find(segment);
  std::size_t index = 0;
  const auto [rest, error] = std::from_chars(segment.data(), segment.data() + segment.size(), index);
  if (error != std::errc() || rest != segment.data() + segment.size() || index >= node.children.size())
    return nullptr;
  return &node.children[index];
}

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Returns the value as JSON; text that is not JSON becomes a string.
std::string valueText(const std::string& value) {
  return nlohmann::json::accept(value) ? value : quoted(value);
}

/// Returns the blanks between the start of the line and byte `at`. Returns nullopt if other characters
/// precede the byte, or on the first line.
std::optional<std::string> indentAt(std::string_view text, std::size_t at) {
  const std::size_t lineEnd = text.rfind('\n', at == 0 ? 0 : at - 1);
  const std::size_t begin = lineEnd == std::string_view::npos ? 0 : lineEnd + 1;
  const std::string_view indent = text.substr(begin, at - begin);
  if (lineEnd == std::string_view::npos || indent.find_first_not_of(" \t") != std::string_view::npos)
    return std::nullopt;
  return std::string(indent);
}

/// Returns the end of the line if only blanks and comments follow byte `from`. Otherwise returns `from`.
std::size_t endOfRemark(std::string_view text, std::size_t from) {
  std::size_t at = from;
  while (at < text.size()) {
    if (text[at] == ' ' || text[at] == '\t' || text[at] == '\r') {
      ++at;
    } else if (text.substr(at, 2) == "//") {
      at = std::min(text.find('\n', at), text.size());
    } else if (text.substr(at, 2) == "/*") {
      const std::size_t close = text.find("*/", at + 2);
      if (close == std::string_view::npos ||
          text.substr(at, close - at).find('\n') != std::string_view::npos)
        return from;
      at = close + 2;
    } else {
      break;
    }
  }
  return at < text.size() && text[at] == '\n' ? (text[at - 1] == '\r' ? at - 1 : at) : from;
}

/// Inserts a member after the last one of an object, or an item after the last one of a list.
std::string withMember(std::string_view text, const Node& object, const std::string& member) {
  std::string result(text);
  if (object.children.empty()) {
    const std::size_t inside = object.begin + 1;
    result.insert(inside, member);
    return result;
  }
  const Node& last = object.children.back();
  if (const auto indent = indentAt(text, object.kind == Node::Kind::list ? last.begin : last.keyBegin)) {
    const std::size_t end = endOfRemark(text, last.end);
    result.insert(end, "\n" + *indent + member);
    result.insert(last.end, ",");
  } else {
    result.insert(last.end, ", " + member);
  }
  return result;
}

}  // namespace

std::string withValue(std::string_view text, const scene::Override& change) {
  scene::Diagnostics diagnostics("scene", text);
  const std::optional<Node> root = scene::parseJson(text, 0, 0, diagnostics);
  if (!root) throw UserError(ExitCode::usage, diagnostics.report(), UserError::Form::report);
  const std::vector<std::string> segments = segmentsOf(change.path);
  const Node* node = &*root;
  std::size_t known = 0;
  for (; known < segments.size(); ++known) {
    const Node* next = childOf(*node, segments[known]);
    if (next == nullptr) break;
    node = next;
  }
  const std::string value = valueText(change.value);
  if (known == segments.size()) {
    std::string result(text);
    result.replace(node->begin, node->end - node->begin, value);
    return result;
  }
  if (node->kind == Node::Kind::list && known + 1 == segments.size() &&
      segments[known] == std::to_string(node->children.size()))
    return withMember(text, *node, value);
  if (node->kind != Node::Kind::object)
    fail(ExitCode::usage, "{} cannot be written into the scene: \"{}\" is not there", change.path,
         segments[known]);
  std::string member = value;
  for (std::size_t i = segments.size(); i-- > known;)
    member = (i + 1 == segments.size() ? quoted(segments[i]) + ": " + member
                                       : quoted(segments[i]) + ": {" + member + "}");
  return withMember(text, *node, member);
}

}  // namespace simreel::serve
