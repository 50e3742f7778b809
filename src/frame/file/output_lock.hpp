#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <utility>

namespace simreel::frame {

/// Keeps two running programs from writing the same frames. The kernel holds it, on ranges of bytes of a
/// file beside the manifest ("manifest.json.lock"), so it ends with its process however that ends; the file
/// goes with the last of them, and one that a kill has left means nothing. Runs that agree in everything
/// but their frames may go on side by side. File systems without locks, such as some NFS mounts, are
/// written unguarded; where NFS has them, they hold between machines.
class OutputLock {
 public:
  OutputLock() = default;
  /// Claims frames, in rising order. `run` names all else that the output depends on. Throws
  /// UserError(inputOutput) where a live program has one of them, or does another run; and where the file
  /// cannot be made.
  OutputLock(const std::filesystem::path& manifest, const std::string& run, std::span<const int> frames);
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

  /// While it lives, no other program writes what the runs share: manifest and counts. One at a time.
  class Shared {
   public:
    explicit Shared(const OutputLock& lock);
    ~Shared();
    Shared(const Shared&) = delete;
    Shared& operator=(const Shared&) = delete;

   private:
    int file_;
  };

  /// Whether the checkpoint is this program's to write: of several the first that asks, until it ends.
  [[nodiscard]] bool ownsCheckpoint() const;
  void release() noexcept;

 private:
  void open();
  [[nodiscard]] bool stillThere() const;
  void claim(const std::string& run, std::span<const int> frames) const;

  int file_ = -1;  ///< -1: nothing is locked
  std::filesystem::path path_;
};

/// Whether a running program has frames of the output with this manifest, as far as locks tell.
[[nodiscard]] bool isOutputLocked(const std::filesystem::path& manifest);

}  // namespace simreel::frame
