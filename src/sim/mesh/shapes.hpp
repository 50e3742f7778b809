#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// A grid of `vertices` (x fastest, at least 2x2) over size.x by size.z m in the xz plane, facing +y;
/// uv = (x/(W-1), y/(H-1)).
[[nodiscard]] Mesh planeMesh(const glm::vec3& size, glm::ivec2 vertices);

/// A ball of `vertices` along its circles of latitude (the seam twice) and from pole to pole (at least
/// 4x3).
[[nodiscard]] Mesh sphereMesh(float radius, glm::ivec2 vertices);

/// A ball whose vertices, 10 parts^2 + 2 but for seams, lie nearly evenly: an icosahedron, each side cut
/// into `parts`, pushed out. No uv.
[[nodiscard]] Mesh geodesicMesh(float radius, int parts);

/// A sphere cut at its equator, its halves moved apart by `length` along y; 64 columns of 32 rows of quads.
[[nodiscard]] Mesh capsuleMesh(float radius, float length);

/// A ring around y: `radius` to the middle of its tube, `tube` the radius of that; `vertices` along the
/// ring and around the tube, the seams twice (at least 4x4).
[[nodiscard]] Mesh torusMesh(float radius, float tube, glm::ivec2 vertices);

/// Blades of grass, each of four quads and a tip, curved, the tallest `height` m high and `width` m wide at
/// the root, scattered over size.x by size.z m of the xz plane; u is a number of each blade (almost the
/// same across it), v = 1 at the root and 0 at the tip, so that a texture colours blades and shades them.
[[nodiscard]] Mesh grassMesh(const glm::vec3& size, int blades, float height, float width, int seed);

}  // namespace simreel::sim
