#pragma once
#include "scene/value/animated.hpp"
#include "scene/value/fields.hpp"
#include "scene/value/path_place.hpp"

#include <cstddef>
#include <optional>
#include <string>

#include <glm/vec3.hpp>

namespace simreel::scene {

inline constexpr std::size_t maxLights = 256;
/// Each of them draws what casts shadows six times over.
inline constexpr std::size_t maxShadowedLights = 8;

/// K: where a black body's colour is known (draw/black_body.hpp).
inline constexpr Range blackBodyRange{1667, 25000};
/// The colour of a light as a temperature, beside its "color".
void describeTemperature(Fields& fields, std::optional<double>& temperature);

/// A flame's unrest: smooth noise of time (draw/lights/flicker.hpp).
struct Flicker {
  Animated<float> amount = 0.3F;  ///< share of the intensity that comes and goes
  Animated<float> sway = 0.0F;    ///< m that the light moves about
  float rate = 5.0F;              ///< changes a second
  void describe(Fields& fields);
};

/// The cone of a spot light.
struct Spot {
  Animated<glm::vec3> target = glm::vec3(0, 0, 0);  ///< what its middle points at
  Animated<float> angle = 45.0F;                    ///< degrees from edge to edge
  Animated<float> softness = 0.2F;  ///< share of the angle over which it fades towards the edge
  void describe(Fields& fields);
};

/// The rectangle of an area light.
struct Area {
  Animated<glm::vec3> target = glm::vec3(0, 0, 0);  ///< what it faces
  Animated<float> width = 1.0F;                     ///< m, level
  Animated<float> height = 1.0F;                    ///< m
  void describe(Fields& fields);
};

/// A light at a place of the scene. Fields that only one type has go into a group of that type's name.
struct Light {
  enum class Type { point, spot, area };
  /// Of the intensity: luminous intensity, luminous flux, or watts of light.
  enum class Unit { candela, lumen, watt };
  std::string name;
  Type type = Type::point;
  Spot spot;  ///< of that type
  Area area;  ///< the same
  Animated<glm::vec3> position = glm::vec3(0, 1, 0);
  std::optional<PathPlace> follow;  ///< instead of the position; there is no light while there is no path
  Animated<glm::vec3> color = glm::vec3(1, 0.72F, 0.42F);  ///< linear RGB
  std::optional<double> temperature;  ///< K: its colour is that of a black body, instead of `color`
  Unit unit = Unit::candela;
  Animated<float> intensity = 20.0F;  ///< of that unit, for the colour 1
  Animated<float> radius = 0.05F;     ///< m
  float range = 0.0F;                 ///< m: beyond it there is nothing of it; 0: it reaches everywhere
  Animated<float> glow = 1.0F;        ///< factor on the light itself as the camera sees it
  std::optional<Flicker> flicker;
  bool shadow = true;
  int shadowSize = 512;         ///< texels on a side of each of the six maps
  float shadowSoftness = 1.5F;  ///< radius of the filter, texels
  void describe(Fields& fields);
};

}  // namespace simreel::scene
