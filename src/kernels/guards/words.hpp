#pragma once
#include "kernels/spirv/module.hpp"
#include "kernels/spirv/writing.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace simreel::kernels {

/// A chain of pointers, from its variable on.
struct PointerChain {
  Id variable = 0;
  Words indices;
};

/// Chains of a body, by the id of the pointer; one of a variable itself is empty.
class Chains {
 public:
  void follow(const Instruction& one);
  [[nodiscard]] PointerChain of(Id pointer) const;

 private:
  std::unordered_map<Id, PointerChain> chains_;
};

/// Words of 32 bits in a variable.
class WordsIn {
 public:
  /// `packed`: without gaps, for memory that has no layout.
  WordsIn(Module& module, bool packed) : module_(module), packed_(packed) {}

  struct Access {
    Id type = 0;               ///< of what the pointer leads to
    Id first = 0;              ///< the number of its first word
    Id element = 0;            ///< the index that the user gave to the outermost array; 0 without one
    Id array = 0;              ///< the type of that array; 0 without one
    std::uint32_t member = 0;  ///< of the block, which that array is
    std::uint32_t step = 1;    ///< words from component to component, of a matrix by rows
    std::string what, part;    ///< names of the array and of the member in its element
  };
  Access access(Writing& writing, const PointerChain& chain);

  /// Numbers of the words of an access, from its first, in the order of parts().
  [[nodiscard]] std::vector<std::uint32_t> offsets(const Access& access);
  /// The words of a value.
  void parts(Writing& writing, Id value, Id type, Words& words);
  /// Number of words of a type, with the gaps that its layout has inside.
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
  Matrix last_;  ///< how matrices lie in what the last access leads to
};

}  // namespace simreel::kernels
