#pragma once
#include "draw/exact/exact_view.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

/// The nearest primitive at each sample, in row order: its depth key and its number.
struct RasterTwinResult {
  std::vector<std::uint32_t> keys, ids;
};

/// Rasterizes triangles with the rasterizer's shader files as C++, one after another. `indices` are three
/// per triangle, into `places` (m).
[[nodiscard]] RasterTwinResult rasterTwin(const simreel::shader::ExactView& view, int samples,
                                          bool doubleSided, const std::vector<glm::vec3>& places,
                                          const std::vector<unsigned>& indices);
