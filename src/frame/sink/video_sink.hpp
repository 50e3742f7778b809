#pragma once
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/sink/frame_sink.hpp"

#include <memory>
#include <span>

namespace simreel::frame {

/// Opens a sink for a video encoded by ffmpeg. Throws the same errors as openSink().
[[nodiscard]] std::unique_ptr<FrameSink> openVideoSink(const OutputName& output, Existing existing,
                                                       const RunInfo& run, std::span<const int> frames);

}  // namespace simreel::frame
