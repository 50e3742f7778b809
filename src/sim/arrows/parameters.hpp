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

/// Port of objects that provide FluidWind or MovingPoints. Users of this port access those two interfaces
/// directly.
struct ArrowSource {
  static const PortInfo port;
};

/// Parameters of the object kind "arrows".
struct ArrowParameters : ObjectParameters,
                         HasColorRange,
                         ShowsQuantity,
                         ShowsSpeedsOf,
                         scene::HasFieldSkin,
                         scene::HasOwnColors {
  enum class Anchor { middle, tail };
  std::string of;                 ///< name of the object whose velocities are drawn
  std::optional<double> spacing;  ///< distance between arrows in metres; if empty, 1/28 of the longer side
  int every = 1;                  ///< step between points that get an arrow: 1 for every point, n for every
                                  ///< n-th point
  std::optional<double> length;   ///< maximum length of an arrow in metres; if empty, the spacing on a
                                  ///< grid, or 8 point diameters at points
  std::optional<double> scale;    ///< length of an arrow in metres per m/s; if empty, `length` divided by
                                  ///< `high`
  SpeedRange speeds;              ///< speeds of the first and the last colour
  std::vector<glm::vec3> colors;  ///< linear RGB stops of the colour map; if empty, the arrows have the
                                  ///< object's material
  std::optional<Anchor> anchor;   ///< part of the arrow that is at the sample point; if empty, the middle
                                  ///< on a grid and the tail at points
  std::optional<double> height;   ///< distance from the source's plane in metres; if empty, 0.15 times
                                  ///< `length`
  bool widens = false;  ///< true since version 2: the default length at points is multiplied by the
                        ///< square root of `every`, because the distances of the arrows in a picture
                        ///< grow by this factor
  bool frames = false;  ///< true since version 2: a camera shows the source's rectangle
  bool sheet = false;   ///< true to draw the source's field below the arrows

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  /// Returns the maximum length of arrows at points of this diameter, in metres.
  [[nodiscard]] float lengthAt(float diameter) const;
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

/// Maximum number of arrows of one object.
inline constexpr int maxArrows = 1 << 16;

}  // namespace simreel::sim
