#include "kernels/source/tokens.hpp"

#include "kernels/source/plain.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace simreel::kernels {

namespace {

bool among(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Returns the end of a preprocessor line: the next newline that does not follow a backslash.
std::size_t directiveEnd(std::string_view code, std::size_t at) {
  for (; at < code.size(); ++at)
    if (code[at] == '\n' && code[at - 1] != '\\') return at;
  return code.size();
}

std::size_t tokenLength(std::string_view code, std::size_t at) {
  static constexpr std::array<std::string_view, 19> operators = {
      "<<=", ">>=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=",
      "==",  "!=",  "<=", ">=", "++", "--", "&&", "||", "::"};
  if (code[at] == '"') {
    const std::size_t end = code.find_first_of("\"\n", at + 1);
    return std::min(end, code.size() - 1) + 1 - at;
  }
  std::size_t end = at;
  while (end < code.size() && partOfName(code[end])) ++end;
  if (end > at) return end - at;
  for (const std::string_view one : operators)
    if (code.substr(at, one.size()) == one) return one.size();
  return 1;
}

/// Tracks the depth of braces across "#if", "#else" and "#endif".
class Depth {
 public:
  void pass(const Token& token) {
    if (token.text == "{" || token.text == "CBUFFER_START") ++now;
    if (token.text == "}" || token.text == "CBUFFER_END") now = std::max(0, now - 1);
  }
  void branch(std::string_view word) {
    if (word.starts_with("if")) atBranches_.push_back(now);
    if (atBranches_.empty()) return;
    if (word.starts_with("el")) now = atBranches_.back();
    if (word == "endif") atBranches_.pop_back();
  }
  int now = 0;

 private:
  std::vector<int> atBranches_;
};

/// Parses global declarations from tokens.
class Reader {
 public:
  Reader(std::string_view code, const std::vector<Token>& all) : code_(code), all_(all) {}

  /// Returns false if token `i` does not start a variable declaration.
  bool read(std::size_t i, Declaration& found) {
    i_ = i;
    for (;; ++i_) {
      if (is("static") || is("const"))
        found.constant = true;
      else if (is("groupshared"))
        found.shared = true;
      else if (!among(text(), {"uniform", "extern", "volatile", "shared", "precise", "row_major",
                               "column_major", "globallycoherent"}))
        break;
    }
    if (!word() || among(text(), {"struct", "cbuffer", "tbuffer", "typedef", "return"})) return false;
    const std::size_t begin = all_[i_].at;
    std::size_t end = all_[i_++].end();
    if (is("<")) {
      if (!pass("<", ">")) return false;
      end = all_[i_ - 1].end();
    }
    found.type = code_.substr(begin, end - begin);
    do {
      if (!declarator(found)) return false;
    } while (is(",") && ++i_ > 0);
    if (!is(";")) return false;
    found.end = all_[i_].end();
    return true;
  }

 private:
  bool declarator(Declaration& found) {
    if (!word()) return false;
    Declarator one{text(), {}, all_[i_].at};
    const std::size_t behind = all_[i_++].end();
    while (is("["))
      if (!pass("[", "]")) return false;
    one.lengths = code_.substr(behind, all_[i_ - 1].end() - behind);
    while (is(":")) {
      ++i_;
      if (!word()) return false;
      ++i_;
      if (is("(") && !pass("(", ")")) return false;
    }
    if (is("="))
      for (++i_; i_ < all_.size() && !is(";") && !is(",");) {
        const bool braces = is("{");
        if (braces || is("(")) {
          if (!pass(braces ? "{" : "(", braces ? "}" : ")")) return false;
        } else {
          ++i_;
        }
      }
    if (!is(";") && !is(",")) return false;
    found.names.push_back(one);
    return true;
  }
  [[nodiscard]] std::string_view text() const { return i_ < all_.size() ? all_[i_].text : ""; }
  [[nodiscard]] bool is(std::string_view what) const { return text() == what; }
  [[nodiscard]] bool word() const { return i_ < all_.size() && all_[i_].isWord(); }
  /// Moves past the matching closing bracket.
  bool pass(std::string_view open, std::string_view close) {
    for (int depth = 0; i_ < all_.size(); ++i_) {
      if (is(open)) ++depth;
      if (is(close) && --depth == 0) {
        ++i_;
        return true;
      }
    }
    return false;
  }

  std::string_view code_;
  const std::vector<Token>& all_;
  std::size_t i_ = 0;
};

}  // namespace

bool Token::isWord() const {
  return partOfName(text.front()) && std::isdigit(static_cast<unsigned char>(text.front())) == 0;
}

std::vector<Token> tokens(std::string_view code) {
  std::vector<Token> found;
  Depth depth;
  std::size_t directive = 0;  // end of the current preprocessor line
  bool first = true;          // true at the first token of a line
  for (std::size_t at = 0; at < code.size();) {
    if (code[at] == '\n') first = true;
    if (std::isspace(static_cast<unsigned char>(code[at])) != 0 || code[at] == '\\') {
      ++at;
      continue;
    }
    if (first && code[at] == '#' && at >= directive) directive = directiveEnd(code, at);
    first = false;
    Token token{code.substr(at, tokenLength(code, at)), at, depth.now, at < directive};
    at = token.end();
    if (!token.directive)
      depth.pass(token);
    else if (!found.empty() && found.back().text == "#")
      depth.branch(token.text);
    found.push_back(token);
  }
  return found;
}

std::vector<Declaration> globals(std::string_view code, const std::vector<Token>& tokens) {
  std::vector<Token> plain;  // tokens without preprocessor lines
  std::vector<bool> begins;
  bool behind = true;
  for (const Token& token : tokens) {
    if (token.directive) {
      behind = true;
      continue;
    }
    plain.push_back(token);
    begins.push_back(behind);
    behind = token.text == ";" || token.text == "}" || token.text == "CBUFFER_END";
  }
  std::vector<Declaration> found;
  Reader reader(code, plain);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    Declaration one;
    if (begins[i] && plain[i].depth == 0 && reader.read(i, one)) found.push_back(std::move(one));
  }
  return found;
}

void Edits::replace(std::size_t begin, std::size_t end, std::string with) {
  edits_.push_back({begin, end, std::move(with)});
}

std::string Edits::applied(std::string text) const {
  std::vector<Edit> sorted = edits_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
  for (auto edit = sorted.rbegin(); edit != sorted.rend(); ++edit) {
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(edit->begin);
    const auto lines = std::count(begin, text.begin() + static_cast<std::ptrdiff_t>(edit->end), '\n') -
                       std::count(edit->with.begin(), edit->with.end(), '\n');
    text.replace(
        edit->begin, edit->end - edit->begin,
        edit->with + std::string(static_cast<std::size_t>(std::max<std::ptrdiff_t>(lines, 0)), '\n'));
  }
  return text;
}

}  // namespace simreel::kernels
