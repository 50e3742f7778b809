#pragma once
#include "draw/overlay/field_kernel.hpp"
#include "draw/rasterizer.hpp"
#include "gl/texture.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

#include <map>
#include <set>
#include <string>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Textures with mip maps for the fields that skins use. A kernel that reads the simulation's memory
/// updates each texture once per frame. FieldPass draws other fields directly from their cells.
class FieldTextures {
 public:
  /// Determines the fields of skins from the scene's materials, and the texture resolution from the
  /// picture's size. For the exact rasterizer, the textures have no mip maps.
  explicit FieldTextures(const scene::Scene& scene, Rasterizer rasterizer = Rasterizer::driver);

  /// Texture of one field. The colours (`stops`, `stopCount`) are used only for fields of values.
  struct Entry : FieldColors {
    gl::Texture texture;  ///< R32F values, or RGBA16F linear light of categories. Row 0 is the field's row
                          ///< 0. The texture repeats, and has all mip levels unless the rasterizer is
                          ///< exact.
    glm::ivec2 cells{0, 0};  ///< size of the field in cells; the texture may be smaller, but covers exactly
                             ///< the field
    int reduction = 1;       ///< number of cells along each axis that a texel averages
    glm::vec2 range{0, 1};
    bool colored = false;  ///< true for categories: the texture holds colours
  };
  /// Updates the textures of a frame's skins. Throws UserError(device) if a texture would exceed
  /// GL_MAX_TEXTURE_SIZE.
  void update(const sim::Drawables& drawables);
  /// Returns the texture of a field, or null if no field of that name was published or no material uses it.
  [[nodiscard]] const Entry* find(const std::string& name) const;

 private:
  std::set<std::string> wanted_;
  bool exact_;
  int maxSide_;  ///< max texture side (texels)
  FieldKernel kernel_;
  std::map<std::string, Entry> entries_;
};

}  // namespace simreel::draw
