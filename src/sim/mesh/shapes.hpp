#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Returns a grid in the xz plane, facing +y, of size.x by size.z metres with `vertices` vertices (x
/// fastest, at least 2x2); uv = (x/(W-1), y/(H-1)) for W by H vertices.
[[nodiscard]] Mesh planeMesh(const glm::vec3& size, glm::ivec2 vertices);

/// Returns a sphere with vertices.x vertices on each circle of latitude, counting the seam twice, and
/// vertices.y vertices from pole to pole. Requires at least 4x3 vertices.
[[nodiscard]] Mesh sphereMesh(float radius, glm::ivec2 vertices);

/// Returns a sphere with nearly evenly spaced vertices: an icosahedron whose edges are divided into
/// `parts`, projected onto the sphere. It has 10 parts^2 + 2 vertices, not counting copies at seams, and no
/// uv.
[[nodiscard]] Mesh geodesicMesh(float radius, int parts);

/// Returns a sphere of 64 columns and 32 rows of quads that is cut at its equator, with the halves moved
/// apart by `length` along y.
[[nodiscard]] Mesh capsuleMesh(float radius, float length);

/// Returns a torus around the y axis: `radius` is the distance from the axis to the centre of the tube,
/// `tube` the radius of the tube. `vertices` are the numbers of vertices along the ring and around the
/// tube, counting seams twice (at least 4x4).
[[nodiscard]] Mesh torusMesh(float radius, float tube, glm::ivec2 vertices);

/// Returns a box of size.x by size.y by size.z metres around the origin. Each face has four vertices with
/// uv from 0 to 1.
[[nodiscard]] Mesh boxMesh(const glm::vec3& size);

/// Returns a closed cylinder along y around the origin with 64 columns of quads; if the radii differ, it is
/// a cone or frustum. The edges of the ends are sharp.
[[nodiscard]] Mesh cylinderMesh(float topRadius, float bottomRadius, float height);

/// Returns a disc in the xz plane that faces +y, with 64 triangles.
[[nodiscard]] Mesh discMesh(float radius);

/// Returns blades of grass scattered over size.x by size.z metres of the xz plane. Each blade is a curved
/// strip of four quads; the tallest is `height` metres high, and `width` is the width at the root. u is a
/// random number of the blade (nearly constant across it) and v is 1 at the root and 0 at the tip, so that
/// a texture can colour and shade the blades.
[[nodiscard]] Mesh grassMesh(const glm::vec3& size, int blades, float height, float width, int seed);

}  // namespace simreel::sim
