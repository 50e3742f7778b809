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

/// A scene's lights where shaders read them, and the glows by which the camera sees them. A scene without
/// lights costs nothing, and its shaders know nothing of lamps.
class Lamps {
 public:
  /// The scene must outlive it.
  explicit Lamps(const scene::Scene& scene, Rasterizer rasterizer = Rasterizer::driver);

  [[nodiscard]] bool on() const { return !order_.lights.empty(); }
  [[nodiscard]] const LampOrder& order() const { return order_; }
  /// As they were updated last.
  [[nodiscard]] const std::vector<shader::Lamp>& values() const { return values_; }
  /// Brings all of them to `seconds` of scene time and makes them readable by shaders.
  void update(double seconds, const sim::Drawables& drawables);
  /// The drawables with the lamps themselves: discs that add light, (1 - (r/R)^2)^2 of that in the middle,
  /// whose sum towards the camera is the lamp's intensity times its `glow`. Holds until the next update.
  [[nodiscard]] sim::Drawables withGlows(const sim::Drawables& drawables) const;

  /// Defines of programs that include glsl/draw/lights/lamps.glsl; empty without lights.
  [[nodiscard]] const gl::Defines& defines() const { return defines_; }
  /// Of programs that include glsl/draw/lights/lamp_list.glsl for the lamps with shadows.
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
  gl::Buffer cells_;  ///< lampCells() of those that have a range
  gl::Texture cellsView_;

  scene::Material glowMaterial_;
  std::vector<glm::vec3> glowColors_;
  gl::Buffer glowPlaces_, glowAges_;
  gl::Texture glowPlacesView_, glowAgesView_;
  sim::Instances glows_;
  bool glow_ = false;  ///< whether any of them ever does
};

}  // namespace simreel::draw
