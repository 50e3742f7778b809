#pragma once
#include "frame/file/manifest.hpp"
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/sink/frame_sink.hpp"

#include <map>
#include <memory>
#include <span>
#include <string>

namespace simreel::frame {

/// Creates the sink for `output`. Throws UserError(usage) if the combination is not supported, and
/// UserError(inputOutput) if the output is not writable or files exist.
[[nodiscard]] std::unique_ptr<FrameSink> openSink(const OutputName& output, Existing existing,
                                                  const RunInfo& run, std::span<const int> frames,
                                                  const std::string& streamFormat);

/// Throws UserError(inputOutput) if an output file of one of the frames exists.
void refuseExisting(const OutputName& output, std::span<const int> frames);

/// Prints one line that names the existing pictures that a run with --resume draws again: pictures of
/// `frames` that are not in `kept`.
void tellOfRedrawn(const OutputName& output, std::span<const int> frames,
                   const std::map<int, ManifestFrame>& kept);

/// Performs the checks of openSink() that need no device. Checks for existing files and for a writable
/// location. Leaves no files behind. Throws the same errors as openSink().
void checkOutput(const OutputName& output, Existing existing, std::span<const int> frames);

}  // namespace simreel::frame
