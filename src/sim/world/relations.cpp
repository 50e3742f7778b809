#include "sim/world/relations.hpp"

#include "scene/words.hpp"
#include "sim/core/kind.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

const ObjectParameters* parametersAt(const scene::Object& object) {
  return dynamic_cast<const ObjectParameters*>(object.parameters.get());
}

void checkSkin(const scene::Object& object, std::span<const scene::Object> objects,
               const scene::Report& report) {
  if (!object.material.hasSkin) return;
  std::vector<std::string> fields;
  for (const scene::Object& candidate : objects)
    if (const auto* parameters = parametersAt(candidate); parameters != nullptr && parameters->isField())
      fields.push_back(candidate.name);
  const std::string& name = object.material.skin.field;
  if (std::find(fields.begin(), fields.end(), name) != fields.end()) return;
  const auto named =
      std::find_if(objects.begin(), objects.end(), [&](const auto& other) { return other.name == name; });
  if (named != objects.end() && named->parameters == nullptr) return;  // a mistake of its own
  const std::string what = name.empty() ? "the skin has no \"field\""
                           : named == objects.end()
                               ? fmt::format("no object is named {}", scene::inQuotes(name))
                               : fmt::format("object \"{}\" is a {}, not a field", name, named->kind);
  report(object, {"material", "skin", "field"},
         fmt::format("{}; {}", what,
                     fields.empty() ? "the scene has no field" : scene::suggestion(name, fields)));
}

/// One surface of heights for those that ask for it.
void checkHeights(std::span<const scene::Object> objects, const scene::Report& report) {
  const scene::Object* surface = nullptr;
  for (const scene::Object& object : objects) {
    const auto* parameters = parametersAt(object);
    if (parameters == nullptr || !parameters->publishesHeights()) continue;
    if (surface != nullptr)
      report(object, {object.kind, "collides"},
             fmt::format("a scene has one mesh that collides, and \"{}\" is one already", surface->name));
    else
      surface = &object;
  }
  for (const scene::Object& object : objects) {
    const auto* parameters = parametersAt(object);
    if (surface == nullptr && parameters != nullptr && parameters->needsHeights())
      report(object, {object.kind, "collides"},
             "there is nothing to fall onto; give a \"mesh\" of this scene \"collides\": true");
  }
}

}  // namespace

void checkRelations(std::span<const scene::Object> objects, const scene::Report& report) {
  for (const scene::Object& object : objects) checkSkin(object, objects, report);
  checkHeights(objects, report);
}

}  // namespace simreel::sim
