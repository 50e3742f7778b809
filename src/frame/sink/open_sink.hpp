#pragma once
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/sink/frame_sink.hpp"

#include <memory>
#include <span>
#include <string>

namespace simreel::frame {

/// Makes the sink that `output` asks for. Throws UserError: usage for what it cannot do, inputOutput where
/// nothing can be written or files exist.
[[nodiscard]] std::unique_ptr<FrameSink> openSink(const OutputName& output, Existing existing,
                                                  const RunInfo& run, std::span<const int> frames,
                                                  const std::string& streamFormat);

/// Throws UserError(inputOutput) where a file of one of the frames is there.
void refuseExisting(const OutputName& output, std::span<const int> frames);

/// What openSink() would refuse without a device: files that exist, and a place that cannot be written.
/// Leaves nothing. Throws as openSink() does.
void checkOutput(const OutputName& output, Existing existing, std::span<const int> frames);

}  // namespace simreel::frame
