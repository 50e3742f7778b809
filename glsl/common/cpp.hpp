#pragma once
// Lets the shared shader files compile as C++: include this header, open a namespace or struct, then
// include the shader files. The build uses -ffp-contract=off, so every C++ operation rounds like a
// `precise` GLSL operation. In GLSL the following C++ markers expand to nothing (src/gl/shader_source.cpp):
//   FUNCTION vec3 f(vec3 v)       expands to what the including file defines, usually `inline`
//   struct STD140 Name { ... };   starts and ends at multiples of 16 bytes, as in a uniform block
//   float mass DEFAULT(1.0f);     default value of a member if the scene does not set it
#include <bit>
#include <cmath>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#define STD140 alignas(16)
#define DEFAULT(value) = value

namespace simreel::shader {

using glm::abs;
using glm::clamp;
using glm::floor;
using glm::ivec2;
using glm::ivec3;
using glm::ivec4;
using glm::max;
using glm::min;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = std::uint32_t;

#include "glsl/common/bindings.glsl"

inline int floatBitsToInt(float x) {
  return std::bit_cast<int>(x);
}
inline float intBitsToFloat(int x) {
  return std::bit_cast<float>(x);
}

}  // namespace simreel::shader
