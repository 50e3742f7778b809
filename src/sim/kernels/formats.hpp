#pragma once
#include <string>
#include <vector>

namespace simreel::sim {

/// Returns OpenGL's number of a texture's format that GLSL names; 0 for other names.
[[nodiscard]] unsigned texelFormat(const std::string& name);
/// Returns the names of all formats.
[[nodiscard]] std::vector<std::string> texelFormatNames();
/// Returns "float", "int" or "uint": the numbers that a texture of this format holds.
[[nodiscard]] std::string texelNumbers(const std::string& format);

}  // namespace simreel::sim
