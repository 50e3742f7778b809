#pragma once
#include "sim/core/simulation.hpp"

#include <vector>

namespace simreel::sim {

/// Adds UVs without distortion: each triangle has the same size in UV space as in world space, with `metre`
/// metres per unit, and the same orientation. Horizontal faces have uv = (x, z) / metre, the outer sides
/// are laid out flat with v downwards, and walls are unrolled along their contour with the arc length as u.
/// A closed contour needs a seam: two duplicated vertices of its first point are appended to the mesh. Runs
/// on the CPU for exported files; drawing uses triplanar texturing instead
/// (glsl/draw/surface/texture.glsl). `next` is the successor of each contour point (ContourLines).
/// `firstPoint` is the index of the first of the four vertices of the first contour point
/// (glsl/contour/vertices.glsl).
void unwrap(MeshTable& mesh, const std::vector<unsigned>& next, unsigned firstPoint, float metre);

}  // namespace simreel::sim
