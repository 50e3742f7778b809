#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <tuple>

namespace simreel::serve {

/// Identifies a version of a file by its metadata: device, inode, size and time of modification. For a
/// missing file, all are 0.
using FileStamp = std::tuple<std::uint64_t, std::uint64_t, std::int64_t, std::int64_t, std::int64_t>;
[[nodiscard]] FileStamp stampOf(const std::filesystem::path& file);

/// Detects by metadata that files were written, replaced or removed. This also works on network file
/// systems, which do not notify a machine of writes by other machines.
class WatchedFiles {
 public:
  /// Watches exactly these files from now on. For new files, later calls compare with the current version.
  void watch(std::span<const std::filesystem::path> files);
  /// Records the current version of a file that this program has just written.
  void know(const std::filesystem::path& file);
  /// Returns true if a file has changed since the last call.
  [[nodiscard]] bool changed();

 private:
  std::map<std::filesystem::path, FileStamp> stamps_;
};

}  // namespace simreel::serve
