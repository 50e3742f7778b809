#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <spirv.h>
#include <string>
#include <unordered_map>
#include <vector>

namespace simreel::kernels {

using Id = std::uint32_t;
using Words = std::vector<std::uint32_t>;

/// One instruction of SPIR-V; `type` and `result` are 0 where it has none.
struct Instruction {
  SpvOp op = SpvOpNop;
  Id type = 0, result = 0;
  Words operands;  ///< after type and result
};

/// A module of SPIR-V as instructions by section, with ids that passes may add to. It holds what glslang
/// and SPIRV-Tools write, and checks no more than it needs: malformed words throw std::runtime_error.
class Module {
 public:
  explicit Module(std::span<const std::uint32_t> words);
  [[nodiscard]] Words words() const;

  std::vector<Instruction> head;         ///< capabilities to modes of execution, names, texts
  std::vector<Instruction> decorations;  ///< of ids and of members
  std::vector<Instruction> globals;      ///< types, constants, variables; lines among them are dropped
  std::vector<Instruction> body;         ///< functions

  [[nodiscard]] Id fresh() { return bound_++; }
  [[nodiscard]] Id bound() const { return bound_; }
  void setBound(Id bound) { bound_ = bound; }

  /// The type of a value or variable; 0 for what has none.
  [[nodiscard]] Id typeOf(Id value) const;
  /// Notes the type of a value that a pass makes.
  void noteType(Id value, Id type) { types_[value] = type; }
  /// The instruction among the globals that makes an id; nullptr for one of a function.
  [[nodiscard]] const Instruction* global(Id id) const;
  /// A type or constant with these operands, made where there is none. Not for structs or arrays.
  Id globalOf(SpvOp op, Id type, const Words& operands);
  /// Appends a type, constant or variable.
  Id addGlobal(SpvOp op, Id type, const Words& operands);
  void decorate(Id id, SpvDecoration what, const Words& values = {});
  /// The value of a constant of 32 bits.
  [[nodiscard]] std::optional<std::uint32_t> constant(Id id) const;

  Id floatType();
  Id uintType();
  Id intType();
  Id boolType();
  Id vectorType(Id component, std::uint32_t length);
  Id uintConstant(std::uint32_t value);
  /// The set of instructions GLSL.std.450, imported where it is not; 0 where not and `make` is false.
  Id extendedSet(bool make = true);

  /// The name that OpName gives, or nothing.
  [[nodiscard]] std::string name(Id id) const;
  [[nodiscard]] std::string memberName(Id type, std::uint32_t member) const;
  /// The text of an OpString.
  [[nodiscard]] std::string text(Id id) const;
  /// The first value of a decoration of an id or of a member, 0 where it has none; nothing without it.
  [[nodiscard]] std::optional<std::uint32_t> decoration(Id id, SpvDecoration what) const;
  [[nodiscard]] std::optional<std::uint32_t> memberDecoration(Id type, std::uint32_t member,
                                                              SpvDecoration what) const;

  /// "f1", "vf3", "mf43" (columns, rows), "i1", "vu2", "b1": as glslang mangles parameters. Other types:
  /// "?".
  [[nodiscard]] std::string signature(Id type) const;
  /// Reads everything again after a pass that moved instructions.
  void index();

 private:
  Id bound_ = 1;
  std::uint32_t version_ = 0, generator_ = 0;
  std::unordered_map<Id, std::size_t> made_;  ///< an id's place in globals
  std::unordered_map<Id, Id> types_;
  std::map<std::pair<std::uint32_t, Words>, Id> known_;  ///< types and constants that can be shared
};

/// True if operand `at` of an instruction is an id; the others are literals.
[[nodiscard]] bool isId(const Instruction& instruction, std::size_t at);

/// The characters of a literal text that begins at a word.
[[nodiscard]] std::string literalText(std::span<const std::uint32_t> words);
/// A text as words, ended by a zero byte.
[[nodiscard]] Words textWords(const std::string& text);

}  // namespace simreel::kernels
