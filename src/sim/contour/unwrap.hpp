#pragma once
#include "sim/core/simulation.hpp"

#include <vector>

namespace simreel::sim {

/// Gives a solid uvs that stretch nowhere: every triangle is as large in uv as it is in space, `metre` a
/// unit, and is seen the same way around. Faces have uv = (x, z) / metre, the outer sides are laid flat,
/// v downwards, and walls are unrolled along their contour, u by its length. A closed contour needs a seam:
/// its first point gets two more vertices, at the end of the mesh. On the CPU, for files: what is drawn
/// takes textures from three sides (glsl/draw/surface/texture.glsl).
/// `next`: of each point of the contours (ContourLines); `firstPoint`: number of the first point's first
/// vertex, of four (glsl/contour/vertices.glsl).
void unwrap(MeshTable& mesh, const std::vector<unsigned>& next, unsigned firstPoint, float metre);

}  // namespace simreel::sim
