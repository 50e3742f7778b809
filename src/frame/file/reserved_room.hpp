#pragma once
#include <cstddef>
#include <filesystem>
#include <utility>

namespace simreel::frame {

/// Disk space held back so that a manifest can still be written when frames have filled the disk. It is a
/// file without a name: a killed process leaves nothing behind.
class ReservedRoom {
 public:
  ReservedRoom() = default;
  /// Reserves nothing where the file system cannot; a disk that is full already shows at the first frame.
  ReservedRoom(const std::filesystem::path& folder, std::size_t bytes);
  ~ReservedRoom() { release(); }
  ReservedRoom(ReservedRoom&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  ReservedRoom& operator=(ReservedRoom&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }
  ReservedRoom(const ReservedRoom&) = delete;
  ReservedRoom& operator=(const ReservedRoom&) = delete;

  /// Gives the space back.
  void release();

 private:
  int file_ = -1;
};

}  // namespace simreel::frame
