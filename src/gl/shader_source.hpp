#pragma once
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace simreel::gl {

/// A shader file embedded in the program: its path below glsl/, and its text.
struct EmbeddedShader {
  const char* path;
  const char* text;
};
[[nodiscard]] std::span<const EmbeddedShader> embeddedShaders();

/// Preprocessor names and values for a program, for example {"GRID", "1"}.
using Defines = std::vector<std::pair<std::string, std::string>>;
/// Special name in Defines. Its value is a GLSL extension that the shader requires.
inline constexpr const char* extensionDefine = "#extension";

/// The source of one shader for the driver: version line, defines, and the file with its includes.
struct ShaderSource {
  std::string text;
  std::vector<std::string> files;  ///< indexed by source-string number, as in #line

  /// Replaces the source-string numbers in a driver's log ("1:20(5): error", "1(20) : error") by file
  /// names.
  [[nodiscard]] std::string explain(std::string_view log) const;
};

/// Reads the file `path` (below glsl/), adds those `defines` that its files mention, and replaces each
/// `#include "path/below/glsl"` by the file. Only the first compiled copy of a file has an effect. Files
/// are read from $SIMREEL_GLSL if it is set, otherwise from share/simreel/glsl next to the program's folder
/// if it exists, and otherwise from the embedded copies. Throws UserError(device) that names the file, the
/// line and the missing part.
[[nodiscard]] ShaderSource loadShader(const std::string& path, const Defines& defines);
/// Does the same as loadShader() for a text called `name` instead of a file below glsl/.
[[nodiscard]] ShaderSource loadShaderText(const std::string& name, const std::string& text,
                                          const Defines& defines);

/// True if `text` contains `name` as a whole word outside // comments.
[[nodiscard]] bool mentions(std::string_view text, std::string_view name);

}  // namespace simreel::gl
