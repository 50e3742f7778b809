#pragma once
#include "sim/volume/isosurface.hpp"

#include <functional>

/// The surface of a volume's values on the CPU, a sample after the other: the numbers of points and the
/// order of triangles are the kernels', and so are all bits. `value` of a cell of the volume. Its vertices
/// have the number of their colour in uvs.x.
[[nodiscard]] simreel::sim::MeshTable isosurfaceTwin(const simreel::sim::IsosurfaceShape& shape,
                                                     float level,
                                                     const std::function<float(int, int, int)>& value,
                                                     const std::function<float(int, int, int)>& tint,
                                                     glm::vec2 range);

/// The same of cells as cubes.
[[nodiscard]] simreel::sim::MeshTable cubesTwin(const simreel::sim::IsosurfaceShape& shape, float level,
                                                const std::function<float(int, int, int)>& value,
                                                const std::function<float(int, int, int)>& tint,
                                                glm::vec2 range);
