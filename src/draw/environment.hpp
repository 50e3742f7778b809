#pragma once
#include "draw/frame_values.hpp"
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "scene/scene.hpp"
#include "sim/light/light_file.hpp"

#include <optional>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// Light from all around, of an equirectangular picture, as glsl/draw/environment.glsl reads it.
struct EnvironmentTexels {
  int side = 0;  ///< cells of the finest map's
  std::vector<glm::vec4> texels;
};

/// The middle of the picture lies towards -z, its left half on the side of -x; `turn` (degrees) moves the
/// middle towards +x. Only operations that IEEE 754 pins down. Throws UserError(inputOutput) with `label`
/// first for a picture that is not twice as wide as high, or holds what is no light.
[[nodiscard]] EnvironmentTexels environmentOf(const sim::LightFile& picture, double strength, double turn,
                                              const std::string& label);

/// The sky of a scene that is a picture.
class Environment {
 public:
  /// Throws UserError for a picture that cannot be read.
  explicit Environment(const scene::Sky& sky);

  /// Defines of what reads it.
  [[nodiscard]] gl::Defines defines() const;
  void bind() const;
  /// A gradient like it, for those that know nothing else.
  void setGradient(shader::Frame& frame, float ambient) const;

 private:
  int side_;
  gl::Buffer buffer_;
  gl::Texture view_;
  glm::vec3 up_{0}, around_{0}, down_{0};  ///< irradiance / pi on what faces there
};

}  // namespace simreel::draw
