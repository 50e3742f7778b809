#include "cli/bake/skins.hpp"

#include "draw/overlay/field_textures.hpp"
#include "draw/surface/skin_look.hpp"
#include "draw/surface/skin_maps.hpp"
#include "draw/surface/skin_textures.hpp"

#include <glm/common.hpp>

namespace simreel::cli {

struct BakedSkins::Painter {
  explicit Painter(const scene::Scene& scene) : fields(scene), skins(scene) {}

  draw::FieldTextures fields;
  draw::SkinTextures skins;
  draw::SkinMapper mapper;
};

BakedSkins::BakedSkins(const scene::Scene& scene, const sim::World& world) : scene_(scene), world_(world) {}
BakedSkins::~BakedSkins() = default;

std::optional<frame::SkinPictures> BakedSkins::of(const scene::Material& material) {
  constexpr int largestSide = 4096;
  if (!material.skin) return std::nullopt;
  if (!painter_) painter_ = std::make_unique<Painter>(scene_);
  const sim::Drawables drawables = world_.drawables();
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  painter_->fields.update(drawables);
  painter_->skins.update(painter_->fields);
  const draw::SkinTextures::Entry* entry = painter_->skins.find(*material.skin);
  if (entry == nullptr) return std::nullopt;
  const glm::ivec2 size = glm::min(entry->cells, glm::ivec2(largestSide));
  return frame::SkinPictures{painter_->mapper.draw(*entry, *material.skin, size), glowOf(*material.skin),
                             glm::vec2(material.skin->repeats)};
}

glm::vec3 glowOf(const scene::Skin& skin) {
  return skin.look == scene::Skin::Look::cracks ? draw::lookOf(skin).high : glm::vec3(0);
}

}  // namespace simreel::cli
