#include "frame/sink/stream_sink.hpp"

#include "base/error.hpp"
#include "frame/file/run_info.hpp"
#include "frame/interrupt.hpp"
#include "frame/sink/frame_queue.hpp"
#include "frame/sink/frame_rate.hpp"
#include "frame/sink/frame_sink.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <poll.h>
#include <unistd.h>

namespace simreel::frame {

namespace {

class StreamSink final : public FrameSink {
 public:
  StreamSink(const std::string& format, const RunInfo& run, std::span<const int> frames, int descriptor)
      : descriptor_(descriptor), y4m_(format == "y4m"), run_(run) {
    if (format != "rgba" && format != "y4m")
      fail(ExitCode::usage, "stream format {} is unknown; use rgba or y4m", format);
    if (::isatty(descriptor) != 0)
      fail(ExitCode::usage,
           "--output - would write pixels to the terminal; pipe it into a program or a file");
    ignoreBrokenPipes();
    if (y4m_) rate_ = playedRate(run.fps, frames);
  }

  bool wants(int /*frame*/) override { return true; }
  std::optional<std::string> knownStateHash(int /*frame*/) const override { return std::nullopt; }
  void add(FrameInfo info, std::optional<Image> image) override {
    queue_.push(std::move(info), std::move(image));
  }
  void finish() override { queue_.close(); }
  double encodeSeconds() const override { return queue_.seconds(); }
  std::string summary() const override { return "standard output"; }

 private:
  void handle(const Image& image) {
    SIMREEL_CHECK_EQ(image.width, run_.width);
    SIMREEL_CHECK_EQ(image.height, run_.height);
    if (!y4m_) {
      write(std::as_bytes(std::span(image.bytes)));
      return;
    }
    std::string header = "FRAME\n";
    if (!started_)
      header = fmt::format("YUV4MPEG2 W{} H{} F{} Ip A1:1 C444 XCOLORRANGE=FULL\nFRAME\n", run_.width,
                           run_.height, rate_.text(':'));
    started_ = true;
    write(std::as_bytes(std::span(header)));
    const std::vector<std::uint8_t> planes = toFullRangeYuv444(image);
    write(std::as_bytes(std::span(planes)));
  }

  void write(std::span<const std::byte> bytes) const {
    const int error = writeAll(descriptor_, bytes);
    if (error == EPIPE)
      fail(ExitCode::inputOutput, "standard output was closed before all frames were written");
    if (error != 0)
      fail(ExitCode::inputOutput, "cannot write to standard output: {}", std::strerror(error));
  }

  int descriptor_;
  bool y4m_;
  bool started_ = false;
  RunInfo run_;
  FrameRate rate_;
  FrameQueue queue_{1, FrameQueue::maxWaitingInOrder,
                    [this](const FrameInfo&, const std::optional<Image>& image) {
                      if (image) handle(*image);
                    }};
};

}  // namespace

int writeAll(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(descriptor, bytes.data(), bytes.size());
    if (put >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(put));
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      pollfd ready{descriptor, POLLOUT, 0};
      ::poll(&ready, 1, -1);
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

std::vector<std::uint8_t> toFullRangeYuv444(const Image& image) {
  const std::size_t pixels = std::size_t(image.width) * std::size_t(image.height);
  std::vector<std::uint8_t> planes(pixels * 3);
  // Y = 0.299 R + 0.587 G + 0.114 B, Cb = 128 + (B - Y) / 1.772 and Cr = 128 + (R - Y) / 1.402 (as in
  // JFIF), in units of 1/65536. Each row of factors sums to 65536 or 0, so greys stay grey.
  const auto clamp = [](int value) { return static_cast<std::uint8_t>(std::clamp(value >> 16, 0, 255)); };
  constexpr int half = 1 << 15, middle = (128 << 16) + half;
  for (std::size_t i = 0; i < pixels; ++i) {
    const int r = image.bytes[i * 4], g = image.bytes[i * 4 + 1], b = image.bytes[i * 4 + 2];
    planes[i] = clamp(19595 * r + 38470 * g + 7471 * b + half);
    planes[pixels + i] = clamp(-11058 * r - 21710 * g + 32768 * b + middle);
    planes[2 * pixels + i] = clamp(32768 * r - 27439 * g - 5329 * b + middle);
  }
  return planes;
}

std::unique_ptr<FrameSink> openStreamSink(const std::string& format, const RunInfo& run,
                                          std::span<const int> frames, int descriptor) {
  return std::make_unique<StreamSink>(format, run, frames, descriptor);
}

}  // namespace simreel::frame
