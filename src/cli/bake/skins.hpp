#pragma once
#include "frame/mesh/gltf_materials.hpp"
#include "scene/scene.hpp"
#include "sim/world/world.hpp"

#include <memory>
#include <optional>

namespace simreel::cli {

/// Draws the pictures of skins for files of meshes. The kernels are compiled at the first skin.
class BakedSkins {
 public:
  /// `scene` and `world` must outlive this object.
  BakedSkins(const scene::Scene& scene, const sim::World& world);
  ~BakedSkins();
  BakedSkins(const BakedSkins&) = delete;
  BakedSkins& operator=(const BakedSkins&) = delete;

  /// Returns the pictures of a material at the world's frame, with one texel per cell of the skin's field.
  /// Returns nullopt if the material has no skin or if the skin's field is not published.
  [[nodiscard]] std::optional<frame::SkinPictures> of(const scene::Material& material);

 private:
  struct Painter;
  const scene::Scene& scene_;
  const sim::World& world_;
  std::unique_ptr<Painter> painter_;
};

/// Returns the largest radiance that a skin emits. Returns black for looks that do not emit.
[[nodiscard]] glm::vec3 glowOf(const scene::Skin& skin);

}  // namespace simreel::cli
