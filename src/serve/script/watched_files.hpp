#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <tuple>

namespace simreel::serve {

/// What the system says of a file, which is another one once that was written or replaced; none: {}.
using FileStamp = std::tuple<std::uint64_t, std::uint64_t, std::int64_t, std::int64_t, std::int64_t>;
[[nodiscard]] FileStamp stampOf(const std::filesystem::path& file);

/// Notices that files were written, replaced or removed, by what the system says of them: so it does on
/// network file systems too, which tell nobody of what other machines write.
class WatchedFiles {
 public:
  /// From here on these alone, as they are now.
  void watch(std::span<const std::filesystem::path> files);
  /// One is known as it is now: what has just been written by ourselves.
  void know(const std::filesystem::path& file);
  /// Whether one is another than before; it counts as known from then on.
  [[nodiscard]] bool changed();

 private:
  std::map<std::filesystem::path, FileStamp> stamps_;
};

}  // namespace simreel::serve
