#pragma once
#include "draw/exact/exact_view.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

/// Result for each sample, in row order: the depth key and the index of the visible primitive.
struct RasterTwinResult {
  std::vector<std::uint32_t> keys, ids;
};

/// Rasterizes triangles one after the other with the shader files compiled as C++. `indices` contains three
/// indices into `places` (metres) per triangle.
[[nodiscard]] RasterTwinResult rasterTwin(const simreel::shader::ExactView& view, int samples,
                                          bool doubleSided, const std::vector<glm::vec3>& places,
                                          const std::vector<unsigned>& indices);
