#include "serve/script/changes.hpp"

#include "scene/as_run.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

namespace simreel::serve {

namespace {

using nlohmann::ordered_json;

constexpr double always = std::numeric_limits<double>::infinity();
constexpr double never = -always;

/// Parameters of each kind of object that affect only its appearance.
constexpr std::array<std::pair<std::string_view, std::string_view>, 21> showing = {{
    {"life", "display"},     {"lenia", "display"},   {"grayScott", "display"}, {"reaction", "display"},
    {"epidemic", "display"}, {"epidemic", "colors"}, {"wildfire", "display"},  {"wildfire", "colors"},
    {"fluid", "display"},    {"fluid", "look"},      {"fluid", "brightness"},  {"fluid", "paper"},
    {"water", "display"},    {"water", "look"},      {"water", "visible"},     {"particles", "look"},
    {"sphere", "visible"},   {"capsule", "visible"}, {"plane", "visible"},     {"mesh", "visible"},
    {"cave", "display"},
}};

/// Parameters whose keyframes affect the state only at their own time. For other parameters, the maximum
/// over all keys sets the number of substeps at all times.
constexpr std::array<std::pair<std::string_view, std::string_view>, 20> timed = {{
    {"cloth", "pins"},          {"grayScott", "feed"},
    {"grayScott", "kill"},      {"epidemic", "beta"},
    {"epidemic", "gamma"},      {"epidemic", "waning"},
    {"wildfire", "moisture"},   {"wildfire", "spread"},
    {"wildfire", "wind"},       {"sphere", "position"},
    {"sphere", "rotation"},     {"capsule", "position"},
    {"capsule", "rotation"},    {"plane", "position"},
    {"plane", "rotation"},      {"particles", "acceleration"},
    {"particles", "attractor"}, {"reaction", "parameters"},
    {"water", "rainfall"},      {"water", "drag"},
}};

template <std::size_t size>
bool has(const std::array<std::pair<std::string_view, std::string_view>, size>& list, std::string_view kind,
         std::string_view member) {
  return std::find(list.begin(), list.end(), std::pair(kind, member)) != list.end();
}

/// Returns the time up to which two keyframed values are equal. A value between two keys depends on both
/// keys and, with a spline, on the keys before and after them. Before the first key, the first key's value
/// applies.
double keysAlike(const ordered_json& before, const ordered_json& after) {
  const ordered_json &a = before.at("keys"), &b = after.at("keys");
  if (!a.is_array() || !b.is_array()) return never;
  for (const auto& member : before.items())
    if (member.key() != "keys" &&
        (!after.contains(member.key()) || after.at(member.key()) != member.value()))
      return never;
  if (before.size() != after.size()) return never;
  std::size_t same = 0;
  while (same < a.size() && same < b.size() && a.at(same) == b.at(same)) ++same;
  if (same == a.size() && same == b.size()) return always;
  const bool spline = before.value("ease", "") == "spline";
  const std::size_t needed = spline ? 2 : 1;
  if (same < needed) return never;
  const ordered_json& last = a.at(same - needed);
  return last.is_array() && !last.empty() && last.front().is_number() ? last.front().get<double>() : never;
}

double strokesAlike(const ordered_json& before, const ordered_json& after) {
  if (!before.is_array() || !after.is_array()) return never;
  const auto begins = [](const ordered_json& stroke) {
    if (!stroke.is_object()) return never;
    const auto at = stroke.find("at");
    return at == stroke.end() ? 0.0 : at->is_number() ? at->get<double>() : never;
  };
  double alike = always;
  // The index of a stroke in the list seeds its random numbers, so strokes are compared by index.
  for (std::size_t i = 0; i < std::max(before.size(), after.size()); ++i) {
    if (i < before.size() && i < after.size() && before.at(i) == after.at(i)) continue;
    for (const ordered_json* list : {&before, &after})
      if (i < list->size()) alike = std::min(alike, begins(list->at(i)));
  }
  return alike;
}

/// Returns two flags: true if a fluid's strokes set dye, and true if they set temperature.
std::array<bool, 2> carried(const ordered_json& fluid) {
  std::array<bool, 2> all{};
  const ordered_json strokes = fluid.value("strokes", ordered_json::array());
  if (!strokes.is_array()) return all;
  for (const ordered_json& stroke : strokes)
    if (stroke.is_object()) {
      all[0] = all[0] || stroke.contains("dye");
      all[1] = all[1] || stroke.contains("temperature");
    }
  return all;
}

double valuesAlike(const ordered_json& before, const ordered_json& after) {
  if (before == after) return always;
  double alike = always;
  if (before.is_array() && after.is_array() && before.size() == after.size()) {
    for (std::size_t i = 0; i < before.size(); ++i)
      alike = std::min(alike, valuesAlike(before.at(i), after.at(i)));
    return before.empty() ? never : alike;
  }
  if (!before.is_object() || !after.is_object() || before.size() != after.size()) return never;
  if (before.contains("keys") && after.contains("keys")) return keysAlike(before, after);
  for (const auto& member : before.items()) {
    if (!after.contains(member.key())) return never;
    alike = std::min(alike, valuesAlike(member.value(), after.at(member.key())));
  }
  return alike;
}

double objectsAlike(const ordered_json& before, const ordered_json& after) {
  double alike = always;
  for (const auto& member : before.items())
    if (!after.contains(member.key())) return never;
  for (const auto& member : after.items()) {
    const std::string& kind = member.key();
    if (!before.contains(kind)) return never;
    const ordered_json &a = before.at(kind), &b = member.value();
    if (a == b) continue;
    if (!a.is_object() || !b.is_object()) return never;
    std::size_t both = 0;
    for (const auto& one : b.items()) both += a.contains(one.key()) ? 1 : 0;
    const auto strokes = [](const ordered_json& of) { return of.value("strokes", ordered_json::array()); };
    const std::size_t strokesOfOne = a.contains("strokes") != b.contains("strokes") ? 1 : 0;
    if (a.size() + b.size() - 2 * both != strokesOfOne) return never;
    // A fluid without strokes has default jets. It has arrays for dye and temperature only if its strokes
    // set them.
    if (kind == "fluid" && (strokesOfOne > 0 || carried(a) != carried(b))) return never;
    alike = std::min(alike, strokesAlike(strokes(a), strokes(b)));
    for (const auto& one : b.items()) {
      if (one.key() == "strokes" || one.value() == a.at(one.key())) continue;
      if (!has(timed, kind, one.key())) return never;
      alike = std::min(alike, valuesAlike(a.at(one.key()), one.value()));
    }
  }
  return alike;
}

}  // namespace

std::string withoutAppearance(std::string_view asRun) {
  ordered_json scene = ordered_json::parse(asRun);
  if (const auto ground = scene.find("ground"); ground != scene.end() && ground->is_object())
    for (const char* member : {"visible", "color", "roughness", "fadeStart", "fadeEnd"})
      ground->erase(member);
  const auto objects = scene.find("objects");
  if (objects != scene.end() && objects->is_object())
    for (const auto& object : objects->items())
      if (object.value().is_object())
        for (const auto& kind : object.value().items())
          if (kind.value().is_object()) {
            if (kind.key() == "text") kind.value().clear();
            for (const auto& [of, member] : showing)
              if (kind.key() == of) kind.value().erase(std::string(member));
          }
  return scene.dump();
}

double equalUntil(std::string_view before, std::string_view after) {
  if (scene::simulationHash(before) == scene::simulationHash(after)) return always;
  ordered_json a = ordered_json::parse(withoutAppearance(before));
  ordered_json b = ordered_json::parse(withoutAppearance(after));
  const ordered_json none = ordered_json::object();
  const ordered_json objectsBefore = a.value("objects", none), objectsAfter = b.value("objects", none);
  if (!objectsBefore.is_object() || !objectsAfter.is_object()) return never;
  for (ordered_json* one : {&a, &b}) one->erase("objects");
  if (scene::simulationHash(a.dump()) != scene::simulationHash(b.dump())) return never;
  // Objects are simulated in their order, so the order must be equal.
  if (objectsBefore.size() != objectsAfter.size()) return never;
  double alike = always;
  for (auto one = objectsBefore.begin(), other = objectsAfter.begin(); one != objectsBefore.end();
       ++one, ++other) {
    if (one.key() != other.key()) return never;
    ordered_json objectBefore = one.value(), objectAfter = other.value();
    if (objectBefore == objectAfter) continue;
    if (!objectBefore.is_object() || !objectAfter.is_object()) return never;
    for (ordered_json* object : {&objectBefore, &objectAfter}) object->erase("material");
    alike = std::min(alike, objectsAlike(objectBefore, objectAfter));
  }
  return alike;
}

}  // namespace simreel::serve
