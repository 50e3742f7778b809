#pragma once
#include "draw/exact/exact_view.hpp"

#include <cstddef>

namespace simreel::draw {

// The kernels that TriangleRaster runs.
inline constexpr const char* trianglesPath = "draw/exact/triangles/triangles.comp";
inline constexpr const char* mediumPath = "draw/exact/triangles/medium.comp";
inline constexpr const char* largePath = "draw/exact/triangles/large.comp";
inline constexpr const char* clipPath = "draw/exact/triangles/clip_large.comp";

inline constexpr std::size_t viewBytes = sizeof(shader::ExactView);

}  // namespace simreel::draw
