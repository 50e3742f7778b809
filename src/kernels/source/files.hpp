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

/// Limits on the files of a shader: max bytes of one file, max bytes of all files, and max depth of
/// includes.
inline constexpr std::size_t maxFileBytes = std::size_t{2} << 20;
inline constexpr std::size_t maxAllBytes = std::size_t{8} << 20;
inline constexpr std::size_t maxIncludeDepth = 32;

/// An error in a user's file. `file` is an index in Files. `line` starts at 1; 0 means the whole file.
/// `token` is the text that the caret marks if the line contains it.
struct Mistake {
  std::size_t file = 0;
  int line = 0;
  std::string token;
  std::string message;
};

/// The files of one shader: the user's file first, then its includes. Includes are searched in the
/// including file's folder and in `folders`. They must lie below the first file's folder or one of
/// `folders`.
class Files {
 public:
  /// Reads the first file. Throws UserError if it cannot be read or is not text.
  Files(const std::filesystem::path& file, const std::vector<std::filesystem::path>& folders);

  /// Returns the index of an included file, which is read at the first request. On failure, returns nullopt
  /// and sets `reason`. If `beside` is true, the folder of the including file, whose index is `from`, is
  /// searched, too.
  std::optional<std::size_t> include(const std::string& name, bool beside, std::size_t from,
                                     std::string& reason);

  [[nodiscard]] std::size_t count() const { return files_.size(); }
  /// Returns the text for the compiler. Line ends, byte order mark and unsupported syntax are normalised.
  /// Each character keeps its line and column.
  [[nodiscard]] const std::string& text(std::size_t file) const { return files_[file].text; }
  /// Returns the text with remedies applied. The reference is valid until the remedies change.
  [[nodiscard]] const std::string& remediedText(std::size_t file);
  Remedies remedies;
  [[nodiscard]] const std::string& name(std::size_t file) const { return files_[file].name; }
  /// Returns the paths of the user's files, without embedded files.
  [[nodiscard]] std::vector<std::filesystem::path> read() const;

  /// Throws a UserError whose message contains "file:line:column: error: message", the source line and a
  /// caret for each mistake.
  [[noreturn]] void fail(const std::vector<Mistake>& mistakes) const;

 private:
  struct File {
    std::string name;            ///< name for messages
    std::filesystem::path path;  ///< path; empty for an embedded file
    std::string original, text;
    std::string remedied;
    std::size_t remedies = 0;  ///< number of remedies applied in `remedied`
  };
  std::optional<std::size_t> add(std::string name, const std::filesystem::path& path, std::string original,
                                 std::string& reason);
  [[nodiscard]] scene::Place place(const Mistake& mistake) const;

  std::vector<std::filesystem::path> folders_;
  std::deque<File> files_;
  std::size_t bytes_ = 0;
};

/// Returns the text with comments replaced by spaces. All other characters keep their positions.
[[nodiscard]] std::string withoutComments(std::string_view text);

}  // namespace simreel::kernels
