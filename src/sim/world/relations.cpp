#include "sim/world/relations.hpp"

#include "scene/json/words.hpp"
#include "sim/core/field_reader.hpp"
#include "sim/core/kind.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::sim {

namespace {

const ObjectParameters* parametersAt(const scene::Object& object) {
  return dynamic_cast<const ObjectParameters*>(object.parameters.get());
}

/// What an object is that offers no field to all.
std::string noFieldOf(const ObjectParameters* parameters) {
  const auto* parts = dynamic_cast<const FieldParts*>(parameters);
  const std::string takenBy = parts == nullptr ? std::string() : parts->takenBy();
  return takenBy.empty() ? ", not a field" : takenBy;
}

/// What a name of a field leads to: nothing where there is one, else what is wrong with it.
/// `parts`: fields of parts count, too, as NAME.u.
std::string fieldMistake(const std::string& name, const char* unnamed, bool parts,
                         std::span<const scene::Object> objects, const FieldReading* reading = nullptr) {
  const auto offers = [&](const ObjectParameters* parameters) {
    const auto* more = dynamic_cast<const FieldParts*>(parameters);
    return parameters != nullptr && (parameters->isField() || (more != nullptr && reading != nullptr &&
                                                               reading->readsCellsOf(*more)));
  };
  std::vector<std::string> fields;
  for (const scene::Object& candidate : objects) {
    const auto* parameters = parametersAt(candidate);
    if (!offers(parameters)) continue;
    fields.push_back(candidate.name);
    if (!parts) continue;
    if (const auto* more = dynamic_cast<const FieldParts*>(parameters))
      for (const std::string& part : more->fieldParts()) fields.push_back(candidate.name + "." + part);
  }
  if (std::find(fields.begin(), fields.end(), name) != fields.end()) return {};
  const std::string owner = parts ? name.substr(0, name.find('.')) : name;
  const auto named =
      std::find_if(objects.begin(), objects.end(), [&](const auto& other) { return other.name == owner; });
  if (named != objects.end() && named->parameters == nullptr) return {};  // a mistake of its own
  const auto* of = named == objects.end() ? nullptr : parametersAt(*named);
  if (offers(of)) {
    // All of its own: what it is best known by may have the object's name alone.
    std::erase_if(fields, [&](const std::string& field) {
      return field != owner && !field.starts_with(owner + ".");
    });
    return fmt::format("object \"{}\" has no field {}; known here: {}", owner, scene::inQuotes(name),
                       fmt::join(fields, ", "));
  }
  const std::string what = name.empty() ? unnamed
                           : of == nullptr
                               ? fmt::format("no object is named {}", scene::inQuotes(owner))
                               : fmt::format("object \"{}\" is a {}{}", owner, named->kind, noFieldOf(of));
  return fmt::format("{}; {}", what,
                     fields.empty() ? "the scene has no field" : scene::suggestion(name, fields));
}

void checkFields(const scene::Object& object, std::span<const scene::Object> objects,
                 const scene::Report& report) {
  if (object.material.skin) {
    const std::string mistake =
        fieldMistake(object.material.skin->field, "the skin has no \"field\"", false, objects);
    if (!mistake.empty()) report(object, {"material", "skin", "field"}, mistake);
  }
  const auto* parameters = parametersAt(object);
  if (parameters == nullptr) return;
  const auto* reading = dynamic_cast<const FieldReading*>(parameters);
  const auto check = [&](const std::string& name, const std::vector<std::string>& path) {
    const std::string mistake = fieldMistake(name, "it has no \"field\"", true, objects, reading);
    if (mistake.empty()) return;
    std::vector<std::string> whole = {object.kind};
    whole.insert(whole.end(), path.begin(), path.end());
    report(object, whole, mistake);
  };
  if (parameters->needsField()) check(parameters->readsField(), {"field"});
  if (reading != nullptr)
    for (const FieldReading::From& from : reading->readsFields()) check(from.name, from.path);
}

/// The solid that an object collides with.
void checkWalls(const scene::Object& object, std::span<const scene::Object> objects,
                const scene::Report& report) {
  const auto* parameters = parametersAt(object);
  const std::string name = parameters == nullptr ? std::string() : parameters->meetsWalls();
  if (name.empty()) return;
  std::vector<std::string> solids;
  for (const scene::Object& candidate : objects)
    if (const auto* other = parametersAt(candidate); other != nullptr && other->hasWalls())
      solids.push_back(candidate.name);
  if (std::find(solids.begin(), solids.end(), name) != solids.end()) return;
  const auto named =
      std::find_if(objects.begin(), objects.end(), [&](const auto& other) { return other.name == name; });
  if (named != objects.end() && named->parameters == nullptr) return;  // a mistake of its own
  const std::string what =
      named == objects.end() ? fmt::format("no object is named {}", scene::inQuotes(name))
                             : fmt::format("object \"{}\" is a {}, which has no walls", name, named->kind);
  report(object, {object.kind, "walls"},
         fmt::format(
             "{}; {}", what,
             solids.empty() ? "the scene has no cave and no contour" : scene::suggestion(name, solids)));
}

/// The fluid that is an object's wind.
void checkWind(const scene::Object& object, std::span<const scene::Object> objects,
               const scene::Report& report) {
  const auto* parameters = parametersAt(object);
  if (parameters == nullptr) return;
  const ObjectParameters::WindFrom from = parameters->windFrom();
  if (from.fluid.empty()) return;
  std::vector<std::string> fluids;
  for (const scene::Object& candidate : objects)
    if (const auto* other = parametersAt(candidate); other != nullptr && other->blows())
      fluids.push_back(candidate.name);
  if (std::find(fluids.begin(), fluids.end(), from.fluid) != fluids.end()) return;
  const auto named = std::find_if(objects.begin(), objects.end(),
                                  [&](const auto& other) { return other.name == from.fluid; });
  if (named != objects.end() && named->parameters == nullptr) return;  // a mistake of its own
  const std::string what = named == objects.end()
                               ? fmt::format("no object is named {}", scene::inQuotes(from.fluid))
                               : fmt::format("object \"{}\" is a {}, not a fluid", from.fluid, named->kind);
  std::vector<std::string> path = {object.kind};
  path.insert(path.end(), from.path.begin(), from.path.end());
  report(object, path,
         fmt::format("{}; {}", what,
                     fluids.empty() ? "the scene has no fluid" : scene::suggestion(from.fluid, fluids)));
}

/// The cloth that particles meet.
void checkCloth(const scene::Object& object, std::span<const scene::Object> objects,
                const scene::Report& report) {
  const auto* parameters = parametersAt(object);
  const std::string name = parameters == nullptr ? std::string() : parameters->meetsCloth();
  if (name.empty()) return;
  std::vector<std::string> cloths;
  for (const scene::Object& candidate : objects)
    if (const auto* other = parametersAt(candidate); other != nullptr && other->feelsFaces())
      cloths.push_back(candidate.name);
  if (std::find(cloths.begin(), cloths.end(), name) != cloths.end()) return;
  const auto named =
      std::find_if(objects.begin(), objects.end(), [&](const auto& other) { return other.name == name; });
  if (named != objects.end() && named->parameters == nullptr) return;  // a mistake of its own
  const std::string what =
      named == objects.end()
          ? fmt::format("no object is named {}; \"all\" and \"none\" are words here, too",
                        scene::inQuotes(name))
          : fmt::format("object \"{}\" is {}", name,
                        parametersAt(*named)->isCloth()
                            ? "a cloth without \"contact\", which lets particles through"
                            : "no cloth");
  report(object, {object.kind, "cloths"},
         fmt::format("{}; {}", what,
                     cloths.empty() ? "give a \"cloth\" of this scene \"contact\": {}"
                                    : scene::suggestion(name, cloths)));
}

/// The bodies that an object is tied to.
void checkTies(const scene::Object& object, std::span<const scene::Object> objects,
               const scene::Report& report) {
  const auto* parameters = parametersAt(object);
  if (parameters == nullptr) return;
  std::vector<std::string> bodies;
  for (const scene::Object& candidate : objects)
    if (const auto* other = parametersAt(candidate); other != nullptr && other->isBody())
      bodies.push_back(candidate.name);
  for (const ObjectParameters::Tie& tie : parameters->ties()) {
    if (std::find(bodies.begin(), bodies.end(), tie.body) != bodies.end()) continue;
    const auto named = std::find_if(objects.begin(), objects.end(),
                                    [&](const auto& other) { return other.name == tie.body; });
    if (named != objects.end() && named->parameters == nullptr) continue;  // a mistake of its own
    const std::string what =
        named == objects.end()
            ? fmt::format("no object is named {}", scene::inQuotes(tie.body))
            : fmt::format("object \"{}\" is a {}, which has no bones", tie.body, named->kind);
    std::vector<std::string> path = {object.kind};
    path.insert(path.end(), tie.path.begin(), tie.path.end());
    report(object, path,
           fmt::format("{}; {}", what,
                       bodies.empty() ? "the scene has no body" : scene::suggestion(tie.body, bodies)));
  }
}

/// Quantities that an object tells of.
void checkQuantities(const scene::Object& object, std::span<const scene::Object> objects,
                     const scene::Report& report) {
  const auto* parameters = parametersAt(object);
  if (parameters == nullptr) return;
  for (const ObjectParameters::Named& wanted : parameters->namesQuantities()) {
    std::vector<std::string> path = {object.kind};
    path.insert(path.end(), wanted.path.begin(), wanted.path.end());
    std::vector<std::string> names;
    const scene::Object* named = nullptr;
    for (const scene::Object& candidate : objects) {
      if (candidate.name == wanted.object) named = &candidate;
      if (candidate.parameters != nullptr && candidate.parameters->measures())
        names.push_back(candidate.name);
    }
    if (named == nullptr) {
      report(object, path,
             fmt::format("no object is named {}; {}", scene::inQuotes(wanted.object),
                         names.empty() ? "none of this scene measures anything"
                                       : scene::suggestion(wanted.object, names)));
      continue;
    }
    if (named->parameters == nullptr) continue;  // a mistake of its own
    std::vector<std::string> known;
    if (named->parameters->measures())
      for (const scene::Quantity& quantity : named->parameters->quantities())
        known.emplace_back(quantity.name);
    if (std::find(known.begin(), known.end(), wanted.quantity) != known.end()) continue;
    report(object, path,
           fmt::format("object \"{}\" does not measure {}; {}", wanted.object,
                       scene::inQuotes(wanted.quantity),
                       known.empty() ? "it measures nothing" : scene::suggestion(wanted.quantity, known)));
  }
}

/// One surface of heights.
void checkHeights(std::span<const scene::Object> objects, const scene::Report& report) {
  const scene::Object* surface = nullptr;
  for (const scene::Object& object : objects) {
    const auto* parameters = parametersAt(object);
    if (parameters == nullptr || !parameters->publishesHeights()) continue;
    if (surface != nullptr)
      report(object, {object.kind, "collides"},
             fmt::format("a scene has one thing that others fall onto, and \"{}\" is one already",
                         surface->name));
    else
      surface = &object;
  }
}

/// Cloths in contact for those whose faces are to be felt.
void checkFaces(std::span<const scene::Object> objects, const scene::Report& report) {
  const auto any = [&](bool (ObjectParameters::*is)() const) {
    return std::any_of(objects.begin(), objects.end(), [&](const scene::Object& object) {
      const auto* parameters = parametersAt(object);
      return parameters != nullptr && (parameters->*is)();
    });
  };
  if (any(&ObjectParameters::feelsFaces)) return;
  for (const scene::Object& object : objects)
    if (const auto* parameters = parametersAt(object);
        parameters != nullptr && parameters->collidesByFaces())
      report(object, {object.kind, "collides"},
             "nothing feels these faces; give a \"cloth\" of this scene \"contact\": {}");
}

std::vector<std::string> followMistakes(const scene::Scene& scene) {
  std::vector<std::string> finders;
  for (const scene::Object& object : scene.objects)
    if (const auto* parameters = parametersAt(object); parameters != nullptr && parameters->findsPath())
      finders.push_back(object.name);
  std::vector<std::string> mistakes;
  const auto check = [&](const std::string& where, const std::string& name) {
    if (std::find(finders.begin(), finders.end(), name) != finders.end()) return;
    mistakes.push_back(
        fmt::format("{}.follow.object: no object with a path is named {}; {}", where, scene::inQuotes(name),
                    finders.empty() ? "the scene has none: add a cave" : scene::suggestion(name, finders)));
  };
  if (scene.camera.track) {
    std::vector<std::string> names;
    for (const scene::Object& object : scene.objects) names.push_back(object.name);
    const std::string& wanted = scene.camera.track->object;
    if (std::find(names.begin(), names.end(), wanted) == names.end())
      mistakes.push_back(
          fmt::format("camera.track.object: no object is named {}; {}", scene::inQuotes(wanted),
                      names.empty() ? "the scene has none" : scene::suggestion(wanted, names)));
  }
  if (scene.camera.follow) check("camera", scene.camera.follow->object);
  for (const scene::Light& light : scene.lights)
    if (light.follow) check("lights." + light.name, light.follow->object);
  return mistakes;
}

}  // namespace

