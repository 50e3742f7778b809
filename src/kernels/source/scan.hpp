#pragma once
#include "kernels/source/files.hpp"
#include "kernels/source/tokens.hpp"

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace simreel::kernels {

/// A file's text without comments, its tokens, and its global variables.
struct Scan {
  explicit Scan(const std::string& text)
      : code(withoutComments(text)), all(tokens(code)), declared(globals(code, all)) {}
  ~Scan() = default;
  Scan(const Scan&) = delete;
  Scan& operator=(const Scan&) = delete;

  std::string code;
  std::vector<Token> all;
  std::vector<Declaration> declared;
};

/// Scans all files of a shader that were read.
[[nodiscard]] std::deque<Scan> scans(const Files& files);

/// Returns the index of the bracket that closes the bracket `open`, "(", "[" or "{"; the token count if
/// none does.
[[nodiscard]] std::size_t closingBracket(const std::vector<Token>& all, std::size_t open);

/// Splits the tokens from `begin` to `end` at commas outside brackets; each part is a pair of indices.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> parts(const std::vector<Token>& all,
                                                                     std::size_t begin, std::size_t end);

/// Returns the position behind the "{" of a function's definition; 0 if the text does not define it.
[[nodiscard]] std::size_t bodyOf(const Scan& scan, std::string_view function);

/// The rows and columns of a numeric HLSL type: float has 1 and 1, float3 has 3 and 1, float3x4 has 3
/// and 4.
struct Numeric {
  int rows = 1, columns = 1;
  bool matrix = false;
  [[nodiscard]] int count() const { return rows * columns; }
};

/// Returns nothing for a type that is not numeric.
[[nodiscard]] std::optional<Numeric> numeric(std::string_view type);

/// Returns the value of a whole number, or of a macro or constant that is one.
[[nodiscard]] std::optional<int> wholeNumber(std::string_view word, const std::deque<Scan>& all);

}  // namespace simreel::kernels
