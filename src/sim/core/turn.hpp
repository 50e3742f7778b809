#pragma once
#include <glm/vec2.hpp>

namespace simreel::sim {

/// Returns cosine and sine of an angle in degrees, with the same bits on every machine; exact at multiples
/// of 90 degrees.
[[nodiscard]] glm::vec2 cosineAndSine(float degrees);

}  // namespace simreel::sim
