#pragma once
#include "draw/lights/lamp_values.hpp"
#include "draw/rasterizer.hpp"
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <vector>

#include <glm/vec4.hpp>

namespace simreel::draw {

/// The lights of a scene ("lamps" in the code) in GPU buffers, and the glows that make the lights visible.
/// A scene without lights costs nothing, and its shaders contain no lamp code.
class Lamps {
 public:
  /// `scene` must outlive this object.
  explicit Lamps(const scene::Scene& scene, Rasterizer rasterizer = Rasterizer::driver);

  [[nodiscard]] bool on() const { return !order_.lights.empty(); }
  [[nodiscard]] const LampOrder& order() const { return order_; }
  /// Returns the lamps as of the last update.
  [[nodiscard]] const std::vector<shader::Lamp>& values() const { return values_; }
  /// Updates all lamps to `seconds` of scene time and binds them for shaders.
  void update(double seconds, const sim::Drawables& drawables);
  /// Returns the drawables plus the glows of the lamps. A glow is an additive disc of radius R with the
  /// profile (1 - (r/R)^2)^2, whose intensity towards the camera is the lamp's intensity times its `glow`.
  /// The result is valid until the next update.
  [[nodiscard]] sim::Drawables withGlows(const sim::Drawables& drawables) const;

  /// Returns the defines of programs that include glsl/draw/lights/lamps.glsl; empty without lights.
  [[nodiscard]] const gl::Defines& defines() const { return defines_; }
  /// Returns the defines of programs that include glsl/draw/lights/lamp_list.glsl for the lamps with
  /// shadows.
  [[nodiscard]] const gl::Defines& shadowDefines() const { return shadowDefines_; }

 private:
  void updateGlows(double seconds);

  const scene::Scene& scene_;
  bool exact_;
  LampOrder order_;
  gl::Defines defines_, shadowDefines_;
  std::vector<shader::Lamp> values_;
  gl::Buffer lamps_;
  gl::Texture lampsView_;
  gl::Buffer cells_;  ///< result of lampCells() for the lamps with a range
  gl::Texture cellsView_;

  scene::Material glowMaterial_;
  std::vector<glm::vec3> glowColors_;
  gl::Buffer glowPlaces_, glowAges_;
  gl::Texture glowPlacesView_, glowAgesView_;
  sim::Instances glows_;
  bool glow_ = false;  ///< true if any lamp glows at any time
};

}  // namespace simreel::draw
