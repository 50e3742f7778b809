#pragma once
#include "sim/volume/isosurface.hpp"

#include <functional>

/// CPU twin of marching cubes, sample by sample, with the kernels' vertex numbering, triangle order and
/// bits. `value` returns the value of a volume's cell. The colour number of each vertex is in uvs.x.
[[nodiscard]] simreel::sim::MeshTable isosurfaceTwin(const simreel::sim::IsosurfaceShape& shape,
                                                     float level,
                                                     const std::function<float(int, int, int)>& value,
                                                     const std::function<float(int, int, int)>& tint,
                                                     glm::vec2 range);

/// CPU twin of the surface that shows cells as cubes; parameters as in isosurfaceTwin().
[[nodiscard]] simreel::sim::MeshTable cubesTwin(const simreel::sim::IsosurfaceShape& shape, float level,
                                                const std::function<float(int, int, int)>& value,
                                                const std::function<float(int, int, int)>& tint,
                                                glm::vec2 range);
