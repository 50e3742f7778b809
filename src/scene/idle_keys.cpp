#include "scene/idle_keys.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>
#include <glm/common.hpp>

namespace simreel::scene {

namespace {

/// Returns the node of an object's member, "material" or the object's kind. Returns null if the scene does
/// not give it as an object.
const Node* memberOf(const Node& root, const Object& object, const std::string& key) {
  const Node* const member = root.find("objects")->find(object.name)->find(key);
  return member == nullptr || member->kind != Node::Kind::object ? nullptr : member;
}

/// True if the automatic camera centres the only object of the scene that has an extent.
bool centresOnly(const Scene& scene, const Object& object) {
  const Camera& camera = scene.camera;
  if (camera.placed || camera.aimed || camera.track || camera.follow || camera.gltf) return false;
  return std::none_of(scene.objects.begin(), scene.objects.end(), [&](const Object& other) {
    return &other != &object && (other.parameters->framed() || other.parameters->framedAlone());
  });
}

/// Warns about the anchor of a text that the camera centres. Lines of one text lie differently to each
/// other, and the width of a text with numbers changes.
void warnAnchor(const Node& root, const Scene& scene, const Object& object, Diagnostics& diagnostics) {
  const Node* const text = object.kind == "text" ? memberOf(root, object, "text") : nullptr;
  if (text == nullptr || !object.parameters->framed() || !centresOnly(scene, object)) return;
  const Node* const words = text->find("text");
  if (words != nullptr && words->text.find_first_of("\n{") != std::string::npos) return;
  for (const char* key : {"align", "vertical"})
    if (const Node* const given = text->find(key))
      diagnostics.remark(given->headPlace(),
                         fmt::format("the camera centres \"{}\", the only thing in view, so \"{}\" moves "
                                     "nothing; give \"camera\" a \"target\", or the text \"screen\": {{}}",
                                     object.name, key));
}

/// True if the scene places the camera where it may be inside the object.
bool mayBeInside(const Camera& camera, const Object& object) {
  if (!camera.placed) return false;
  const std::optional<Box> box = object.parameters->framed();
  if (!box || camera.orbit || camera.track || camera.follow || camera.gltf) return true;
  const auto& keys = camera.position.keys();
  return std::any_of(keys.begin(), keys.end(), [&](const auto& key) {
    return glm::clamp(key.value, box->min, box->max) == key.value;
  });
}

void warnDoubleSided(const Node& root, const Scene& scene, const Object& object, Diagnostics& diagnostics) {
  constexpr std::array<std::string_view, 6> solids = {"sphere",   "capsule", "box",
                                                      "cylinder", "cone",    "torus"};
  const Finish& finish = object.material.finish;
  if (!finish.doubleSided || finish.alpha != Alpha::opaque || finish.transmission > 0) return;
  if (std::find(solids.begin(), solids.end(), object.kind) == solids.end()) return;
  if (mayBeInside(scene.camera, object)) return;
  const Node* const material = memberOf(root, object, "material");
  if (material == nullptr || material->find("doubleSided") == nullptr) return;
  diagnostics.remark(material->find("doubleSided")->headPlace(),
                     fmt::format("\"{}\" is a closed solid seen from outside, where only its front sides "
                                 "show; here \"doubleSided\" does nothing",
                                 object.name));
}

}  // namespace

void warnIdleKeys(const Node& root, const Scene& scene, Diagnostics& diagnostics) {
  for (const Object& object : scene.objects) {
    warnAnchor(root, scene, object, diagnostics);
    warnDoubleSided(root, scene, object, diagnostics);
  }
}

}  // namespace simreel::scene
