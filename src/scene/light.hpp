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
/// Max number of lights with shadows. For each light with shadows, all shadow casters are drawn six times,
/// once for each of its shadow maps.
inline constexpr std::size_t maxShadowedLights = 8;

/// Range of temperatures in kelvin for which the colour of a black body is defined (draw/black_body.hpp).
inline constexpr Range blackBodyRange{1667, 25000};
/// Declares "temperature", which sets a light's colour in place of "color".
void describeTemperature(Fields& fields, std::optional<double>& temperature);

/// Flicker of a flame's light: smooth noise over time (draw/lights/flicker.hpp).
struct Flicker {
  Animated<float> amount = 0.3F;  ///< fraction of the intensity that varies
  /// Max distance in metres between a flickering light and its mean position.
  Animated<float> sway = 0.0F;
  float rate = 5.0F;  ///< frequency of the flicker in changes per second
  void describe(Fields& fields);
};

/// The cone of a spot light.
struct Spot {
  Animated<glm::vec3> target = glm::vec3(0, 0, 0);  ///< point that the cone's axis points at
  Animated<float> angle = 45.0F;                    ///< full angle of the cone in degrees
  Animated<float> softness = 0.2F;  ///< fraction of the cone angle over which the light fades towards the
                                    ///< edge
  void describe(Fields& fields);
};

/// The rectangle of an area light.
struct Area {
  Animated<glm::vec3> target = glm::vec3(0, 0, 0);  ///< point that the front of the rectangle faces
  Animated<float> width = 1.0F;   ///< length of the rectangle's horizontal sides in metres
  Animated<float> height = 1.0F;  ///< length of the rectangle's other sides in metres
  void describe(Fields& fields);
};

/// Light at a position in the scene. Parameters that only one type uses are in the member named after that
/// type.
struct Light {
  enum class Type { point, spot, area };
  /// Unit of the intensity: luminous intensity, luminous flux, or radiant flux.
  enum class Unit { candela, lumen, watt };
  std::string name;
  Type type = Type::point;
  Spot spot;  ///< parameters of a spot light, used if `type` is spot
  Area area;  ///< parameters of an area light, used if `type` is area
  Animated<glm::vec3> position = glm::vec3(0, 1, 0);
  std::optional<PathPlace> follow;  ///< position on a path, which replaces `position`; the light is off
                                    ///< while the path does not exist
  Animated<glm::vec3> color = glm::vec3(1, 0.72F, 0.42F);  ///< colour of the light, linear RGB
  /// Black-body temperature in kelvin, which sets the colour in place of `color`.
  std::optional<double> temperature;
  Unit unit = Unit::candela;
  Animated<float> intensity = 20.0F;  ///< intensity in `unit`, for the colour (1, 1, 1)
  Animated<float> radius = 0.05F;     ///< radius of the luminous ball in metres
  float range = 0.0F;                 ///< distance in metres beyond which the light has no effect; 0 means
                                      ///< unlimited
  Animated<float> glow = 1.0F;        ///< factor on the brightness of the luminous ball in the picture
  std::optional<Flicker> flicker;
  bool shadow = true;
  int shadowSize = 512;         ///< side of each of the six shadow maps in texels
  float shadowSoftness = 1.5F;  ///< radius of the shadow filter in texels
  void describe(Fields& fields);
};

}  // namespace simreel::scene
