#pragma once
#include <string>

namespace simreel::draw {

/// Returns a fingerprint of the current context's rasterization, 16 hexadecimal digits. The fingerprint is
/// a hash of all samples of a small picture. The picture's triangles test the driver functions other than
/// arithmetic that pictures depend on: raster edges, clipping, interpolation, filtered reads with mip
/// levels and sRGB, depth comparison, blending, half floats and encoding. sim::probeNumerics tests
/// arithmetic. The shaders (glsl/probe) are separate from the passes' shaders, so changes of the passes do
/// not change the fingerprint. Two drivers with the same fingerprint may still differ in other respects.
/// The result does not depend on the current OpenGL state.
[[nodiscard]] std::string probePictures();

}  // namespace simreel::draw
