#pragma once
#include "scene/papered.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/kind.hpp"

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Port without an outlet: objects that provide FluidWind or MovingPoints.
struct ArrowSource {
  static const PortInfo port;
};

/// Parameters of the object kind "arrows".
struct ArrowParameters : ObjectParameters, scene::Papered {
  enum class Anchor { middle, tail };
  std::string of;                 ///< name of the object whose velocities are drawn
  std::optional<double> spacing;  ///< distance of arrows in metres; nullopt: a 28th of the longer side
  int every = 1;                  ///< draws the arrow of every n-th point
  std::optional<double> length;   ///< longest arrow in metres; nullopt: spacing, or 8 diameters of a point
  std::optional<double> scale;    ///< length in metres of 1 m/s; nullopt: length / high
  double low = 0;                 ///< speed of the first colour in m/s
  std::optional<double> high;     ///< speed of the last colour in m/s; nullopt: the source's greatest
  std::vector<glm::vec3> colors;  ///< linear RGB stops of the colour map; empty: the object's material
  std::optional<Anchor> anchor;   ///< nullopt: middle on a grid, tail at points
  std::optional<double> height;   ///< distance from the source's plane in metres; nullopt: 0.15 length
  bool sheet = false;             ///< true: draws the source's field below the arrows

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  [[nodiscard]] std::string fieldShown(const std::string& /*object*/) const override {
    return sheet ? of : "";
  }
};

/// Largest number of arrows of one object.
inline constexpr int mostArrows = 1 << 16;

}  // namespace simreel::sim
