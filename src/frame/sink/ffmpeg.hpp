#pragma once
#include "frame/sink/frame_rate.hpp"

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <span>
#include <string>
#include <sys/types.h>
#include <utility>
#include <vector>

namespace simreel::frame {

/// Returns ffmpeg arguments to read RGBA frames from standard input and encode `file` in the format of its
/// extension.
[[nodiscard]] std::vector<std::string> ffmpegArguments(const std::filesystem::path& file, int width,
                                                       int height, const FrameRate& rate);

/// Returns the width and height of the video. H.264 and WebM need even sizes (their colours are 4:2:0), so
/// an odd size is increased by one pixel; other formats keep the size.
[[nodiscard]] std::pair<int, int> videoSize(const std::filesystem::path& file, int width, int height);

/// A running ffmpeg process that reads frames through a pipe. The messages of ffmpeg go to a memory file,
/// so that ffmpeg never waits for a reader.
class Ffmpeg {
 public:
  /// Starts ffmpeg. Throws UserError(inputOutput) if it cannot be started. If ffmpeg is missing, the
  /// message says how to install it. `file`: the finished video, which messages name.
  Ffmpeg(const std::vector<std::string>& arguments, std::filesystem::path file);
  /// Kills the process if finish() was not called.
  ~Ffmpeg();
  Ffmpeg(const Ffmpeg&) = delete;
  Ffmpeg& operator=(const Ffmpeg&) = delete;
  Ffmpeg(Ffmpeg&&) = delete;
  Ffmpeg& operator=(Ffmpeg&&) = delete;

  /// Writes to ffmpeg's standard input. If ffmpeg has ended, throws UserError(inputOutput) with the last
  /// line of its messages.
  void write(std::span<const std::byte> bytes);
  /// Closes the pipe and waits for ffmpeg to end. Throws like write() if ffmpeg failed.
  void finish();
  /// Kills the process at once, so that a write() in another thread returns. Do not call finish()
  /// afterwards.
  void kill() noexcept;

 private:
  int wait();
  [[noreturn]] void failed(int status);

  std::filesystem::path file_;
  std::mutex mutex_;  ///< locked while a signal is sent to the process or its exit status is read
  pid_t process_ = -1;
  int input_ = -1;
  int messages_ = -1;
  bool killed_ = false;  ///< true if write() killed the process because it had stopped reading
};

}  // namespace simreel::frame
