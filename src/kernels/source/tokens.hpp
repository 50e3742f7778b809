#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace simreel::kernels {

/// A word, number, string or operator of HLSL. Operators that assign are one token, as are "++" and "--".
struct Token {
  std::string_view text;
  std::size_t at = 0;
  int depth = 0;           ///< of braces around it; Unity's CBUFFER_START and CBUFFER_END are braces, too
  bool directive = false;  ///< in a line of the preprocessor

  [[nodiscard]] std::size_t end() const { return at + text.size(); }
  [[nodiscard]] bool isWord() const;
};

/// The tokens of a text without comments. The branches of "#if" begin at the same depth.
[[nodiscard]] std::vector<Token> tokens(std::string_view code);

/// A name that a declaration makes.
struct Declarator {
  std::string_view name;
  std::string_view lengths;  ///< "[3][2]", empty without
  std::size_t at = 0;
};

/// A variable or several of one type, outside of functions, structs and constant buffers.
struct Declaration {
  std::string_view type;  ///< "float4", "Texture2D<float>"
  bool shared = false;    ///< among a group's threads
  bool constant = false;  ///< const or static
  std::vector<Declarator> names;
  std::size_t end = 0;  ///< behind the semicolon
};

/// The global variables of a text, which the tokens are of.
[[nodiscard]] std::vector<Declaration> globals(std::string_view code, const std::vector<Token>& tokens);

/// Replacements in a text. They are made from the back, so that places stay right.
class Edits {
 public:
  void replace(std::size_t begin, std::size_t end, std::string with);
  void insert(std::size_t at, std::string with) { replace(at, at, std::move(with)); }
  void add(const Edits& more) { edits_.insert(edits_.end(), more.edits_.begin(), more.edits_.end()); }
  /// With the edits; line ends in what is replaced stay.
  [[nodiscard]] std::string applied(std::string text) const;

 private:
  struct Edit {
    std::size_t begin, end;
    std::string with;
  };
  std::vector<Edit> edits_;
};

}  // namespace simreel::kernels
