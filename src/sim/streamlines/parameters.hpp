#pragma once
#include "scene/papered.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/kind.hpp"

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Parameters of the object kind "streamlines".
struct StreamlineParameters : ObjectParameters, scene::Papered {
  std::string of;                    ///< name of the object whose flow is drawn
  std::optional<double> separation;  ///< distance of lines in metres; nullopt: a 56th of the longer side
  std::optional<double> length;      ///< greatest length of a line in metres; nullopt: 30 separations
  std::optional<double> width;       ///< diameter in metres; nullopt: 0.3 separations
  std::optional<int> seed;           ///< moves the seeds; nullopt: the scene's seed
  double low = 0;                    ///< speed of the first colour in m/s
  std::optional<double> high;        ///< speed of the last colour in m/s; nullopt: the source's greatest
  std::vector<glm::vec3> colors;     ///< linear RGB stops of the colour map; empty: the object's material
  std::optional<double> height;      ///< distance from the source's plane in metres; nullopt: the width
  bool sheet = false;                ///< true: draws the source's field behind the lines

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  [[nodiscard]] std::string fieldShown(const std::string& /*object*/) const override {
    return sheet ? of : "";
  }
};

/// Largest number of seeds of one object.
inline constexpr int mostSeeds = 8192;
/// Points on each side of a seed.
inline constexpr int pointsAside = 40;

}  // namespace simreel::sim
