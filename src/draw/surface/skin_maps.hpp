#pragma once
#include "draw/draw_state.hpp"
#include "draw/surface/skin_textures.hpp"
#include "gl/program.hpp"
#include "scene/scene.hpp"

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// A skin as tileable pictures of size.x * size.y texels. The first row is row 0 of the field.
struct SkinMaps {
  glm::ivec2 size{0, 0};
  std::vector<glm::vec4> surface;  ///< rgb: linear albedo; a: roughness
  std::vector<glm::vec4> relief;   ///< xyz: unit normal in tangent space (x right, y towards smaller row
                                   ///< indices, z out of the surface); a: height, 0 to 1
  std::vector<glm::vec4> light;    ///< rgb: emitted radiance; a: ambient occlusion factor
};

/// Renders skins into maps with the same shader code that surfaces use.
class SkinMapper {
 public:
  /// Renders the maps and waits for the GPU. Throws UserError(device) if the size exceeds the device's
  /// texture limit.
  [[nodiscard]] SkinMaps draw(const SkinTextures::Entry& entry, const scene::Skin& skin, glm::ivec2 size);

 private:
  std::map<scene::Skin::Look, gl::Program> programs_;
  VertexArray vertices_;
};

}  // namespace simreel::draw
