#include "frame/sink/open_sink.hpp"

#include "base/error.hpp"
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/sink/frame_sink.hpp"
#include "frame/sink/sequence_sink.hpp"
#include "frame/sink/stream_sink.hpp"
#include "frame/sink/video_sink.hpp"

namespace simreel::frame {

std::unique_ptr<FrameSink> openSink(const OutputName& output, Existing existing, const RunInfo& run,
                                    std::span<const int> frames, const std::string& streamFormat) {
  switch (output.kind) {
    case OutputName::Kind::video:
      return openVideoSink(output, existing, run, frames);
    case OutputName::Kind::stream:
      if (existing == Existing::resume || existing == Existing::skip)
        fail(ExitCode::usage,
             "--output -: --resume and --skip-existing keep frames of an earlier run, a stream has none");
      return openStreamSink(streamFormat, run);
    case OutputName::Kind::sequence:
    case OutputName::Kind::single:
      break;
  }
  return openSequenceSink(output, existing, run, frames);
}

}  // namespace simreel::frame
