#include "scene/as_run.hpp"

#include "base/error.hpp"
#include "base/hash.hpp"
#include "scene/json/json_node.hpp"
#include "scene/override.hpp"
#include "scene/scene_source.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel::scene {

namespace {

/// Top-level members of a scene that the simulation does not depend on. A camera with damping is an
/// exception, because its lag is part of the simulation's state.
constexpr std::array<std::string_view, 10> drawingMembers = {
    "$schema", "title", "render", "camera", "panels", "sun", "sky", "lights", "test", "checks"};

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Returns the shortest text that reads back as the same number.
std::string numberText(double value) {
  if (value == 0 && std::signbit(value)) return "-0.0";  // "-0" reads back as the whole number 0
  // Whole numbers below 2^53 are written without a fraction.
  constexpr double exact = 9007199254740992.0;
  if (value == std::floor(value) && std::abs(value) < exact)
    return fmt::format("{}", static_cast<long long>(value));
  return fmt::format("{}", value);
}

bool isSimple(const Node& node) {
  return node.kind != Node::Kind::list && node.kind != Node::Kind::object;
}

void write(const Node& node, const std::string& indent, std::string& text) {
  switch (node.kind) {
    case Node::Kind::null:
      text += "null";
      return;
    case Node::Kind::boolean:
      text += node.boolean ? "true" : "false";
      return;
    case Node::Kind::number:
      text += numberText(node.number);
      return;
    case Node::Kind::text:
      text += quoted(node.text);
      return;
    case Node::Kind::list:
    case Node::Kind::object:
      break;
  }
  const bool isList = node.kind == Node::Kind::list;
  // A list is written on one line if its items are simple values or lists of simple values.
  const bool oneLine = std::all_of(node.children.begin(), node.children.end(), [&](const Node& child) {
    return isSimple(child) || (isList && child.kind == Node::Kind::list &&
                               std::all_of(child.children.begin(), child.children.end(), isSimple));
  });
  const std::string inner = indent + "  ";
  text += isList ? "[" : "{";
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    if (i > 0) text += oneLine ? ", " : ",";
    if (!oneLine) text += "\n" + inner;
    if (!isList) text += quoted(node.children[i].key) + ": ";
    write(node.children[i], inner, text);
  }
  if (!oneLine) text += "\n" + indent;
  text += isList ? "]" : "}";
}

void remove(Node& object, std::string_view key) {
  std::erase_if(object.children, [&](const Node& child) { return child.key == key; });
}

bool isDamped(const Node& group) {
  const Node* damping = group.kind == Node::Kind::object ? group.find("damping") : nullptr;
  return damping != nullptr && !(damping->kind == Node::Kind::number && damping->number == 0);
}

/// Reduces the scene's camera to the members that determine its lag, which is carried from frame to frame:
/// a damped "target", "track" or "follow". Removes a camera without damping.
void keepOnlyLag(Node& root) {
  Node* camera = root.find("camera");
  if (camera == nullptr) return;
  if (camera->kind == Node::Kind::object && isDamped(*camera)) {
    std::erase_if(camera->children,
                  [](const Node& child) { return child.key != "damping" && child.key != "target"; });
    return;
  }
  for (const char* name : {"track", "follow"}) {
    Node* group = camera->kind == Node::Kind::object ? camera->find(name) : nullptr;
    if (group == nullptr || !isDamped(*group)) continue;
    std::erase_if(camera->children, [&](const Node& child) { return child.key != name; });
    remove(camera->children.front(), "offset");
    return;
  }
  remove(root, "camera");
}

}  // namespace

std::string sceneAsRun(const std::filesystem::path& file, std::span<const Override> overrides,
                       const Kinds& kinds) {
  const auto [text, name] = readSceneSource(file, kinds);
  return textAsRun(text, name, overrides);
}

std::string textAsRun(std::string_view text, const std::filesystem::path& name,
                      std::span<const Override> overrides) {
  Diagnostics diagnostics(name.string(), text);
  std::string result;
  if (std::optional<Node> root = parseJson(text, 0, 0, diagnostics)) {
    for (const Override& change : overrides) applyOverride(*root, change, diagnostics);
    write(*root, "", result);
  }
  if (!diagnostics.empty()) throw UserError(ExitCode::usage, diagnostics.report(), UserError::Form::report);
  return result + "\n";
}

std::string simulationHash(std::string_view asRun) {
  Diagnostics diagnostics("scene", asRun);
  std::optional<Node> root = parseJson(asRun, 0, 0, diagnostics);
  if (!root) fail(ExitCode::usage, "the scene as run is no JSON");
  for (const std::string_view key : drawingMembers)
    if (key != "camera") remove(*root, key);
  keepOnlyLag(*root);
  if (Node* time = root->find("time")) {
    remove(*time, "duration");
    if (time->children.empty()) remove(*root, "time");
  }
  if (Node* objects = root->find("objects"))
    for (Node& object : objects->children) remove(object, "material");
  std::string text;
  write(*root, "", text);
  return hashHex(text);
}

bool touchesSimulation(std::string_view path) {
  if (path == "time.duration") return false;
  // Changes at these paths can add, remove or change the lag of a damped camera.
  for (const std::string_view whole : {"camera", "camera.track", "camera.track.object",
                                       "camera.track.damping", "camera.follow", "camera.damping"})
    if (path == whole) return true;
  if (path.starts_with("camera.follow.")) return true;
  const std::string_view first = path.substr(0, path.find('.'));
  if (std::find(drawingMembers.begin(), drawingMembers.end(), first) != drawingMembers.end()) return false;
  if (first != "objects") return true;
  const std::size_t name = path.find('.', first.size() + 1);
  if (name == std::string_view::npos) return true;
  const std::string_view member = path.substr(name + 1);
  return member != "material" && !member.starts_with("material.");
}

}  // namespace simreel::scene
