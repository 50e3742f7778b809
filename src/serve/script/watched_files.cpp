#include "serve/script/watched_files.hpp"

#include <sys/stat.h>
#include <utility>

namespace simreel::serve {

FileStamp stampOf(const std::filesystem::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0) return {};
  return {found.st_dev, found.st_ino, found.st_size, found.st_mtim.tv_sec, found.st_mtim.tv_nsec};
}

void WatchedFiles::watch(std::span<const std::filesystem::path> files) {
  std::map<std::filesystem::path, FileStamp> stamps;
  for (const std::filesystem::path& file : files) {
    const auto known = stamps_.find(file);
    stamps[file] = known == stamps_.end() ? stampOf(file) : known->second;
  }
  stamps_ = std::move(stamps);
}

void WatchedFiles::know(const std::filesystem::path& file) {
  if (const auto known = stamps_.find(file); known != stamps_.end()) known->second = stampOf(file);
}

bool WatchedFiles::changed() {
  bool any = false;
  for (auto& [file, stamp] : stamps_) {
    const FileStamp now = stampOf(file);
    if (now == stamp) continue;
    stamp = now;
    any = true;
  }
  return any;
}

}  // namespace simreel::serve
