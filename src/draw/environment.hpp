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

/// Environment light from an equirectangular image, stored in the layout of glsl/draw/environment.glsl.
struct EnvironmentTexels {
  int side = 0;  ///< cells per side of the finest map
  std::vector<glm::vec4> texels;
};

/// Converts an equirectangular image. The image's centre faces -z and its left half is on the side of -x.
/// `turn` (degrees) rotates the centre towards +x. Uses only operations that IEEE 754 rounds exactly.
/// Throws UserError(inputOutput), with a message that starts with `label`, if the image is not twice as
/// wide as high or contains invalid light values.
[[nodiscard]] EnvironmentTexels environmentOf(const sim::LightFile& picture, double strength, double turn,
                                              const std::string& label);

/// The sky of a scene whose sky is an image.
class Environment {
 public:
  /// Loads the sky image. Throws UserError if it cannot be read.
  explicit Environment(const scene::Sky& sky);

  /// Returns the defines of shader programs that read the environment.
  [[nodiscard]] gl::Defines defines() const;
  void bind() const;
  /// Sets a sky gradient similar to the image, for shaders that support only gradients.
  void setGradient(shader::Frame& frame, float ambient) const;

 private:
  int side_;
  gl::Buffer buffer_;
  gl::Texture view_;
  glm::vec3 up_{0}, around_{0}, down_{0};  ///< irradiance divided by pi on surfaces that face up, sideways
                                           ///< and down
};

}  // namespace simreel::draw
