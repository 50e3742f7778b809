#pragma once
#include "kernels/source/tokens.hpp"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace simreel::kernels {

/// Prefix of a constant that initialises a variable with the constant's original name.
inline constexpr std::string_view constantPrefix = "simreel_constant_";

/// Changes to HLSL texts that glslang rejects but Microsoft's compiler accepts. A text that glslang accepts
/// stays unchanged.
struct Remedies {
  /// Names of constants that the shader assigns to. Each invocation gets a variable with that name,
  /// initialised with the constant's value.
  std::set<std::string, std::less<>> assigned;
  /// Names of textures and buffers whose member `Length` is used.
  std::set<std::string, std::less<>> measured;
  /// Lines that redefine a macro, each as the index of the file and the line number.
  std::set<std::pair<std::size_t, int>> redefined;
  /// Names of used functions from newer or older versions of HLSL: "select", "and" and "or" of HLSL 2021;
  /// "tex2D" for samplers of Direct3D 9.
  std::set<std::string, std::less<>> functions;
  /// Names of namespaces that are removed, because in glslang methods of their structs would not find the
  /// namespace's functions.
  std::set<std::string, std::less<>> dissolved;
  /// Functions of removed namespaces that get the namespace's name as a prefix, because functions elsewhere
  /// have the same name.
  std::set<std::string, std::less<>> prefixed;
  /// `shortened` holds functions that get overloads which truncate arguments. `loopVariables` holds loop
  /// variables that are used after their loop.
  std::set<std::string, std::less<>> shortened, loopVariables;
  /// Objects "ConstantBuffer<T> x" that become blocks with one member, so that they convert to their
  /// struct.
  std::set<std::string, std::less<>> unpacked;
  /// Files whose flat initializer lists get nested braces.
  std::set<std::size_t> nested;
  /// Initializers of static variables that call functions, which glslang does not support. `starts`:
  /// statements that replace the initializers. `searched`: indices of the files that were searched for
  /// them. `started`: kernels that begin with the statements.
  std::string starts;
  std::set<std::size_t> searched;
  std::set<std::string, std::less<>> started;
  /// Further changes to the texts of files, by index of the file.
  std::map<std::size_t, Edits> edits;

  [[nodiscard]] std::size_t count() const {
    return assigned.size() + measured.size() + redefined.size() + functions.size() + dissolved.size() +
           prefixed.size() + shortened.size() + loopVariables.size() + nested.size() + started.size() +
           unpacked.size();
  }
};

/// Returns the text of a file with the remedies applied. Line numbers do not change.
[[nodiscard]] std::string remedied(const std::string& text, std::size_t file, const Remedies& remedies);

/// Returns the names that a text assigns to, including local variables.
[[nodiscard]] std::set<std::string, std::less<>> assignedNames(const std::vector<Token>& tokens);

/// Returns the text of an HLSL function that returns the size of a texture or the length of a buffer.
/// Returns an empty string for other types.
[[nodiscard]] std::string lengthFunction(std::string_view type, std::string_view name);

/// Returns the macros for Remedies::functions.
[[nodiscard]] std::string functionMacros(const Remedies& remedies);

}  // namespace simreel::kernels
