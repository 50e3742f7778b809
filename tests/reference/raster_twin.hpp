#pragma once
#include "draw/exact/exact_view.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

/// What is visible at each sample, in row order: the key of the nearest primitive and its number.
struct RasterTwinResult {
  std::vector<std::uint32_t> keys, ids;
};

/// The rasterizer's shader files as C++, one triangle after the other: `places` (m) by `indices`, in
/// threes.
[[nodiscard]] RasterTwinResult rasterTwin(const simreel::shader::ExactView& view, int samples,
                                          bool doubleSided, const std::vector<glm::vec3>& places,
                                          const std::vector<unsigned>& indices);
