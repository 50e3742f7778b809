#include "base/error.hpp"
#include "frame/sinks.hpp"

namespace simreel::frame {

std::unique_ptr<FrameSink> openSink(const std::string& output, Existing existing, const RunInfo& run,
                                    std::span<const int> frames, const std::string& streamFormat) {
  const OutputName name = parseOutput(output, frames.size());
  switch (name.kind) {
    case OutputName::Kind::video:
      return openVideoSink(name, existing, run, frames);
    case OutputName::Kind::stream:
      if (existing == Existing::resume || existing == Existing::skip)
        fail(ExitCode::usage,
             "--output -: --resume and --skip-existing keep frames of an earlier run, a stream has none");
      return openStreamSink(streamFormat, run);
    case OutputName::Kind::sequence:
    case OutputName::Kind::single:
      break;
  }
  return openSequenceSink(name, existing, run, frames);
}

}  // namespace simreel::frame
