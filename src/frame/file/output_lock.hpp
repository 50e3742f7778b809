#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <utility>

namespace simreel::frame {

/// Prevents two running programs from writing the same frames. The lock consists of byte ranges of the file
/// "manifest.json.lock" next to the manifest. The kernel releases the locks when the process ends for any
/// reason. The last program that uses the file removes it. A file left by a killed process is harmless.
/// Runs that differ only in their frames may run at the same time. If the file system does not support
/// locks (some NFS mounts), the class has no effect. If NFS supports locks, they also work between
/// machines.
class OutputLock {
 public:
  OutputLock() = default;
  /// Locks `frames`, which must be ascending. `run`: hash of everything except the frames that the output
  /// depends on. Throws UserError(inputOutput) if a running program has locked one of the frames or renders
  /// another run, or if the lock file cannot be created. `file`: the video or single picture that contains
  /// all frames, which the messages name; empty if each frame is a file.
  OutputLock(const std::filesystem::path& manifest, const std::string& run, std::span<const int> frames,
             const std::filesystem::path& file = {});
  ~OutputLock() { release(); }
  OutputLock(OutputLock&& other) noexcept
      : file_(std::exchange(other.file_, -1)), path_(std::move(other.path_)) {}
  OutputLock& operator=(OutputLock&& other) noexcept {
    std::swap(file_, other.file_);
    std::swap(path_, other.path_);
    return *this;
  }
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;

  /// Scope guard. While it exists, other programs do not write the manifest and counts that the runs share.
  /// Only one may exist at a time.
  class Shared {
   public:
    explicit Shared(const OutputLock& lock);
    ~Shared();
    Shared(const Shared&) = delete;
    Shared& operator=(const Shared&) = delete;

   private:
    int file_;
  };

  /// True if this program may write the checkpoint. If several programs call this function, only the first
  /// may write the checkpoint, until it calls release() or ends.
  [[nodiscard]] bool ownsCheckpoint() const;
  void release() noexcept;

 private:
  void open();
  [[nodiscard]] bool stillThere() const;
  void claim(const std::string& run, std::span<const int> frames, const std::filesystem::path& file) const;

  int file_ = -1;  ///< descriptor of the lock file; -1 if nothing is locked
  std::filesystem::path path_;
};

/// True if a running program has locked frames of the output with this manifest. False if the file system
/// does not support locks.
[[nodiscard]] bool isOutputLocked(const std::filesystem::path& manifest);

}  // namespace simreel::frame
