#pragma once
#include "sim/volume/isosurface.hpp"

#include <functional>

/// CPU twin of marching cubes. It processes one sample after another. It uses the kernels' vertex numbering
/// and triangle order and equals the GPU bit for bit. `value`: function that returns the value of a
/// volume's cell. uvs.x is the colour number of each vertex.
[[nodiscard]] simreel::sim::MeshTable isosurfaceTwin(const simreel::sim::IsosurfaceShape& shape,
                                                     float level,
                                                     const std::function<float(int, int, int)>& value,
                                                     const std::function<float(int, int, int)>& tint,
                                                     glm::vec2 range);

/// CPU twin of the surface that shows cells as cubes. The parameters are the same as for isosurfaceTwin().
[[nodiscard]] simreel::sim::MeshTable cubesTwin(const simreel::sim::IsosurfaceShape& shape, float level,
                                                const std::function<float(int, int, int)>& value,
                                                const std::function<float(int, int, int)>& tint,
                                                glm::vec2 range);
