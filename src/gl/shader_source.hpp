#pragma once
#include <span>
#include <string>
#include <vector>

namespace simreel::gl {

/// A shader file built into the program: path below glsl/ and text.
struct EmbeddedShader {
  const char* path;
  const char* text;
};
[[nodiscard]] std::span<const EmbeddedShader> embeddedShaders();

}  // namespace simreel::gl
