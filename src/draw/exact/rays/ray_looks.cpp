#include "draw/exact/rays/ray_looks.hpp"

#include "draw/exact/reserve.hpp"
#include "draw/exact/surface/surface_shading.hpp"
#include "draw/surface/skin_look.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>

namespace simreel::draw {

namespace {

#include "glsl/draw/exact/rays/look_table.glsl"

glm::uvec4 bitsOf(glm::vec4 v) {
  return {std::bit_cast<unsigned>(v.x), std::bit_cast<unsigned>(v.y), std::bit_cast<unsigned>(v.z),
          std::bit_cast<unsigned>(v.w)};
}

/// Returns the alpha mode as a number in the material table. Above 0: cutoff of holes; -1: blended; 0:
/// opaque.
float limitOf(const scene::Finish& finish) {
  if (finish.alpha == scene::Alpha::opaque) return 0;
  return finish.alpha == scene::Alpha::cut ? std::max(finish.cutoff, 1e-6F) : -1.0F;
}

}  // namespace

void RayMaterials::begin() {
  words_.assign(lookTexels, glm::uvec4(0));
  owners_.clear();
  skinFirsts_.clear();
  skinCount_ = 0;
  laid_ = skinned_ = emits_ = finished_ = glass_ = holes_ = raised_ = false;
}

bool RayMaterials::isTextured(const sim::Surface& surface) {
  const scene::Material& material = *surface.material;
  const scene::Finish& finish = material.finish;
  return material.skin || !SurfaceShading::colorMapOf(material).empty() || !finish.normals.empty() ||
         !finish.metalRough.empty() || (finish.emits() && !finish.emissionMap.empty());
}

bool RayMaterials::isTriplanar(const sim::Surface& surface) {
  const scene::Material& material = *surface.material;
  const bool uvs = surface.normals == nullptr || surface.uvs != nullptr;
  return !uvs || (material.skin && material.skin->projection != scene::Skin::Projection::uv);
}

float RayMaterials::scaleOf(const sim::Surface& surface) {
  return std::sqrt(std::max(glm::dot(surface.model[0], surface.model[0]), 1e-30F));
}

glm::uvec4* RayMaterials::put(const scene::Material& material) {
  const std::size_t first = words_.size();
  words_.resize(first + lookTexels, glm::uvec4(0));
  words_[first + fallbackMaterial] = bitsOf(
      {material.roughness, material.metallic, material.translucency, material.castsShadow ? 1.0F : 0.0F});
  return &words_[first];
}

unsigned RayMaterials::add(const scene::Material& particles) {
  put(particles);
  return static_cast<unsigned>(words_.size() / lookTexels) - 1;
}

void RayMaterials::putMaps(const sim::Surface& surface, glm::uvec4* look) {
  using Holds = MapTexels::Holds;
  const scene::Material& material = *surface.material;
  const scene::Finish& finish = material.finish;
  const auto place = [&](int which, const scene::Map& map, Holds holds) {
    look[which] = glm::uvec4(maps_.place(map, holds));
  };
  scene::Map color = SurfaceShading::colorMapOf(material);
  if (!finish.used())
    color.wrapU = color.wrapV =
        SurfaceShading::textureRepeats(surface) ? scene::Wrap::repeat : scene::Wrap::clamp;
  place(colorMapLook, color, Holds::color);
  if (!finish.used()) return;
  place(normalMapLook, finish.normals, Holds::numbers);
  place(metalRoughMapLook, finish.metalRough, Holds::numbers);
  if (finish.emits()) place(emissionMapLook, finish.emissionMap, Holds::color);
}

void RayMaterials::putSkin(const scene::Skin& skin, const SkinTextures::Entry& entry, bool threeSided,
                           glm::uvec4* look) {
  const SkinLook materials = lookOf(skin);
  const auto found = skinFirsts_.find(&entry);
  unsigned first = skinCount_;
  if (found == skinFirsts_.end()) {
    skinFirsts_.emplace(&entry, first);
    skinCount_ += static_cast<unsigned>(skinTexels_.count(entry));
  } else {
    first = found->second;
  }
  const auto levels = static_cast<unsigned>(entry.levels());
  look[skinLook] = {first, static_cast<unsigned>(entry.relief.width()),
                    static_cast<unsigned>(entry.relief.height()),
                    levels | static_cast<unsigned>(skin.look) << 8U};
  look[skinValueLook] =
      bitsOf({entry.threshold, materials.roughness, materials.depth, static_cast<float>(entry.cells.x)});
  look[skinLowLook] = bitsOf({materials.low, static_cast<float>(entry.cells.y)});
  look[skinHighLook] = bitsOf({materials.high, 0});
  const float shape = static_cast<float>(entry.cells.x) / static_cast<float>(entry.cells.y);
  const glm::vec4 laid = {skin.repeats, threeSided ? skin.repeats * shape : skin.repeats, 1, 0};
  look[laidLook] = bitsOf(laid);
  skinned_ = true;
  emits_ = emits_ || skin.look == scene::Skin::Look::cracks;
}

unsigned RayMaterials::add(const sim::Surface& surface) {
  const scene::Material& material = *surface.material;
  const scene::Finish& finish = material.finish;
  const SkinTextures::Entry* skin = material.skin ? skins_.find(*material.skin) : nullptr;
  const bool threeSided = isTriplanar(surface);
  glm::uvec4* look = put(material);
  const auto owner = static_cast<unsigned>(words_.size() / lookTexels) - 1;
  owners_.emplace(&material, owner);
  look[laidLook] = bitsOf({material.textureScale.x, material.textureScale.y, finish.normalStrength, 0});
  if (skin != nullptr)
    putSkin(*material.skin, *skin, threeSided, look);
  else
    putMaps(surface, look);
  if (isTextured(surface)) {
    laid_ = true;
    if (threeSided) look[laidLook].w = std::bit_cast<unsigned>(scaleOf(surface));
    for (int i = 0; i < 3; ++i)
      look[modelLook + i] = bitsOf({surface.model[i].x, surface.model[i].y, surface.model[i].z, 0});
  }
  if (skin != nullptr) return owner;
  const glm::vec3 emission = finish.emits() ? finish.emission * finish.emissionStrength : glm::vec3(0);
  look[lightLook] = bitsOf({emission, finish.coat});
  look[layerLook] = bitsOf({finish.coatRoughness, finish.sheenRoughness, finish.opacity, limitOf(finish)});
  look[sheenLook] = bitsOf({finish.sheen, finish.transmission});
  const bool raised = !finish.used() && !material.texture.empty() && material.bump != 0;
  look[glassLook] = bitsOf({finish.ior, finish.thin ? 1.0F : 0.0F, raised ? material.bump : 0.0F, 0});
  raised_ = raised_ || raised;
  look[absorbLook] = bitsOf({absorptionOf(finish), 0});
  emits_ = emits_ || finish.emits();
  glass_ = glass_ || finish.transmission > 0;
  finished_ = finished_ || glass_ || finish.coat > 0 || finish.sheen != glm::vec3(0);
  holes_ = holes_ || finish.alpha != scene::Alpha::opaque;
  return owner;
}

unsigned RayMaterials::ownerOf(const scene::Material& material) const {
  const scene::Finish& finish = material.finish;
  if (material.skin || (finish.coat <= 0 && finish.sheen == glm::vec3(0) && finish.transmission <= 0))
    return 0;
  const auto found = owners_.find(&material);
  return found == owners_.end() ? 0 : found->second;
}

void RayMaterials::gatherSkins() {
  if (skinCount_ == 0) return;
  constexpr std::size_t texelBytes = 16;
  reserve(skinBuffer_, skinView_, "texels of skins", skinCount_ * texelBytes, GL_RGBA32UI, texelBytes);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  for (const auto& [entry, first] : skinFirsts_)
    glCopyNamedBufferSubData(
        skinTexels_.buffer(*entry).name(), skinBuffer_.name(), 0, static_cast<GLintptr>(first * texelBytes),
        static_cast<GLsizeiptr>(static_cast<std::size_t>(skinTexels_.count(*entry)) * texelBytes));
}

void RayMaterials::finish() {
  reserve(table_, view_, "what rays meet is made of", words_.size() * sizeof(glm::uvec4), GL_RGBA32UI, 16);
  table_.write(0, std::as_bytes(std::span(words_)));
  gatherSkins();
}

void RayMaterials::addTo(RayFeatures& features) const {
  features.laid = laid_;
  features.skins = skinned_;
  features.emitters = emits_;
  features.finished = finished_;
  features.passages = glass_ || holes_;
  features.raised = raised_;
}

}  // namespace simreel::draw
