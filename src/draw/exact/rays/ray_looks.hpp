#pragma once
#include "draw/exact/rays/ray_kernels.hpp"
#include "draw/exact/surface/map_texels.hpp"
#include "draw/exact/surface/skin_texels.hpp"
#include "draw/surface/skin_textures.hpp"
#include "gl/buffer.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <map>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::draw {

/// Material table of the path tracer (glsl/draw/exact/rays/look_table.glsl), with the maps and skins that
/// the materials use. Index 0 means that the data stored in a spot (visible surface point) fully describe
/// the material.
class RayMaterials {
 public:
  /// The surface shading must already have loaded the maps and updated the skin texels.
  RayMaterials(MapTexels& maps, const SkinTextures& skins, const SkinTexels& skinTexels)
      : maps_(maps), skins_(skins), skinTexels_(skinTexels) {}

  void begin();
  /// Adds a material to the table and returns its index (the owner).
  unsigned add(const sim::Surface& surface);
  unsigned add(const scene::Material& particles);
  /// Uploads the table after the last add().
  void finish();

  /// Returns the table index (owner) of a surface's material. Returns 0 if the material is opaque and has
  /// no maps, skin or additional layers.
  [[nodiscard]] unsigned ownerOf(const scene::Material& material) const;
  /// isTextured() returns true if the surface has a texture or skin, so that its vertices store texture
  /// coordinates. isTriplanar() returns true if the texture projection is triplanar, and false if uv
  /// coordinates are used.
  [[nodiscard]] static bool isTextured(const sim::Surface& surface);
  [[nodiscard]] static bool isTriplanar(const sim::Surface& surface);
  [[nodiscard]] static float scaleOf(const sim::Surface& surface);
  void addTo(RayFeatures& features) const;
  [[nodiscard]] bool anyEmit() const { return emits_; }
  [[nodiscard]] bool anyGlass() const { return glass_; }
  [[nodiscard]] const gl::Texture& skinTexels() const { return skinView_; }
  [[nodiscard]] const gl::Texture& mapTexels() const { return maps_.texels(); }
  [[nodiscard]] const gl::Texture& view() const { return view_; }

 private:
  glm::uvec4* put(const scene::Material& material);
  void putMaps(const sim::Surface& surface, glm::uvec4* look);
  void putSkin(const scene::Skin& skin, const SkinTextures::Entry& entry, bool threeSided,
               glm::uvec4* look);
  void gatherSkins();

  MapTexels& maps_;
  const SkinTextures& skins_;
  const SkinTexels& skinTexels_;
  std::vector<glm::uvec4> words_;
  std::map<const scene::Material*, unsigned> owners_;
  std::map<const SkinTextures::Entry*, unsigned> skinFirsts_;
  unsigned skinCount_ = 0;
  bool laid_ = false, skinned_ = false, emits_ = false, finished_ = false, glass_ = false, holes_ = false,
       raised_ = false;
  gl::Buffer table_, skinBuffer_;
  gl::Texture view_, skinView_;
};

}  // namespace simreel::draw
