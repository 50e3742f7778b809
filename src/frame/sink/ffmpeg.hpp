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

/// Arguments that make ffmpeg read RGBA frames from its standard input and encode `file` as its
/// extension suggests.
[[nodiscard]] std::vector<std::string> ffmpegArguments(const std::filesystem::path& file, int width,
                                                       int height, const FrameRate& rate);

/// Width and height that the video gets: 4:2:0 encoders need even sides, so an odd one is one pixel longer.
[[nodiscard]] std::pair<int, int> videoSize(const std::filesystem::path& file, int width, int height);

/// A running ffmpeg, fed through a pipe. What it says is kept in memory, so it never waits for a reader.
class Ffmpeg {
 public:
  /// Throws UserError(inputOutput), with how to install it when it is missing.
  explicit Ffmpeg(const std::vector<std::string>& arguments);
  /// Ends a process that was not finished.
  ~Ffmpeg();
  Ffmpeg(const Ffmpeg&) = delete;
  Ffmpeg& operator=(const Ffmpeg&) = delete;
  Ffmpeg(Ffmpeg&&) = delete;
  Ffmpeg& operator=(Ffmpeg&&) = delete;

  /// Throws UserError(inputOutput) with ffmpeg's last line when it has ended.
  void write(std::span<const std::byte> bytes);
  /// Closes the pipe and waits. Throws as write() does when ffmpeg was not content.
  void finish();
  /// Ends the process at once, so that a write() in another thread returns. finish() must not follow.
  void kill() noexcept;

 private:
  int wait();
  [[noreturn]] void failed(int status);
  [[nodiscard]] std::string lastLine() const;

  std::mutex mutex_;  ///< held to signal the process, and to reap it
  pid_t process_ = -1;
  int input_ = -1;
  int messages_ = -1;
  bool killed_ = false;  ///< by us, since it went on without reading
};

}  // namespace simreel::frame
