#pragma once
#include "draw/draw_state.hpp"
#include "draw/surface/skin_textures.hpp"
#include "gl/program.hpp"
#include "scene/scene.hpp"

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// A skin as pictures that tile, rows from the field's row 0 on; each size.x * size.y texels.
struct SkinMaps {
  glm::ivec2 size{0, 0};
  std::vector<glm::vec4> surface;  ///< rgb albedo, linear; a roughness
  std::vector<glm::vec4> relief;  ///< xyz unit normal in tangent space: x right, y up (against the rows), z
                                  ///< out of the surface; a height, 0 to 1
  std::vector<glm::vec4> light;   ///< rgb radiance of its own; a fraction of the surroundings' light let in
};

/// Draws skins into maps with the shader code that surfaces use.
class SkinMapper {
 public:
  /// Waits for the GPU. Throws UserError(device) for a size beyond the device's textures.
  [[nodiscard]] SkinMaps draw(const SkinTextures::Entry& entry, const scene::Skin& skin, glm::ivec2 size);

 private:
  std::map<scene::Skin::Look, gl::Program> programs_;
  VertexArray vertices_;
};

}  // namespace simreel::draw
