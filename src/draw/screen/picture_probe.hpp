#pragma once
#include <string>

namespace simreel::draw {

/// Returns a fingerprint of the current context's rasterization, 16 hexadecimal digits: a hash of all
/// samples of a small picture. Its triangles cover what pictures depend on besides arithmetic
/// (sim::probeNumerics): raster edges, clipping, interpolation, filtered reads with mip levels and sRGB,
/// depth comparison, blending, half floats, encoding. It uses separate shaders (glsl/probe), so changes of
/// the passes do not change the fingerprint. Two drivers with the same fingerprint may still differ in
/// other respects. Independent of the current OpenGL state.
[[nodiscard]] std::string probePictures();

}  // namespace simreel::draw
