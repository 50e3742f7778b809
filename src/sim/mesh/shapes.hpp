#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Returns a grid of `vertices` (x fastest, at least 2x2) over size.x by size.z metres in the xz plane,
/// facing +y; uv = (x/(W-1), y/(H-1)).
[[nodiscard]] Mesh planeMesh(const glm::vec3& size, glm::ivec2 vertices);

/// Returns a sphere with vertices.x vertices around its circles of latitude (the seam counts twice) and
/// vertices.y from pole to pole (at least 4x3).
[[nodiscard]] Mesh sphereMesh(float radius, glm::ivec2 vertices);

/// Returns a sphere with nearly evenly spaced vertices (10 parts^2 + 2, not counting copies at seams): an
/// icosahedron with edges divided into `parts`, projected onto the sphere. Without uv.
[[nodiscard]] Mesh geodesicMesh(float radius, int parts);

/// Returns a sphere cut at its equator, with the halves moved apart by `length` along y; 64 columns and 32
/// rows of quads.
[[nodiscard]] Mesh capsuleMesh(float radius, float length);

/// Returns a torus around the y axis: `radius` is the distance to the centre of the tube, `tube` the tube's
/// radius. `vertices` along the ring and around the tube; seams count twice (at least 4x4).
[[nodiscard]] Mesh torusMesh(float radius, float tube, glm::ivec2 vertices);

/// Returns a box of size.x by size.y by size.z metres around the origin. Each face has four vertices and uv
/// 0 to 1.
[[nodiscard]] Mesh boxMesh(const glm::vec3& size);

/// Returns a closed cylinder along y around the origin, or a cone or frustum if the radii differ; 64
/// columns. The edges of the ends are sharp.
[[nodiscard]] Mesh cylinderMesh(float topRadius, float bottomRadius, float height);

/// Returns a disc in the xz plane that faces +y; 64 columns.
[[nodiscard]] Mesh discMesh(float radius);

/// Returns blades of grass scattered over size.x by size.z metres of the xz plane. Each blade is a curved
/// strip of four quads; the tallest is `height` metres high, and `width` is the width at the root. u is a
/// random number of the blade (nearly constant across it) and v is 1 at the root and 0 at the tip, so that
/// a texture can colour and shade the blades.
[[nodiscard]] Mesh grassMesh(const glm::vec3& size, int blades, float height, float width, int seed);

}  // namespace simreel::sim
