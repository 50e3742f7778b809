#include "golden/suite/blame.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "scene/json/json_node.hpp"
#include "scene/json/member_line.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace simreel::golden {

namespace {

/// Parses the file and line in a text such as "FILE:12:5: error: ...", which is the format of the scene
/// reader's messages.
std::optional<Place> placeIn(std::string_view message) {
  const std::size_t end = message.find(": error: ");
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view place = message.substr(0, end);
  const std::size_t column = place.rfind(':');
  const std::size_t line = column == 0 ? column : place.rfind(':', column - 1);
  if (column == std::string_view::npos || line == std::string_view::npos || line == 0) return std::nullopt;
  Place found{std::string(place.substr(0, line)), 0};
  std::from_chars(place.data() + line + 1, place.data() + column, found.line);
  if (found.line < 1) return std::nullopt;
  return found;
}

/// Returns a file's text, or an empty text if it can no longer be read.
std::string textOf(const std::filesystem::path& file) {
  try {
    return pathExists(file) ? readFile(file, "scene", scene::maxSceneBytes) : std::string();
  } catch (const UserError&) {
    return {};
  }
}

/// Returns the line of the failing check in the list of checks in the text.
std::optional<int> lineOfCheck(const std::string& text, const CheckResult& check) {
  scene::Diagnostics ignored("", text);
  const auto root = scene::parseJson(text, 0, 0, ignored);
  const scene::Node* checks = root ? root->find("checks") : nullptr;
  if (checks == nullptr) return std::nullopt;
  const auto says = [](const scene::Node& node, const char* key) {
    const scene::Node* found = node.find(key);
    return found == nullptr ? std::string() : found->text;
  };
  // check.what has the form "energy of flag", with the words of the check (suite/check.cpp).
  for (std::size_t i = 0; i < checks->children.size(); ++i) {
    const scene::Node& one = checks->children[i];
    const std::string what = says(one, "what"), object = says(one, "object"), of = says(one, "of");
    const auto rest = std::string_view(check.what).substr(std::min(what.size(), check.what.size()));
    if (!what.empty() && check.what.starts_with(what) && (rest.empty() || rest.front() == ' ') &&
        (object.empty() || rest.find(object) != std::string_view::npos) &&
        (of.empty() || rest.ends_with(of))) {
      const std::vector<std::string> path = {"checks", std::to_string(i)};
      return scene::memberLine(text, path);
    }
  }
  return std::nullopt;
}

/// Returns the object's name, for example "flag" for "triangle 12 of flag".
std::string objectOf(const std::string& shows) {
  const std::size_t of = shows.rfind(" of ");
  return of == std::string::npos ? shows : shows.substr(of + 4);
}

}  // namespace

Place blameOf(const SceneResult& scene) {
  for (const std::string& message : scene.messages)
    if (const auto place = placeIn(message)) return *place;
  const std::string sidecar = scene::sidecarOf(scene.file).generic_string();
  const std::string text = textOf(scene.file), beside = textOf(sidecar);
  for (const CheckResult& check : scene.checks) {
    if (check.passed) continue;
    if (const auto line = lineOfCheck(beside, check)) return {sidecar, *line};
    if (const auto line = lineOfCheck(text, check)) return {scene.file, *line};
  }
  std::string object = scene.divergence ? scene.divergence->object : "";
  for (const FrameResult& frame : scene.frames)
    if (object.empty() && frame.pass) object = objectOf(frame.pass->shows);
  if (!object.empty()) {
    const std::vector<std::string> path = {"objects", object};
    if (const auto line = scene::memberLine(text, path)) return {scene.file, *line};
  }
  const std::vector<std::string> test = {"test"};
  if (const auto line = scene::memberLine(beside, test)) return {sidecar, *line};
  return {scene.file, scene::memberLine(text, test).value_or(1)};
}

}  // namespace simreel::golden
