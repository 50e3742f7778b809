#pragma once
#include "kernels/source/remedies.hpp"
#include "scene/json/diagnostics.hpp"

#include <cstddef>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::kernels {

/// Limits on what a shader file may make the reader load.
inline constexpr std::size_t maxFileBytes = std::size_t{2} << 20;
inline constexpr std::size_t maxAllBytes = std::size_t{8} << 20;
inline constexpr std::size_t maxIncludeDepth = 32;

/// A mistake in a user's file: `line` from 1, 0 for the file as a whole; `token` is what the caret marks in
/// it, where it stands there.
struct Mistake {
  std::size_t file = 0;
  int line = 0;
  std::string token;
  std::string message;
};

/// The files of one shader: the first is the user's, the others are what it includes. A file is found in
/// the including file's folder or in one of the folders that may be read, and lies below one of those:
/// the first file's folder and `folders`.
class Files {
 public:
  /// Throws UserError as readFile() does, and for what is no text.
  Files(const std::filesystem::path& file, const std::vector<std::filesystem::path>& folders);

  /// The number of an included file, read where it is asked for first. Nothing where it cannot be had;
  /// `reason` says why.
  std::optional<std::size_t> include(const std::string& name, bool beside, std::size_t from,
                                     std::string& reason);

  [[nodiscard]] std::size_t count() const { return files_.size(); }
  /// What compilers are given: line ends, the byte order mark and what only other compilers know are
  /// made plain; each character stands in its line and column.
  [[nodiscard]] const std::string& text(std::size_t file) const { return files_[file].text; }
  /// The text with remedies, which stays until these change.
  [[nodiscard]] const std::string& remediedText(std::size_t file);
  Remedies remedies;
  [[nodiscard]] const std::string& name(std::size_t file) const { return files_[file].name; }
  /// Files of the user's, not ours.
  [[nodiscard]] std::vector<std::filesystem::path> read() const;

  /// Throws a UserError that is a report: each mistake as "file:line:column: error: message", with caret.
  [[noreturn]] void fail(const std::vector<Mistake>& mistakes) const;

 private:
  struct File {
    std::string name;            ///< as messages say it
    std::filesystem::path path;  ///< empty for one of ours
    std::string original, text;
    std::string remedied;
    std::size_t remedies = 0;  ///< that `remedied` has
  };
  std::optional<std::size_t> add(std::string name, const std::filesystem::path& path, std::string original,
                                 std::string& reason);
  [[nodiscard]] scene::Place place(const Mistake& mistake) const;

  std::vector<std::filesystem::path> folders_;
  std::deque<File> files_;
  std::size_t bytes_ = 0;
};

/// The text with comments blanked, every other character at its place.
[[nodiscard]] std::string withoutComments(std::string_view text);

}  // namespace simreel::kernels
