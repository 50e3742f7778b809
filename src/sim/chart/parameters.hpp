#pragma once
#include "scene/picture_area.hpp"
#include "sim/core/kind.hpp"

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Parameters of the object kind "chart": curves over the picture that show quantities of other objects
/// over time.
struct ChartParameters : ObjectParameters, scene::TakesArea {
  struct Curve {
    std::string of;                  ///< name of the quantity, OBJECT.QUANTITY
    std::string label;               ///< name on the chart; if empty, the quantity's name
    double per = 1;                  ///< value of the quantity that is drawn as 1
    std::optional<glm::vec3> color;  ///< colour in linear RGB

    [[nodiscard]] std::string object() const;
    [[nodiscard]] std::string quantity() const;
  };
  static constexpr std::size_t maxCurves = 4;  ///< maximum number of curves that one Chart drawable
                                               ///< supports

  std::vector<Curve> curves;
  std::optional<double> low, high;  ///< values at the bottom and top of the chart; if empty, rounded limits
                                    ///< of the recorded values
  double seconds = 0;               ///< initial length of the time axis in seconds; it grows when needed
  float x = 0.025F, y = 0.67F;      ///< position of the top left corner, as fractions of the picture
  float width = 0.42F, height = 0.3F;

  void describe(scene::Fields& fields) override;
  [[nodiscard]] const char* drawnWith() const override { return "its \"curves\""; }
  void ports(Ports& ports) const override;
  [[nodiscard]] scene::PictureArea area() const override { return {{x, y}, {x + width, y + height}}; }
};

/// Limits of the value axis.
struct ChartRange {
  double low = 0, high = 1;
};
/// Returns a scale around values from `minimum` to `maximum`. Its limits are multiples of a step of 1, 2 or
/// 5 times a power of ten, at most four steps apart. If the values are all equal, the scale extends by half
/// their magnitude on both sides; for zeros it is 0 to 1.
[[nodiscard]] ChartRange roundRange(double minimum, double maximum);

}  // namespace simreel::sim
