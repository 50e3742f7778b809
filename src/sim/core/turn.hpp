#pragma once
#include <glm/vec2.hpp>

namespace simreel::sim {

/// Cosine and sine of an angle in degrees, the same bits on every machine; exact at multiples of 90.
[[nodiscard]] glm::vec2 cosineAndSine(float degrees);

}  // namespace simreel::sim
