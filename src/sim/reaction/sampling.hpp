#pragma once
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// A field of `sources` cells, x fastest, on a grid of other size that covers the same: bilinear between
/// the middles of its cells, with the bits of glsl/reaction/sample.comp. Both up to maxSampledSide across.
[[nodiscard]] std::vector<float> sampledOnGrid(const std::vector<float>& values, glm::ivec2 sources,
                                               glm::ivec2 size);
inline constexpr int maxSampledSide = 32768;

/// The same in a volume, layer after layer: trilinear.
[[nodiscard]] std::vector<float> sampledInVolume(const std::vector<float>& values, glm::ivec3 sources,
                                                 glm::ivec3 size);

/// The same at places in mapParts of its width and height (mapPlaces).
[[nodiscard]] std::vector<float> sampledAt(const std::vector<float>& values, glm::ivec2 sources,
                                           const std::vector<glm::ivec2>& places);
/// Cell by cell.
[[nodiscard]] std::vector<float> sampledCells(const std::vector<float>& values);

}  // namespace simreel::sim
