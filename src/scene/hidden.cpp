#include "scene/hidden.hpp"

#include "scene/covering.hpp"
#include "scene/stage.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

/// Returns the first object whose field has this extent, or nullptr.
const Object* covers(const Scene& scene, Covering::Extent extent) {
  const auto found = std::find_if(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
    const auto* covering = dynamic_cast<const Covering*>(object.parameters.get());
    return covering != nullptr && covering->covering() == extent;
  });
  return found == scene.objects.end() ? nullptr : &*found;
}

/// Warns if the scene's own ground hides most of a field that is drawn behind all objects.
void warnHiddenBehind(const Node& root, const Scene& scene, Diagnostics& diagnostics) {
  const Object* field = covers(scene, Covering::Extent::behind);
  if (field == nullptr || !scene.ground || !scene.ground->visible || scene.stage.leaves("ground")) return;
  diagnostics.remark(
      root.find("ground")->headPlace(),
      fmt::format("the ground hides the picture of \"{}\", which is behind all objects; leave out "
                  "\"ground\", or give it \"visible\": false",
                  field->name));
}

}  // namespace

void warnHidden(const Node& root, const Scene& scene, Diagnostics& diagnostics) {
  if (const std::string advice = groundAdvice(scene); !advice.empty())
    diagnostics.remark(root.find("ground")->headPlace(), advice);
  warnHiddenBehind(root, scene, diagnostics);
  const Object* const cover = covers(scene, Covering::Extent::whole);
  if (cover == nullptr) return;
  const auto hidden = std::find_if(scene.objects.begin(), scene.objects.end(),
                                   [](const Object& object) { return object.parameters->framed(); });
  if (hidden == scene.objects.end()) return;
  if (!scene.panels.empty()) return;  // a panel may show each of them
  const bool writes = hidden->kind == "text";
  diagnostics.remark(
      root.find("objects")->find(hidden->name)->headPlace(),
      fmt::format("\"{}\" is in the world and hidden behind the picture of \"{}\"; {}give the \"display\" "
                  "of \"{}\" \"layer\": \"behind\", or a smaller \"extent\"",
                  hidden->name, cover->name, writes ? "give it \"screen\": {}, or " : "", cover->name));
}

}  // namespace simreel::scene
