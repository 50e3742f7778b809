#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace simreel::kernels {

/// A word, number, string or operator of HLSL. Assignment operators, "++" and "--" are single tokens.
struct Token {
  std::string_view text;
  std::size_t at = 0;
  int depth = 0;  ///< number of enclosing braces; Unity's CBUFFER_START and CBUFFER_END count as braces
  bool directive = false;  ///< true for a token of a preprocessor line

  [[nodiscard]] std::size_t end() const { return at + text.size(); }
  [[nodiscard]] bool isWord() const;
};

/// Splits a text without comments into tokens. All branches of an "#if" start at the same depth.
[[nodiscard]] std::vector<Token> tokens(std::string_view code);

/// A name in a declaration.
struct Declarator {
  std::string_view name;
  std::string_view lengths;  ///< array lengths in the source, such as "[3][2]"; empty if the variable is
                             ///< not an array
  std::size_t at = 0;
};

/// A declaration of one or more variables outside functions, structs and constant buffers.
struct Declaration {
  std::string_view type;  ///< type in the source: "float4" or "Texture2D<float>"
  bool shared = false;    ///< true if the declaration has groupshared
  bool constant = false;  ///< true if the declaration has const or static
  std::vector<Declarator> names;
  std::size_t end = 0;  ///< position after the semicolon
};

/// Returns the global variables of a text. `tokens`: tokens of the text.
[[nodiscard]] std::vector<Declaration> globals(std::string_view code, const std::vector<Token>& tokens);

/// A list of replacements in a text. They are applied from the last to the first, so that positions stay
/// valid.
class Edits {
 public:
  void replace(std::size_t begin, std::size_t end, std::string with);
  void insert(std::size_t at, std::string with) { replace(at, at, std::move(with)); }
  void add(const Edits& more) { edits_.insert(edits_.end(), more.edits_.begin(), more.edits_.end()); }
  [[nodiscard]] bool empty() const { return edits_.empty(); }
  /// Returns the text with all edits applied. Newlines in replaced ranges are kept.
  [[nodiscard]] std::string applied(std::string text) const;

 private:
  struct Edit {
    std::size_t begin, end;
    std::string with;
  };
  std::vector<Edit> edits_;
};

}  // namespace simreel::kernels
