#pragma once
#include "kernels/source/tokens.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace simreel::kernels {

/// Prefix of a constant that a variable of its name starts from.
inline constexpr std::string_view constantPrefix = "simreel_constant_";

/// Changes to texts of HLSL that glslang refuses and Microsoft's compiler reads. A text that glslang
/// reads stays as it is.
struct Remedies {
  /// Constants that the shader assigns to. Each invocation has a variable of the name, which begins with
  /// the constant's value.
  std::set<std::string, std::less<>> assigned;
  /// Textures and buffers whose member Length is asked for.
  std::set<std::string, std::less<>> measured;
  /// Lines that define a macro again, by file.
  std::set<std::pair<std::size_t, int>> redefined;
  /// Functions of HLSL 2021 that are used: "select", "and", "or"; "tex2D" for samplers of Direct3D 9.
  std::set<std::string, std::less<>> functions;
  /// Namespaces that are dissolved: methods of their structs would not find their functions.
  std::set<std::string, std::less<>> dissolved;

  [[nodiscard]] std::size_t count() const {
    return assigned.size() + measured.size() + redefined.size() + functions.size() + dissolved.size();
  }
};

/// The text of a file with remedies. Lines keep their numbers.
[[nodiscard]] std::string remedied(const std::string& text, std::size_t file, const Remedies& remedies);

/// Names that are assigned to in a text, local ones, too.
[[nodiscard]] std::set<std::string, std::less<>> assignedNames(const std::vector<Token>& tokens);

/// Function of HLSL with the size of a texture or the length of a buffer; empty for other types.
[[nodiscard]] std::string lengthFunction(std::string_view type, std::string_view name);

/// Macros for functions that remedies name.
[[nodiscard]] std::string functionMacros(const Remedies& remedies);

}  // namespace simreel::kernels
