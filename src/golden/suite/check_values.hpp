#pragma once
#include "frame/image.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include <glm/vec4.hpp>

namespace simreel::golden {

enum class Statistic { mean, min, max, sum };
/// One component of an element, or the length of its xyz.
enum class Component { x, y, z, w, length };

/// "x", "y", "z", "w" or "length"; nothing for another word.
[[nodiscard]] std::optional<Component> componentOf(std::string_view word);
/// Over all elements, in their order and in double. NaN when a value is NaN or there is none (a sum of none
/// is 0).
[[nodiscard]] double statistic(Statistic which, Component component, std::span<const glm::vec4> items);

/// Infinities and NaN of an array, told by their bits.
struct NotFinite {
  std::size_t count = 0;    ///< components
  std::size_t element = 0;  ///< of the first
  int component = 0;        ///< of the first, 0 to 3
};
[[nodiscard]] NotFinite findNotFinite(std::span<const glm::vec4> items);

/// How much there is to see in a picture.
struct Contrast {
  bool oneColour = true;
  double lumaDeviation = 0;  ///< standard deviation of Y' = 0.2126 R' + 0.7152 G' + 0.0722 B', 0 to 0.5
};
/// Alpha does not count.
[[nodiscard]] Contrast contrastOf(const frame::Image& image);

}  // namespace simreel::golden
