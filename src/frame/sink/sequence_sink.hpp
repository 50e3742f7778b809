#pragma once
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/sink/frame_sink.hpp"

#include <memory>
#include <span>

namespace simreel::frame {

/// Opens a sink for a numbered sequence of pictures or a single picture. Throws the same errors as
/// openSink().
[[nodiscard]] std::unique_ptr<FrameSink> openSequenceSink(const OutputName& output, Existing existing,
                                                          const RunInfo& run, std::span<const int> frames);

}  // namespace simreel::frame
