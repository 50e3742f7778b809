#pragma once
#include "frame/file/run_info.hpp"
#include "frame/sink/frame_sink.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace simreel::frame {

/// Opens a sink that writes raw frames to a descriptor (standard output). The format "rgba" writes bytes as
/// in Image. The format "y4m" writes YUV4MPEG2 C444 with 8 bits, full range, and the BT.601 matrix, which
/// readers assume if a stream specifies no matrix. playedRate() computes the frame rate.
[[nodiscard]] std::unique_ptr<FrameSink> openStreamSink(const std::string& format, const RunInfo& run,
                                                        std::span<const int> frames, int descriptor = 1);

/// Writes all bytes. Retries after EINTR and waits while a pipe is full. Returns 0 or errno.
[[nodiscard]] int writeAll(int descriptor, std::span<const std::byte> bytes);

/// Converts an image to three planes of width * height bytes: Y, Cb, Cr.
[[nodiscard]] std::vector<std::uint8_t> toFullRangeYuv444(const Image& image);

}  // namespace simreel::frame
