#pragma once
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/sink/frame_sink.hpp"

#include <memory>
#include <span>

namespace simreel::frame {

/// A numbered sequence of pictures, or one. Throws as openSink does.
[[nodiscard]] std::unique_ptr<FrameSink> openSequenceSink(const OutputName& output, Existing existing,
                                                          const RunInfo& run, std::span<const int> frames);

}  // namespace simreel::frame
