#pragma once
#include <cstddef>
#include <filesystem>
#include <utility>

namespace simreel::frame {

/// Disk space that is reserved so that the manifest can still be written when frames have filled the disk.
/// The space belongs to an unnamed file, which disappears even if the process is killed.
class ReservedRoom {
 public:
  ReservedRoom() = default;
  /// Reserves space. If the file system does not support it or the disk is full, reserves nothing. A full
  /// disk is reported at the first frame.
  ReservedRoom(const std::filesystem::path& folder, std::size_t bytes);
  ~ReservedRoom() { release(); }
  ReservedRoom(ReservedRoom&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  ReservedRoom& operator=(ReservedRoom&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }
  ReservedRoom(const ReservedRoom&) = delete;
  ReservedRoom& operator=(const ReservedRoom&) = delete;

  /// Frees the reserved space.
  void release();

 private:
  int file_ = -1;
};

}  // namespace simreel::frame
