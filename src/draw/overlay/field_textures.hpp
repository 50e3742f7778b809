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

/// Fields that are the skin of something, as textures with mip maps, made once a frame by a kernel that
/// reads the simulation's memory. Other fields are left alone: FieldPass draws them from their cells.
class FieldTextures {
 public:
  /// Knows from the scene's materials which fields are skins, and from the picture's size how fine they
  /// need to be. exact: without the driver's mip maps.
  explicit FieldTextures(const scene::Scene& scene, Rasterizer rasterizer = Rasterizer::driver);

  /// Colours (`stops`, `stopCount`) matter for values only.
  struct Entry : FieldColors {
    gl::Texture texture;  ///< R32F values, or RGBA16F linear light of categories; row 0 is the field's row
                          ///< 0; repeated beyond its borders; whole mip
                          ///< chain unless exact
    glm::ivec2 cells{0, 0};  ///< of the field; the texture may be smaller, and covers exactly the field
    int reduction = 1;       ///< cells a texel on a side, averaged
    glm::vec2 range{0, 1};
    bool colored = false;  ///< categories: the texture holds colours
  };
  /// Brings the textures of a frame's skins up to date. Throws UserError(device) beyond
  /// GL_MAX_TEXTURE_SIZE.
  void update(const sim::Drawables& drawables);
  /// Null when no field of that name was published, or no material asks for it.
  [[nodiscard]] const Entry* find(const std::string& name) const;

 private:
  std::set<std::string> wanted_;
  bool exact_;
  int maxSide_;  ///< texels
  FieldKernel kernel_;
  std::map<std::string, Entry> entries_;
};

}  // namespace simreel::draw
