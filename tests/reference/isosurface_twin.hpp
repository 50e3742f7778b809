#pragma once
#include "sim/volume/isosurface.hpp"

#include <functional>

/// Returns the isosurface of a volume on the CPU, sample by sample. Point numbers, triangle order and all
/// bits equal the kernels'. `value` returns the value of a cell. uvs.x of a vertex is its colour value.
[[nodiscard]] simreel::sim::MeshTable isosurfaceTwin(const simreel::sim::IsosurfaceShape& shape,
                                                     float level,
                                                     const std::function<float(int, int, int)>& value,
                                                     const std::function<float(int, int, int)>& tint,
                                                     glm::vec2 range);

/// Returns the surface of the cells as cubes.
[[nodiscard]] simreel::sim::MeshTable cubesTwin(const simreel::sim::IsosurfaceShape& shape, float level,
                                                const std::function<float(int, int, int)>& value,
                                                const std::function<float(int, int, int)>& tint,
                                                glm::vec2 range);
