#pragma once
#include "frame/image.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include <glm/vec4.hpp>

namespace simreel::golden {

enum class Statistic { mean, min, max, sum };
/// A component of a vec4 element, or the length of its xyz.
enum class Component { x, y, z, w, length };

/// Parses "x", "y", "z", "w" or "length". Returns nothing for other words.
[[nodiscard]] std::optional<Component> componentOf(std::string_view word);
/// Computes a statistic over all elements, in element order and in double precision. The result is NaN if a
/// value is NaN or if there are no elements, except that the sum of no elements is 0.
[[nodiscard]] double statistic(Statistic which, Component component, std::span<const glm::vec4> items);

/// Number of infinities and NaNs in an array and position of the first one. They are detected by their
/// bits.
struct NotFinite {
  std::size_t count = 0;    ///< number of components that are infinite or NaN
  std::size_t element = 0;  ///< element index of the first such component
  int component = 0;        ///< index of the first such component within its element, 0 to 3
};
[[nodiscard]] NotFinite findNotFinite(std::span<const glm::vec4> items);

/// Contrast measures of a picture, used to detect blank pictures.
struct Contrast {
  bool oneColour = true;
  double lumaDeviation = 0;  ///< standard deviation (0 to 0.5) of the luma Y' = 0.2126 R' + 0.7152 G' +
                             ///< 0.0722 B'
};
/// Measures the contrast of a picture. Ignores alpha.
[[nodiscard]] Contrast contrastOf(const frame::Image& image);

}  // namespace simreel::golden
