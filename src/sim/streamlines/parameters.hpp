#pragma once
#include "scene/own_colors.hpp"
#include "scene/papered.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/kind.hpp"
#include "sim/flow/speed_range.hpp"
#include "sim/ports/color_scale.hpp"

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Parameters of the object kind "streamlines".
struct StreamlineParameters : ObjectParameters,
                              HasColorRange,
                              ShowsQuantity,
                              ShowsSpeedsOf,
                              scene::HasFieldSkin,
                              scene::HasOwnColors {
  std::string of;                    ///< name of the object whose flow is drawn
  std::optional<double> separation;  ///< distance between lines in metres; if empty, 1/56 of the longer
                                     ///< side
  std::optional<double> length;      ///< maximum length of a line in metres; if empty, 30 separations
  std::optional<double> width;       ///< diameter of a line in metres; if empty, 0.3 separations
  std::optional<int> seed;           ///< seed for the positions of the line seeds; if empty, the scene's
                                     ///< seed
  SpeedRange speeds;                 ///< speeds of the first and the last colour
  std::vector<glm::vec3> colors;     ///< linear RGB stops of the colour map; if empty, the lines have the
                                     ///< object's material
  std::optional<double> height;      ///< distance from the source's plane in metres; if empty, `width`
  bool frames = false;               ///< true since version 2: a camera shows the source's rectangle
  bool sheet = false;                ///< true to draw the source's field behind the lines

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  [[nodiscard]] const char* coloredBy() const override {
    return colors.empty() ? nullptr : "its \"colors\"";
  }
  [[nodiscard]] ShownQuantity shownQuantity() const override { return {"speed", "m/s"}; }
  [[nodiscard]] std::vector<MeasuredRange> measuredRanges() override { return speeds.measured(); }
  [[nodiscard]] const std::string& source() const override { return of; }
  [[nodiscard]] bool framesSource() const override { return frames; }
  [[nodiscard]] std::string fieldShown(const std::string& /*object*/) const override {
    return sheet ? of : "";
  }
};

/// Maximum number of seeds of one object.
inline constexpr int maxSeeds = 8192;
/// Number of points of a line on each side of its seed.
inline constexpr int pointsAside = 40;

}  // namespace simreel::sim
