// Tests that the defaults in `simreel list` and in the schema equal the values that apply if a scene leaves
// them out.
#include "base/error.hpp"
#include "base/file.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "scene/sections.hpp"
#include "scene/texts/help_page.hpp"
#include "scene/texts/schema_text.hpp"
#include "scene/value/value_writer.hpp"
#include "sim/world/list.hpp"
#include "source_folder.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

using namespace simreel;
using Json = nlohmann::ordered_json;

namespace {

const std::string scenes = sourceFolder() + "/assets/scenes/";

/// Returns every value of a scene after parsing, or nullopt if the scene is refused.
std::optional<Json> understood(const Json& scene) {
  try {
    scene::Scene read = scene::parseScene(scene.dump(), scenes + "x.json", {}, sim::kinds());
    scene::ValueWriter all;
    scene::describeScene(all, read);
    scene::describeTests(all, read, std::nullopt);
    Json values = all.values();
    for (const scene::Object& object : read.objects) {
      scene::ValueWriter own;
      object.parameters->describe(own);
      scene::Material material = object.material;
      scene::ValueWriter surface;
      material.describe(surface);
      values["objects"][object.name] = {own.values(), surface.values()};
    }
    return values;
  } catch (const UserError&) {
    return std::nullopt;
  }
}

/// A value that a scene leaves out and whose default is tested.
struct LeftOut {
  Json::json_pointer part;  ///< part of the scene that has no member `name`
  std::string name;
  Json standard;
  std::string path;  ///< path of the value, for messages
};

/// Collects the values that a part of a scene leaves out, using the schema of the part.
void collect(const Json& part, const Json& schema, const Json::json_pointer& at, const std::string& path,
             std::vector<LeftOut>& found) {
  for (const auto& [name, property] : schema.at("properties").items()) {
    const std::string here = path + "." + name;
    if (!part.contains(name)) {
      if (property.contains("default")) found.push_back({at, name, property.at("default"), here});
      continue;
    }
    if (property.contains("properties")) collect(part.at(name), property, at / name, here, found);
    if (property.contains("items") && property.at("items").contains("properties"))
      for (std::size_t i = 0; i < part.at(name).size(); ++i)
        collect(part.at(name).at(i), property.at("items"), at / name / i, here + "[]", found);
  }
}

/// Adds many defaults to a scene at once. If the result is refused or differs, tries each half of the
/// defaults separately.
class GiveDefaults {
 public:
  explicit GiveDefaults(Json scene) : scene_(std::move(scene)), plain_(understood(scene_).value()) {}

  void give(std::span<const LeftOut> some) {
    Json given = scene_;
    for (const LeftOut& one : some) given[one.part][one.name] = one.standard;
    const std::optional<Json> values = understood(given);
    if (values && *values == plain_) {
      same += static_cast<int>(some.size());
    } else if (some.size() > 1) {
      give(some.first(some.size() / 2));
      give(some.subspan(some.size() / 2));
    } else if (values) {
      CHECK_MESSAGE(false, some[0].path, " = ", some[0].standard.dump(),
                    " given is not the same as left out");
    } else {
      refused.insert(some[0].path);
    }
  }
  [[nodiscard]] const Json& scene() const { return scene_; }
  int same = 0;
  std::set<std::string> refused;

 private:
  Json scene_;
  Json plain_;
};

/// Returns a map from each name on the page to the default shown for it.
std::map<std::string, std::string> shownDefaults(const std::string& page) {
  std::map<std::string, std::string> shown;
  for (const scene::HelpRow& row : scene::helpPage(page, sim::kinds().list).rows)
    shown.emplace(row.name, row.standard);
  return shown;
}

void comparePage(const std::map<std::string, std::string>& shown, const Json& schema,
                 const std::string& prefix, int& compared) {
  for (const auto& [key, property] : schema.at("properties").items()) {
    const std::string name = key;  // Clang 14 cannot capture a structured binding.
    if (property.contains("default") && shown.contains(prefix + name)) {
      const Json& standard = property.at("default");
      const bool counted = shown.at(prefix + name) == fmt::format("{} items", standard.size());
      CHECK_MESSAGE((counted || shown.at(prefix + name) == standard.dump()), prefix, name);
      ++compared;
    }
    if (property.contains("properties")) comparePage(shown, property, prefix + name + ".", compared);
    if (property.contains("items") && property.at("items").contains("properties"))
      comparePage(shown, property.at("items"), prefix + name + "[].", compared);
  }
}

}  // namespace

