#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::scene {

/// Bytes [begin, end) of one source text: 0 is the scene file, others are further files and -D overrides.
struct Place {
  int source = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Collects every mistake of a scene and prints them in the order of their places.
class Diagnostics {
 public:
  /// `text` must outlive this object.
  Diagnostics(std::string file, std::string_view text);

  /// Another text that mistakes may lie in, `path=value` of a -D. Returns its source number.
  int addOverride(std::string argument);
  /// Another file that mistakes may lie in. Returns its source number. `text` must outlive this object.
  int addFile(std::string file, std::string_view text);
  void add(Place place, std::string message);
  /// What is no mistake, but worth a word.
  void remark(Place place, std::string message);
  [[nodiscard]] bool isOverride(int source) const;

  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Whether a mistake lies in a place.
  [[nodiscard]] bool anyWithin(Place place) const;
  /// No more mistakes are kept from here on, only counted; callers may stop looking.
  [[nodiscard]] bool full() const { return errors_.size() >= maxKept; }
  [[nodiscard]] std::string_view textAt(Place place) const;
  /// "file:line:column", or "-D path=value".
  [[nodiscard]] std::string where(Place place) const;

  /// Each mistake as "file:line:column: error: message", the line and a caret; at most 50, then
  /// "and N more". Columns count code points from 1.
  [[nodiscard]] std::string report() const;
  /// Each remark as "file:line:column: warning: message", the line and a caret, in the order of their
  /// places.
  [[nodiscard]] std::vector<std::string> remarks() const;

 private:
  static constexpr std::size_t maxKept = 1000;
  struct Source {
    std::string name;
    std::string owned;      ///< of an override
    std::string_view text;  ///< of a file; empty for an override
    bool isFile;
  };
  struct Error {
    Place place;
    std::string message;
  };
  /// By their places, in the order in which they were found.
  [[nodiscard]] static std::vector<const Error*> inOrder(const std::vector<Error>& found);
  /// Bytes [begin, end) of the line that a place begins in, at byte `at`.
  struct Line {
    std::size_t begin, end, at;
  };
  [[nodiscard]] std::string_view sourceText(int source) const;
  [[nodiscard]] Line lineOf(Place place) const;
  [[nodiscard]] std::string describe(const Error& error, const char* kind) const;

  std::vector<Source> sources_;
  std::vector<Error> errors_, remarks_;
  std::size_t count_ = 0;
};

}  // namespace simreel::scene
