#pragma once
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace simreel::gl {

/// A shader file built into the program: path below glsl/ and text.
struct EmbeddedShader {
  const char* path;
  const char* text;
};
[[nodiscard]] std::span<const EmbeddedShader> embeddedShaders();

/// Preprocessor names given to a program, for example {"GRID", "1"}.
using Defines = std::vector<std::pair<std::string, std::string>>;
/// In place of a name: the value is an extension that the program needs.
inline constexpr const char* extensionDefine = "#extension";

/// One shader ready for the driver: version line, defines, and the file with its includes.
struct ShaderSource {
  std::string text;
  std::vector<std::string> files;  ///< by source-string number, as #line uses them

  /// Replaces the source-string numbers in a driver's log ("1:20(5): error", "1(20) : error") by file
  /// names.
  [[nodiscard]] std::string explain(std::string_view log) const;
};

/// Reads `path` (below glsl/), defines what its files mention of `defines`, and pastes each `#include
/// "path/below/glsl"` in: a file counts once, where it is compiled first. Files come from $SIMREEL_GLSL,
/// else share/simreel/glsl beside the program's folder, else the copies built in. Throws UserError(device)
/// naming the file, line and what is missing.
[[nodiscard]] ShaderSource loadShader(const std::string& path, const Defines& defines);
/// The same of a text that is no file below glsl/, called `name`.
[[nodiscard]] ShaderSource loadShaderText(const std::string& name, const std::string& text,
                                          const Defines& defines);

/// True where `name` stands in `text` as a word, outside comments that end a line.
[[nodiscard]] bool mentions(std::string_view text, std::string_view name);

}  // namespace simreel::gl
