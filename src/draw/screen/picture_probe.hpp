#pragma once
#include <string>

namespace simreel::draw {

/// Fingerprint of how the current context draws, 16 hexadecimal digits: hash of every sample of a small
/// picture whose triangles sample what pictures depend on beside arithmetic (sim::probeNumerics): raster
/// edges, clipping, interpolation, filtered reads with mip levels and sRGB, comparison of depths, blending,
/// half floats, encoding. Its shaders are its own (glsl/probe), so that no change of the passes changes it.
/// Two drivers of one fingerprint may still differ in what it does not reach. Nothing of the state depends
/// on it.
[[nodiscard]] std::string probePictures();

}  // namespace simreel::draw
