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

/// One SPIR-V instruction. `type` and `result` are 0 if the instruction has none.
struct Instruction {
  SpvOp op = SpvOpNop;
  Id type = 0, result = 0;
  Words operands;  ///< words after the type and the result
};

/// A SPIR-V module as lists of instructions, one per section. Passes may add ids. The class supports the
/// output of glslang and SPIRV-Tools and validates only what it needs. Malformed input throws
/// std::runtime_error.
class Module {
 public:
  explicit Module(std::span<const std::uint32_t> words);
  [[nodiscard]] Words words() const;

  std::vector<Instruction> head;         ///< instructions from capabilities to execution modes, names and
                                         ///< strings
  std::vector<Instruction> decorations;  ///< decorations of ids and members
  std::vector<Instruction> globals;  ///< types, constants and variables; line instructions between them are
                                     ///< dropped
  std::vector<Instruction> body;     ///< functions

  [[nodiscard]] Id fresh() { return bound_++; }
  [[nodiscard]] Id bound() const { return bound_; }
  void setBound(Id bound) { bound_ = bound; }

  /// Returns the type of a value or variable, or 0 if it has no type.
  [[nodiscard]] Id typeOf(Id value) const;
  /// Records the type of a value that a pass creates.
  void noteType(Id value, Id type) { types_[value] = type; }
  /// Returns the global instruction that defines an id, or nullptr if the id is defined in a function.
  [[nodiscard]] const Instruction* global(Id id) const;
  /// Returns a type or constant with these operands, and creates it if it does not exist. Must not be used
  /// for structs or arrays.
  Id globalOf(SpvOp op, Id type, const Words& operands);
  /// Appends a type, constant or variable.
  Id addGlobal(SpvOp op, Id type, const Words& operands);
  void decorate(Id id, SpvDecoration what, const Words& values = {});
  /// Returns the value of a 32-bit constant, or nullopt if the id is not a 32-bit constant.
  [[nodiscard]] std::optional<std::uint32_t> constant(Id id) const;

  Id floatType();
  Id uintType();
  Id intType();
  Id boolType();
  Id vectorType(Id component, std::uint32_t length);
  Id uintConstant(std::uint32_t value);
  /// Returns the id of the GLSL.std.450 import. If there is no import, adds one if `make` is true, and
  /// otherwise returns 0.
  Id extendedSet(bool make = true);

  /// Returns the OpName of an id, or an empty text if the id has no OpName.
  [[nodiscard]] std::string name(Id id) const;
  [[nodiscard]] std::string memberName(Id type, std::uint32_t member) const;
  /// Returns the text of an OpString.
  [[nodiscard]] std::string text(Id id) const;
  /// Returns the first literal of a decoration of an id or member, or 0 if the decoration has no literals.
  /// Returns nullopt if the id or member lacks the decoration.
  [[nodiscard]] std::optional<std::uint32_t> decoration(Id id, SpvDecoration what) const;
  [[nodiscard]] std::optional<std::uint32_t> memberDecoration(Id type, std::uint32_t member,
                                                              SpvDecoration what) const;

  /// Returns glslang's mangled parameter type: "f1", "vf3", "mf43" (columns, rows), "i1", "vu2" or "b1".
  /// Returns "?" for other types.
  [[nodiscard]] std::string signature(Id type) const;
  /// Rebuilds all lookup tables after a pass has moved instructions.
  void index();

 private:
  Id bound_ = 1;
  std::uint32_t version_ = 0, generator_ = 0;
  std::unordered_map<Id, std::size_t> definitions_;  ///< index in `globals` by id
  std::unordered_map<Id, Id> types_;
  std::map<std::pair<std::uint32_t, Words>, Id> known_;  ///< ids of types and constants by opcode and
                                                         ///< operands
};

/// Returns true if operand `at` of an instruction is an id. Other operands are literals.
[[nodiscard]] bool isId(const Instruction& instruction, std::size_t at);

/// Returns the string literal that starts in the first of the words.
[[nodiscard]] std::string literalText(std::span<const std::uint32_t> words);
/// Encodes a text as words with a terminating zero byte.
[[nodiscard]] Words textWords(const std::string& text);

}  // namespace simreel::kernels
