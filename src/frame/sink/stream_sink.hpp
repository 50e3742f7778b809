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

/// Raw frames to a descriptor (standard output). `format`: "rgba" is bytes as in Image; "y4m" is
/// YUV4MPEG2 C444, 8 bits, full range, BT.601 matrix, which readers assume when a stream names none. Its
/// rate is that of playedRate().
[[nodiscard]] std::unique_ptr<FrameSink> openStreamSink(const std::string& format, const RunInfo& run,
                                                        std::span<const int> frames, int descriptor = 1);

/// Writes all bytes, past interruptions and full pipes. Returns 0, or errno.
[[nodiscard]] int writeAll(int descriptor, std::span<const std::byte> bytes);

/// The three planes, Y then Cb then Cr, each width * height bytes.
[[nodiscard]] std::vector<std::uint8_t> toFullRangeYuv444(const Image& image);

}  // namespace simreel::frame
