#include "frame/file/reserved_room.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace simreel::frame {

ReservedRoom::ReservedRoom(const std::filesystem::path& folder, std::size_t bytes) {
  // Reserves a few extra blocks, because file sizes are rounded up to blocks and renaming the manifest
  // needs space in the folder.
  constexpr std::size_t blocks = 16384;
  file_ = ::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
  if (file_ >= 0 && ::posix_fallocate(file_, 0, static_cast<off_t>(bytes + blocks)) != 0) release();
}

void ReservedRoom::release() {
  if (file_ >= 0) ::close(file_);
  file_ = -1;
}

}  // namespace simreel::frame
