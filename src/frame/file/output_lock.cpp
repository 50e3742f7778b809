#include "frame/file/output_lock.hpp"

#include "base/error.hpp"
#include "base/log.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace simreel::frame {

namespace {

/// Byte range of the lock file. It may be beyond the end of the file.
struct Range {
  off_t begin;
  off_t length;  ///< length in bytes; 0 means up to the end of the file, even if the file grows
};
constexpr Range sharedFiles{0, 1};
constexpr Range checkpoint{1, 1};
constexpr off_t firstFrame = 2;
constexpr Range allFrames{firstFrame, 0};

struct flock description(short kind, Range range) {
  struct flock lock {};
  lock.l_type = kind;
  lock.l_whence = SEEK_SET;
  lock.l_start = range.begin;
  lock.l_len = range.length;
  return lock;
}

/// Locks a range without waiting. Uses open file description locks, which do not depend on the process id
/// and are not released when another descriptor of the file is closed.
bool tryLock(int file, Range range) {
  struct flock lock = description(F_WRLCK, range);
  return ::fcntl(file, F_OFD_SETLK, &lock) == 0;
}

bool waitFor(int file, Range range) {
  struct flock lock = description(F_WRLCK, range);
  int result = 0;
  while ((result = ::fcntl(file, F_OFD_SETLKW, &lock)) != 0 && errno == EINTR) {
  }
  return result == 0;
}

void leave(int file, Range range) {
  struct flock lock = description(F_UNLCK, range);
  (void)::fcntl(file, F_OFD_SETLK, &lock);
}

/// Returns the byte ranges of consecutive frames. The kernel keeps locks in a list, which must stay short.
/// More than 8192 ranges are therefore merged into one range, which then also covers frames that are not in
/// `frames`.
std::vector<Range> rangesOf(std::span<const int> frames) {
  constexpr std::size_t max = 8192;
  std::vector<Range> ranges;
  for (const int frame : frames) {
    const off_t at = firstFrame + frame;
    if (!ranges.empty() && ranges.back().begin + ranges.back().length == at)
      ++ranges.back().length;
    else
      ranges.push_back({at, 1});
  }
  if (ranges.size() > max)
    ranges = {{ranges.front().begin, ranges.back().begin + ranges.back().length - ranges.front().begin}};
  return ranges;
}

}  // namespace

OutputLock::OutputLock(const std::filesystem::path& manifest, const std::string& run,
                       std::span<const int> frames, const std::filesystem::path& file)
    : path_(manifest.string() + ".lock") {
  while (true) {
    open();
    if (!waitFor(file_, sharedFiles)) {
      detail("{} cannot be locked ({}); another simreel could write the same frames at the same time",
             path_.string(), std::strerror(errno));
      ::unlink(path_.c_str());
      ::close(std::exchange(file_, -1));
      return;
    }
    if (stillThere()) break;
    ::close(std::exchange(file_, -1));  // The last program that used the file has just removed it, so a new
                                        // file is needed.
  }
  try {
    claim(run, frames, file);
  } catch (...) {
    ::close(std::exchange(file_, -1));
    throw;
  }
  leave(file_, sharedFiles);
}

void OutputLock::open() {
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ >= 0) return;
  const int reason = errno;
  fail(ExitCode::inputOutput, "cannot create {}: {}", path_.string(), std::strerror(reason));
}

bool OutputLock::stillThere() const {
  struct stat opened {
  }, named{};
  return ::fstat(file_, &opened) == 0 && ::stat(path_.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

void OutputLock::claim(const std::string& run, std::span<const int> frames,
                       const std::filesystem::path& file) const {
  const bool whole = !file.empty();  // True if all frames are in one file.
  const std::string folder = path_.parent_path().empty() ? "." : path_.parent_path().string();
  if (tryLock(file_, allFrames)) {
    if (::ftruncate(file_, 0) != 0 ||
        ::pwrite(file_, run.data(), run.size(), 0) != static_cast<ssize_t>(run.size()))
      detail("{} cannot be written; no other simreel can render frames of this run at the same time",
             path_.string());
    leave(file_, allFrames);
  } else {
    std::string other(run.size() + 1, '\0');
    other.resize(
        static_cast<std::size_t>(std::max<ssize_t>(0, ::pread(file_, other.data(), other.size(), 0))));
    if (other != run)
      fail(ExitCode::inputOutput,
           "another simreel is rendering another scene, seed or size into {}; wait for it, or choose "
           "another {}",
           whole ? file.string() : folder, whole ? "file" : "folder");
  }
  for (const Range& range : rangesOf(frames)) {
    if (tryLock(file_, range)) continue;
    if (whole)
      fail(ExitCode::inputOutput,
           "{} is being rendered by another simreel; wait for it, or choose another file", file.string());
    struct flock held = description(F_WRLCK, range);
    const bool known = ::fcntl(file_, F_OFD_GETLK, &held) == 0 && held.l_type != F_UNLCK;
    fail(ExitCode::inputOutput,
         "frame {} is being rendered into {} by another simreel; wait for it, or choose other frames with "
         "--frames",
         std::max(range.begin, known ? held.l_start : range.begin) - firstFrame, folder);
  }
}

OutputLock::Shared::Shared(const OutputLock& lock) : file_(lock.file_) {
  if (file_ >= 0) (void)waitFor(file_, sharedFiles);
}

OutputLock::Shared::~Shared() {
  if (file_ >= 0) leave(file_, sharedFiles);
}

bool isOutputLocked(const std::filesystem::path& manifest) {
  const int file = ::open((manifest.string() + ".lock").c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  struct flock lock = description(F_WRLCK, {sharedFiles.begin, 0});
  const bool held = ::fcntl(file, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  ::close(file);
  return held;
}

bool OutputLock::ownsCheckpoint() const {
  return file_ < 0 || tryLock(file_, checkpoint);
}

void OutputLock::release() noexcept {
  if (file_ < 0) return;
  // Removes the file while the shared range is locked. If another program has opened the file meanwhile,
  // its constructor detects that the file is gone and creates a new one.
  if (waitFor(file_, sharedFiles) && tryLock(file_, {checkpoint.begin, 0})) ::unlink(path_.c_str());
  ::close(std::exchange(file_, -1));
}

}  // namespace simreel::frame
