#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <tuple>

namespace simreel::serve {

/// Notices that files were written, replaced or removed, by what the system says of them: so it does on
/// network file systems too, which tell nobody of what other machines write.
class WatchedFiles {
 public:
  /// From here on these alone, as they are now.
  void watch(std::span<const std::filesystem::path> files);
  /// Whether one is another than before; it counts as known from then on.
  [[nodiscard]] bool changed();

 private:
  using Stamp = std::tuple<std::uint64_t, std::uint64_t, std::int64_t, std::int64_t, std::int64_t>;
  [[nodiscard]] static Stamp stampOf(const std::filesystem::path& file);
  std::map<std::filesystem::path, Stamp> stamps_;
};

}  // namespace simreel::serve
