#pragma once
#include <string>
#include <vector>

namespace simreel::sim {

/// Returns the OpenGL enum of a GLSL texture format name; 0 for other names.
[[nodiscard]] unsigned texelFormat(const std::string& name);
/// Returns the names of all formats.
[[nodiscard]] std::vector<std::string> texelFormatNames();
/// Returns the type of the numbers in a texture of this format: "float", "int" or "uint".
[[nodiscard]] std::string texelNumbers(const std::string& format);

}  // namespace simreel::sim
