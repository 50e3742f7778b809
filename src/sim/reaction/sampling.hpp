#pragma once
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Resamples a field of `sources` cells (x fastest) to a grid of `size` cells that covers the same area, by
/// bilinear interpolation between cell centres, with the same bits as glsl/reaction/sample.comp. Both grids
/// may have up to maxSampledSide cells per side.
[[nodiscard]] std::vector<float> sampledOnGrid(const std::vector<float>& values, glm::ivec2 sources,
                                               glm::ivec2 size);
inline constexpr int maxSampledSide = 32768;

/// Resamples a volume, layer by layer, with trilinear interpolation.
[[nodiscard]] std::vector<float> sampledInVolume(const std::vector<float>& values, glm::ivec3 sources,
                                                 glm::ivec3 size);

/// Samples a field at positions given in units of 1/mapParts of the field's width and height (see
/// mapPlaces).
[[nodiscard]] std::vector<float> sampledAt(const std::vector<float>& values, glm::ivec2 sources,
                                           const std::vector<glm::ivec2>& places);
/// Returns each cell's value, rounded like the samples but without interpolation.
[[nodiscard]] std::vector<float> sampledCells(const std::vector<float>& values);

}  // namespace simreel::sim
