#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::scene {

/// Byte range [begin, end) in one source text. Source 0 is the scene file. Other sources are further files
/// and -D overrides.
struct Place {
  int source = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// One error of a scene, for programs that use the library.
struct Problem {
  std::string file;          ///< name of the file; empty for an override
  int line = 0, column = 0;  ///< counted from 1, columns in code points; 0 for an override
  std::string path;          ///< dotted path of the value: "objects.flag.cloth.fabric"; empty if unknown
  std::string message;
};

/// Collects all errors of a scene and prints them, sorted by source position.
class Diagnostics {
 public:
  /// `text` must outlive this object.
  Diagnostics(std::string file, std::string_view text);

  /// Adds the text `path=value` of a -D override as a source. Returns its source number.
  int addOverride(std::string argument);
  /// Adds another file as a source. Returns its source number. `text` must outlive this object.
  int addFile(std::string file, std::string_view text);
  void add(Place place, std::string message);
  /// Adds a warning at a place in a source.
  void remark(Place place, std::string message);
  [[nodiscard]] bool isOverride(int source) const;

  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// True if an error begins within `place`, or if further errors are no longer stored.
  [[nodiscard]] bool anyWithin(Place place) const;
  /// True if further errors are only counted, not stored; callers may stop looking for errors.
  [[nodiscard]] bool full() const { return errors_.size() >= maxKept; }
  [[nodiscard]] std::string_view textAt(Place place) const;
  /// Returns "file:line:column", or "-D path=value" for an override.
  [[nodiscard]] std::string where(Place place) const;

  /// Returns all errors as text. Each error is "file:line:column: error: message", the source line and a
  /// caret. Prints at most 50, then "and N more". Columns count code points from 1.
  [[nodiscard]] std::string report() const;
  /// Returns the errors in the order of report(). `pathOf` returns the path of the value at a place.
  [[nodiscard]] std::vector<Problem> problems(const std::function<std::string(Place)>& pathOf) const;
  /// Returns the warnings in the order of their places. Each is "file:line:column: warning: message", the
  /// source line and a caret.
  [[nodiscard]] std::vector<std::string> remarks() const;

 private:
  static constexpr std::size_t maxKept = 1000;
  struct Source {
    std::string name;
    std::string owned;      ///< text of a -D override
    std::string_view text;  ///< text of a file; empty for an override
    bool isFile;
  };
  struct Error {
    Place place;
    std::string message;
  };
  /// Returns the entries sorted by place. Entries at the same place stay in the order in which they were
  /// found.
  [[nodiscard]] static std::vector<const Error*> inOrder(const std::vector<Error>& found);
  /// Byte range of a line, from `begin` to before `end`. `at`: index of the byte in the line at which a
  /// place begins.
  struct Line {
    std::size_t begin, end, at;
  };
  [[nodiscard]] std::string_view sourceText(int source) const;
  [[nodiscard]] Line lineOf(Place place) const;
  /// Line and column, counted from 1. The column counts code points.
  struct Position {
    int line, column;
  };
  [[nodiscard]] Position positionOf(Place place) const;
  [[nodiscard]] std::string describe(const Error& error, const char* kind) const;

  std::vector<Source> sources_;
  std::vector<Error> errors_, remarks_;
  std::size_t count_ = 0;
};

}  // namespace simreel::scene
