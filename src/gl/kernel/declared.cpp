#include "gl/kernel/declared.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace simreel::gl {

namespace {

bool inName(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool isMacro(std::string_view word) {
  return word.size() > 1 && std::ranges::all_of(word, [](char c) {
           return std::isupper(static_cast<unsigned char>(c)) != 0 ||
                  std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '_';
         });
}

/// Parses the statements of a shader outside functions.
class Declarations {
 public:
  std::set<std::string, std::less<>> of(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
      const char c = text[at];
      if (c == '#' || text.substr(at).starts_with("//")) {
        at = lineEnd(text, at);
      } else if (inName(c)) {
        std::size_t end = at;
        while (end < text.size() && inName(text[end])) ++end;
        words_.emplace_back(text.substr(at, end - at));
        at = end;
      } else {
        sign(c);
        ++at;
      }
    }
    return std::move(names_);
  }

 private:
  /// Returns the end of the line that contains `at`, including continuation lines after a backslash.
  static std::size_t lineEnd(std::string_view text, std::size_t at) {
    for (;; ++at) {
      at = text.find('\n', at);
      if (at == std::string_view::npos) return text.size();
      if (text[at - 1] != '\\') return at;
    }
  }

  void sign(char c) {
    if (c == '(') ++round_;
    if (c == ')' && --round_ == 0 && depth_ == 0 && isMacro(words_.front())) collectNames();
    if (c == '{') {
      if (depth_++ == 0 && (block_ = declares())) collectNames();
      words_.clear();
    }
    if (c == '}') --depth_;
    if (c == ';' || c == '}') {
      if (depth_ == 0 ? declares() : depth_ == 1 && block_) collectNames();
      words_.clear();
    }
  }

  [[nodiscard]] bool declares() const {
    return std::ranges::any_of(words_,
                               [](std::string_view word) { return word == "uniform" || word == "buffer"; });
  }

  void collectNames() {
    for (const std::string_view word : words_) names_.emplace(word);
    words_.clear();
  }

  std::set<std::string, std::less<>> names_;
  std::vector<std::string_view> words_;  ///< words of the current statement
  int round_ = 0, depth_ = 0;            ///< number of open round brackets and braces
  bool block_ = false;                   ///< true inside the braces of an interface block
};

}  // namespace

std::set<std::string, std::less<>> declaredNames(std::string_view text) {
  return Declarations().of(text);
}

}  // namespace simreel::gl
