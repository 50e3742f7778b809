#pragma once
#include "sim/core/port.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Port of objects that are drawn in the colours of a scale: fields, contours, particles, cloth and points
/// of kernels with "colorBy", and arrows and streamlines with "colors".
struct ColorScale {
  static const PortInfo port;

  std::vector<glm::vec3> colors;  ///< linear RGB: evenly spaced stops, or one colour per category
  glm::vec2 range{0, 1};          ///< values of the first and the last stop
  bool categories = false;        ///< true if a value is the index of a colour
  std::vector<std::pair<int, std::string>> classes;  ///< values and names of the categories to show; empty
                                                     ///< if none is shown
};

/// Interface of simulations whose colours follow a scale that their drawables do not state.
class HasColorScale {
 public:
  virtual ~HasColorScale() = default;
  [[nodiscard]] virtual ColorScale colorScale() const = 0;
};

/// Quantity that a colour scale shows, for the title of a colour bar.
struct ShownQuantity {
  const char* name;       ///< such as "speed"; empty if unknown
  const char* unit = "";  ///< such as "m/s"; empty if the quantity has none
};

/// Interface of the parameters of objects whose colours show a quantity with a name.
class ShowsQuantity {
 public:
  virtual ~ShowsQuantity() = default;
  /// Returns the quantity that the colours of the object itself show.
  [[nodiscard]] virtual ShownQuantity shownQuantity() const = 0;
};

/// Interface of the parameters of objects that know the quantities of their fields OBJECT.PART.
class NamesParts {
 public:
  virtual ~NamesParts() = default;
  /// Returns the quantity of a part. Its name is empty if it is unknown.
  [[nodiscard]] virtual ShownQuantity quantityOf(std::string_view part) const = 0;
};

/// Returns the quantity that the colours of OBJECT or OBJECT.PART show. Its name is empty if it is unknown.
[[nodiscard]] ShownQuantity shownQuantityOf(const Links& links, const std::string& name);

/// Returns the current scale of the field OBJECT or OBJECT.PART, or if there is no such field, of the
/// object OBJECT itself: particles, points, cloth, a contour, arrows or streamlines. Throws
/// UserError(usage) for an object that is not drawn in colours of a scale.
[[nodiscard]] ColorScale colorScaleOf(const Links& links, const std::string& name);

}  // namespace simreel::sim
