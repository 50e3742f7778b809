#pragma once
#include "scene/value/animated.hpp"
#include "scene/value/fields.hpp"

#include <optional>

#include <glm/vec3.hpp>

namespace simreel::scene {

/// Air that dims the light of distant things and adds its own (glsl/draw/exact/haze.glsl).
struct Haze {
  Animated<float> distance = 200.0F;  ///< length in metres of a way at the ground's height that lets 1/e of
                                      ///< the light through
  /// Colour of dense haze, linear RGB. nullopt: the sky's colour in the direction of the view, above the
  /// horizon.
  std::optional<Animated<glm::vec3>> color;
  /// Height in metres over which the haze thins to 1/e. nullopt: the haze is equally dense everywhere.
  std::optional<double> height;
  float start = 0.0F;  ///< radius in metres of the clear air around the camera
  void describe(Fields& fields);
};

}  // namespace simreel::scene
