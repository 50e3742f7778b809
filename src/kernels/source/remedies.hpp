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
  /// Constants that the shader assigns to. Each invocation gets a variable of that name, initialised with
  /// the constant's value.
  std::set<std::string, std::less<>> assigned;
  /// Textures and buffers whose member Length is used.
  std::set<std::string, std::less<>> measured;
  /// Lines that redefine a macro, by file.
  std::set<std::pair<std::size_t, int>> redefined;
  /// Functions of HLSL 2021 that are used: "select", "and", "or"; "tex2D" for samplers of Direct3D 9.
  std::set<std::string, std::less<>> functions;
  /// Namespaces that are dissolved: methods of their structs would not find their functions.
  std::set<std::string, std::less<>> dissolved;
  /// Functions of dissolved namespaces whose names get the namespace's name in front, because others have
  /// them too.
  std::set<std::string, std::less<>> prefixed;
  /// Functions with overloads that shorten arguments, and loop variables that outlive their loop.
  std::set<std::string, std::less<>> shortened, outliving;
  /// Objects "ConstantBuffer<T> x" that become blocks with one member, so that they convert to their
  /// struct.
  std::set<std::string, std::less<>> unpacked;
  /// Files whose flat initializers are nested.
  std::set<std::size_t> nested;
  /// Statements that initialize static variables by calls of functions, which glslang does not; files that
  /// were searched for such variables; kernels that begin with the statements.
  std::string starts;
  std::set<std::size_t> searched;
  std::set<std::string, std::less<>> started;
  /// Further changes to the text of files.
  std::map<std::size_t, Edits> edits;

  [[nodiscard]] std::size_t count() const {
    return assigned.size() + measured.size() + redefined.size() + functions.size() + dissolved.size() +
           prefixed.size() + shortened.size() + outliving.size() + nested.size() + started.size() +
           unpacked.size();
  }
};

/// Returns the text of a file with remedies applied. Line numbers do not change.
[[nodiscard]] std::string remedied(const std::string& text, std::size_t file, const Remedies& remedies);

/// Returns the names that a text assigns to, including local variables.
[[nodiscard]] std::set<std::string, std::less<>> assignedNames(const std::vector<Token>& tokens);

/// Returns an HLSL function that returns the size of a texture or the length of a buffer; empty for other
/// types.
[[nodiscard]] std::string lengthFunction(std::string_view type, std::string_view name);

/// Macros for functions that remedies name.
[[nodiscard]] std::string functionMacros(const Remedies& remedies);

}  // namespace simreel::kernels
