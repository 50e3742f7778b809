#pragma once
#include "kernels/spirv/module.hpp"
#include "kernels/spirv/writing.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace simreel::kernels {

/// A flattened access chain: a variable and the indices of all nested chains.
struct PointerChain {
  Id variable = 0;
  Words indices;
};

/// The access chains of a body, by the id of the resulting pointer. A plain variable has a chain without
/// indices.
class Chains {
 public:
  void follow(const Instruction& one);
  [[nodiscard]] PointerChain of(Id pointer) const;

 private:
  std::unordered_map<Id, PointerChain> chains_;
};

/// Maps the values in a variable to 32-bit words.
class WordsIn {
 public:
  /// If `packed` is true, padding is left out, for memory without an explicit layout.
  WordsIn(Module& module, bool packed) : module_(module), packed_(packed) {}

  struct Access {
    Id type = 0;               ///< type that the pointer points to
    Id first = 0;              ///< id of the word index at which the access begins
    Id element = 0;            ///< id of the user's index into the outermost array; 0 if there is no array
    Id array = 0;              ///< type of the outermost array; 0 if there is no array
    std::uint32_t member = 0;  ///< index of the block member that is the outermost array
    std::uint32_t step = 1;    ///< distance in words between consecutive components; more than 1 for
                               ///< row-major matrices
    std::string what, part;    ///< names of the array and of the element's member, for messages
  };
  Access access(Writing& writing, const PointerChain& chain);

  /// Returns the word offsets of an access's components relative to its first word, in the order of
  /// parts().
  [[nodiscard]] std::vector<std::uint32_t> offsets(const Access& access);
  /// Splits a value into its words.
  void parts(Writing& writing, Id value, Id type, Words& words);
  /// Returns the number of words of a type, including the padding of its layout.
  [[nodiscard]] std::uint32_t size(Id type);

 private:
  struct Matrix {
    bool byRows = false;
    std::uint32_t stride = 4;
  };
  [[nodiscard]] std::uint32_t stride(Id array);
  [[nodiscard]] std::uint32_t offset(Id structure, std::uint32_t member);
  [[nodiscard]] Matrix matrix(Id structure, std::uint32_t member) const;
  void walk(Id type, std::uint32_t at, std::uint32_t step, const Matrix& matrix,
            std::vector<std::uint32_t>& found);
  [[nodiscard]] const Instruction& made(Id type) const { return *module_.global(type); }

  Module& module_;
  bool packed_;
  Matrix last_;  ///< matrix layout of the memory that the last access addressed
};

}  // namespace simreel::kernels