TEST_CASE("defaults: stating the default of any parameter of a shipped scene changes nothing") {
  const Json schema = Json::parse(scene::schemaText(sim::kinds().list));
  int same = 0;
  std::set<std::string> refused;
  std::map<std::string, int> asked;  // number of scenes in which each default has been tried; two scenes
                                     // are needed, because the effect of some parameters depends on others
  for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
    if (entry.path().extension() != ".json" || entry.path().string().ends_with(".test.json")) continue;
    CAPTURE(entry.path().string());
    const std::string text = readFile(entry.path(), "scene");
    GiveDefaults scene(Json::parse(text, nullptr, true, true));
    std::vector<LeftOut> found;
    collect(scene.scene(), schema, Json::json_pointer(), "", found);
    for (const auto& [name, object] : scene.scene().at("objects").items())
      for (const auto& [kind, part] : object.items())
        collect(part, schema.at("$defs").at(kind), Json::json_pointer("/objects") / name / kind, kind,
                found);
    // A stage has separate defaults for the sun.
    const bool staged = scene.scene().contains("stage") && scene.scene().at("stage") != false;
    std::erase_if(found, [&](const LeftOut& one) {
      return asked[one.path] >= 2 || (staged && one.path.starts_with(".sun."));
    });
    for (const LeftOut& one : found) ++asked[one.path];
    if (!found.empty()) scene.give(found);
    same += scene.same;
    refused.merge(scene.refused);
  }
  CHECK(same > 800);
  // The following parameters are refused without another parameter, which the message names.
  const std::set<std::string> allowed = {
      "mesh.grip", "mesh.distanceCells", "mesh.file", "particles.bounce", "particles.cloths",
      ".camera.position", ".camera.target", ".camera.height", "particles.margin", "grayScott.preset",
      ".checks[].object", ".checks[].of", ".test.xfail", ".test.tolerance.windowSize",
      // The following parameters have no effect with a fabric.
      "cloth.mass", "cloth.stiffness", "cloth.shear", "cloth.bend", "cloth.solver", "cloth.compliance",
      "cloth.shearCompliance", "cloth.bendCompliance",
      // The following parameters have no effect with a mesh, or with a friction coefficient.
      "cloth.size", "cloth.spacing", "capsule.grip", "sphere.grip", "cone.grip", "cone.distanceCells",
      "cylinder.grip", "cylinder.distanceCells", "box.grip", "box.distanceCells", "torus.grip",
      "torus.distanceCells", "body.grip",
      // The following parameters have no effect on a text on the screen.
      "text.depth", "text.height", "text.position", "text.rotation", "text.scale",
      // The following parameters have no effect if a mesh replaces the grid.
      "reaction.size", "reaction.depth", "reaction.boundary",
      // The following parameters need an image of a terrain.
      "water.terrain.low", "water.terrain.high", "water.terrain.smooth", "water.terrain.bed",
      "water.terrain.repeat",
      // The following parameters have no effect if the shape or the mass of a float is given. The last one
      // needs water that collides.
      "water.floats[].density", "water.floats[].file", "water.floats[].radius", "water.floats[].scale",
      "water.floats[].size", "water.grip",
      // The following parameters need maps, coats, sheen or opacity.
      "material.alphaCutoff", "material.attenuationColor", "material.attenuationDistance",
      "material.clearCoatRoughness", "material.emissionMap", "material.ior", "material.thinWalled",
      "material.normalStrength", "material.occlusionStrength", "material.opacity",
      "material.sheenRoughness",
      // The following parameters need flow lines, or a sky with a panorama.
      "fluid.lineDetail", "fluid.lineRate", ".sky.strength", ".sky.turn"};
  for (const std::string& path : refused) CHECK_MESSAGE(allowed.contains(path), path);
}

TEST_CASE("defaults: documentation pages show the defaults of the schema") {
  const Json schema = Json::parse(scene::schemaText(sim::kinds().list));
  int compared = 0;
  for (const scene::Kind& kind : sim::kinds().list)
    comparePage(shownDefaults(kind.name), schema.at("$defs").at(kind.name), "", compared);
  for (const char* section : {"render", "time", "camera", "sun", "sky", "test"})
    comparePage(shownDefaults(section), schema.at("properties").at(section), "", compared);
  comparePage(shownDefaults("haze"), schema.at("properties").at("haze").at("anyOf").at(1), "", compared);
  comparePage(shownDefaults("ground"), schema.at("properties").at("ground").at("anyOf").at(1), "",
              compared);
  comparePage(shownDefaults("material"), schema.at("$defs").at("material"), "", compared);
  CHECK(compared > 300);
  CHECK(shownDefaults("cloth").at("pins") == "none; in a scene of version 1 the last row");
  CHECK(shownDefaults("life").at("display.map") == "off");
  CHECK(shownDefaults("grayScott").at("feed") == "the preset's");
}
