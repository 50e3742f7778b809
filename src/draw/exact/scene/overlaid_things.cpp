#include "draw/exact/scene/overlaid_things.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

namespace simreel::draw {

namespace {

/// Returns the colour of an object without its textures.
glm::vec3 plainColor(const scene::Scene& scene, const std::string* object,
                     const scene::Material& material) {
  constexpr glm::vec3 grey(0.2F);
  switch (scene.render.overlay) {
    case scene::Overlay::objects: {
      const auto is = [&](const scene::Object& one) { return object != nullptr && one.name == *object; };
      const auto found = std::find_if(scene.objects.begin(), scene.objects.end(), is);
      return objectColor(static_cast<std::size_t>(found - scene.objects.begin()));
    }
    case scene::Overlay::wireframe:
      return glm::clamp(material.color, 0.02F, 0.8F);
    default:
      return grey;
  }
}

}  // namespace

glm::vec3 objectColor(std::size_t i) {
  constexpr double golden = 0.6180339887498949;
  constexpr std::array<float, 3> strengths = {0.85F, 0.45F, 0.65F};
  const auto hue = static_cast<float>(std::fmod(0.55 + golden * static_cast<double>(i), 1.0));
  glm::vec3 color;
  for (int c = 0; c < 3; ++c) {
    const float at = 6 * std::fmod(hue + static_cast<float>(c == 0 ? 0 : 3 - c) / 3, 1.0F);
    color[c] = glm::clamp(std::abs(at - 3) - 1, 0.0F, 1.0F);
  }
  return (0.05F + 0.95F * color * color) * strengths[i / 5 % strengths.size()];
}

void OverlaidThings::apply(const scene::Scene& scene, sim::Drawables& drawables) {
  materials_.clear();
  if (scene.render.overlay == scene::Overlay::none) return;
  const bool normals = scene.render.overlay == scene::Overlay::normals;
  std::erase_if(drawables.instances, [](const sim::Instances& one) { return one.additive; });
  for (sim::Surface& surface : drawables.surfaces) {
    scene::Material material = *surface.material;
    if (!normals) {
      material = scene::Material();
      material.color = plainColor(scene, surface.object, *surface.material);
      surface.palette = nullptr;
      surface.colors = nullptr;
    } else if (material.finish.alpha == scene::Alpha::blend) {
      material.finish.alpha = scene::Alpha::opaque;
    }
    surface.material = &materials_.emplace_back(material);
  }
  if (scene.render.overlay == scene::Overlay::wireframe) return;
  for (sim::Instances& instances : drawables.instances) {
    scene::Material material = *instances.material;
    material.color = plainColor(scene, instances.object, material);
    instances.colorBy = sim::Instances::ColorBy::material;
    instances.material = &materials_.emplace_back(material);
  }
}

}  // namespace simreel::draw
