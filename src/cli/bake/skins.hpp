#pragma once
#include "frame/mesh/gltf_materials.hpp"
#include "scene/scene.hpp"
#include "sim/world/world.hpp"

#include <memory>
#include <optional>

namespace simreel::cli {

/// Draws the pictures of skins for files of meshes. Compiles its kernels at the first skin.
class BakedSkins {
 public:
  /// Both must outlive this object.
  BakedSkins(const scene::Scene& scene, const sim::World& world);
  ~BakedSkins();
  BakedSkins(const BakedSkins&) = delete;
  BakedSkins& operator=(const BakedSkins&) = delete;

  /// Returns the pictures of a material at the world's frame, with a texel per cell of the skin's field;
  /// nullopt if the material has no skin or its field is not published.
  [[nodiscard]] std::optional<frame::SkinPictures> of(const scene::Material& material);

 private:
  struct Painter;
  const scene::Scene& scene_;
  const sim::World& world_;
  std::unique_ptr<Painter> painter_;
};

/// Returns the largest radiance that a skin emits; black for looks that do not emit.
[[nodiscard]] glm::vec3 glowOf(const scene::Skin& skin);

}  // namespace simreel::cli
