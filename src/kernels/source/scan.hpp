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

/// Scans all files that have been read for a shader.
[[nodiscard]] std::deque<Scan> scans(const Files& files);

/// Returns the index of the bracket that matches the opening bracket "(", "[" or "{" at token `open`.
/// Returns the number of tokens if there is no such bracket.
[[nodiscard]] std::size_t closingBracket(const std::vector<Token>& all, std::size_t open);

/// Splits the tokens from `begin` to `end` at commas outside brackets. Each part is a pair of token
/// indices: the first token, and the token after the last one.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> parts(const std::vector<Token>& all,
                                                                     std::size_t begin, std::size_t end);

/// Returns the position after the "{" of a function's definition. Returns 0 if the text does not define the
/// function.
[[nodiscard]] std::size_t bodyOf(const Scan& scan, std::string_view function);

/// The rows and columns of a numeric HLSL type: float has 1 and 1, float3 has 3 and 1, float3x4 has 3
/// and 4.
struct Numeric {
  int rows = 1, columns = 1;
  bool matrix = false;
  [[nodiscard]] int count() const { return rows * columns; }
};

/// Returns the size of a numeric type, or nullopt for other types.
[[nodiscard]] std::optional<Numeric> numeric(std::string_view type);

/// Returns the value of an integer literal, or of a macro or constant with such a value.
[[nodiscard]] std::optional<int> wholeNumber(std::string_view word, const std::deque<Scan>& all);

}  // namespace simreel::kernels
