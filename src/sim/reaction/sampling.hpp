#pragma once
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// A field of `sources` cells, x fastest, on a grid of other size that covers the same: bilinear between
/// the middles of its cells, with the bits of glsl/reaction/sample.comp. Both up to maxSampledSide across.
[[nodiscard]] std::vector<float> sampledOnGrid(const std::vector<float>& values, glm::ivec2 sources,
                                               glm::ivec2 size);
inline constexpr int maxSampledSide = 32768;

}  // namespace simreel::sim
