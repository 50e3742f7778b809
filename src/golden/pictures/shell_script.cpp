#include "golden/pictures/shell_script.hpp"

#include "base/error.hpp"
#include "base/process.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace simreel::golden {

namespace {

/// Copies a command and tracks quotes in the same way as /bin/sh. If the tracking is wrong, a value may be
/// split into several words. The value is not executed, because it comes from a variable.
class Filling {
 public:
  Filling(std::string_view command, const std::vector<Placeholder>& placeholders)
      : command_(command), placeholders_(placeholders) {}

  std::string made() {
    while (at_ < command_.size())
      if (const Placeholder* found = placeholder())
        put(*found);
      else
        copy();
    return std::move(made_);
  }

 private:
  /// Kind of text around the current character: plain, '...', "...", $(...) or `...`.
  enum class Place { plain, single, twice, paren, back };

  [[nodiscard]] Place place() const { return places_.back().place; }

  [[nodiscard]] const Placeholder* placeholder() const {
    const std::string_view rest = command_.substr(at_);
    const auto found =
        std::find_if(placeholders_.begin(), placeholders_.end(), [&](const Placeholder& one) {
          if (!rest.starts_with(one.word)) return false;
          return one.before.empty() ||
                 rest.substr(one.word.size(), 1).find_first_of(one.before) != std::string_view::npos;
        });
    return found == placeholders_.end() ? nullptr : &*found;
  }

  void put(const Placeholder& one) {
    at_ += one.word.size();
    const bool plain = inShellQuotes(one.value) == one.value;
    const std::string variable = "${" + one.variable + "}";
    const bool quoted = place() == Place::single || place() == Place::twice;
    if (plain) {
      made_ += one.value;
    } else if (quoted && !standsAlone()) {
      fail(ExitCode::usage,
           "{} stands for \"{}\", which has characters that the shell inside the quotes {} would "
           "interpret; write \"${}\" there instead of {}, or take it out of the quotes",
           one.word, oneLine(one.value), oneLine(std::string(quotedText())), one.variable, one.word);
    } else {
      made_ += place() == Place::single  ? "'\"" + variable + "\"'"
               : place() == Place::twice ? variable
                                         : "\"" + variable + "\"";
    }
  }

  /// Returns the quoted text around the current position, with its quotes.
  [[nodiscard]] std::string_view quotedText() const {
    const std::size_t begin = places_.back().begin;
    const char mark = command_[begin];
    std::size_t end = at_;
    while (end < command_.size() && command_[end] != mark)
      end += command_[end] == '\\' && mark == '"' ? 2 : 1;
    return command_.substr(begin, end + 1 - begin);
  }

  /// True if the quoted text is a single word, not a script.
  [[nodiscard]] bool standsAlone() const {
    return quotedText().find_first_of(" \t\n;|&<>()`") == std::string_view::npos;
  }

  void copy() {
    const char c = command_[at_];
    const bool quotes = place() == Place::twice;
    if (place() == Place::single) {
      if (c == '\'') places_.pop_back();
    } else if (c == '\\') {
      made_ += c;
      if (++at_ == command_.size()) return;
    } else if (c == '"') {
      quotes ? places_.pop_back() : places_.push_back({Place::twice, at_});
    } else if (c == '`') {
      place() == Place::back ? places_.pop_back() : places_.push_back({Place::back, at_});
    } else if (c == '$' && command_.substr(at_ + 1).starts_with('(')) {
      made_ += c;
      places_.push_back({Place::paren, ++at_});
    } else if (!quotes && c == '\'') {
      places_.push_back({Place::single, at_});
    } else if (!quotes && c == '(') {
      places_.push_back({Place::paren, at_});
    } else if (place() == Place::paren && c == ')') {
      places_.pop_back();
    } else if (!quotes && c == '#' &&
               (at_ == 0 || std::string_view(" \t\n;").find(command_[at_ - 1]) != std::string_view::npos)) {
      const std::size_t end = std::min(command_.find('\n', at_), command_.size());
      made_ += command_.substr(at_, end - at_);
      at_ = end;
      return;
    }
    made_ += command_[at_++];
  }

  struct Opened {
    Place place;
    std::size_t begin;
  };
  std::string_view command_;
  const std::vector<Placeholder>& placeholders_;
  std::size_t at_ = 0;
  std::vector<Opened> places_ = {{Place::plain, 0}};
  std::string made_;
};

}  // namespace

std::string fillIn(const std::string& command, const std::vector<Placeholder>& placeholders) {
  return Filling(command, placeholders).made();
}

}  // namespace simreel::golden