void checkRelations(std::span<const scene::Object> objects, const scene::Report& report) {
  for (const scene::Object& object : objects) {
    checkFields(object, objects, report);
    checkWalls(object, objects, report);
    checkWind(object, objects, report);
    checkCloth(object, objects, report);
    checkTies(object, objects, report);
    checkQuantities(object, objects, report);
  }
  checkHeights(objects, report);
  checkFaces(objects, report);
}

std::vector<std::string> relationMistakes(const scene::Scene& scene) {
  std::vector<std::string> mistakes = followMistakes(scene);
  bool touched = scene.hasGround && !scene.staged;
  for (const scene::Object& object : scene.objects)
    if (const auto* parameters = parametersAt(object))
      touched = touched || parameters->isTouched() || parameters->feelsFaces();
  for (const scene::Object& object : scene.objects)
    if (const auto* parameters = parametersAt(object);
        !touched && parameters != nullptr && parameters->asksToCollide())
      mistakes.push_back(
          fmt::format("objects.{}.{}.collides: there is nothing to touch; add a ground or a shape, or give "
                      "a mesh, a body or water \"collides\": true, or a cloth \"contact\": true",
                      object.name, object.kind));
  return mistakes;
}

bool hasClothsInContact(const scene::Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(), [](const scene::Object& object) {
    return parametersAt(object) != nullptr && parametersAt(object)->feelsFaces();
  });
}

std::vector<std::string> relationRemarks(const scene::Scene& scene) {
  std::vector<std::string> remarks;
  const scene::Object* falling = nullptr;
  for (const scene::Object& object : scene.objects)
    if (parametersAt(object) != nullptr && parametersAt(object)->meetsAllCloths()) falling = &object;
  for (const scene::Object& object : scene.objects)
    if (const auto* cloth = parametersAt(object);
        falling != nullptr && cloth != nullptr && cloth->isCloth() && !cloth->feelsFaces())
      remarks.push_back(fmt::format(
          "particles \"{}\" collide, but pass through cloth \"{}\", which has no contact: give it "
          "\"contact\": true, or them \"cloths\": \"none\"",
          falling->name, object.name));
  return remarks;
}

}  // namespace simreel::sim
