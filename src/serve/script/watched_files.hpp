#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <tuple>

namespace simreel::serve {

/// Identifies a version of a file by its metadata: device, inode, size, time of modification. {} for a
/// missing file.
using FileStamp = std::tuple<std::uint64_t, std::uint64_t, std::int64_t, std::int64_t, std::int64_t>;
[[nodiscard]] FileStamp stampOf(const std::filesystem::path& file);

/// Detects that files were written, replaced or removed, by comparing their metadata. This also works on
/// network file systems, which send no notifications of other machines' writes.
class WatchedFiles {
 public:
  /// Watches exactly these files from now on; new ones from their present version.
  void watch(std::span<const std::filesystem::path> files);
  /// Records the present version of a file that this program has just written.
  void know(const std::filesystem::path& file);
  /// Returns true if a file has changed since the last call.
  [[nodiscard]] bool changed();

 private:
  std::map<std::filesystem::path, FileStamp> stamps_;
};

}  // namespace simreel::serve
