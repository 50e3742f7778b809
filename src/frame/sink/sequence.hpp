#pragma once
#include "base/clock.hpp"
#include "frame/image.hpp"
#include "frame/sink/checkpoint_keeper.hpp"
#include "frame/sink/field_files.hpp"
#include "frame/sink/frame_sink.hpp"
#include "frame/sink/progress.hpp"
#include "gl/context.hpp"
#include "scene/scene.hpp"
#include "sim/world/world.hpp"

#include <vector>

namespace simreel::frame {

/// Result of rendering a sequence.
struct SequenceResult {
  int frames = 0;      ///< number of frames that were delivered or already complete
  int signal = 0;      ///< number of the signal that interrupted the run, or 0
  double seconds = 0;  ///< wall-clock time of the run
  StageTimes stages;   ///< simulate and draw are device time on a GPU; encode is the sum over all threads
};

/// Callback interface that observes selected frames of a run.
class FrameWatch {
 public:
  virtual ~FrameWatch() = default;
  /// Called once after the world is created and before its first step.
  virtual void begin(const sim::World& world) = 0;
  /// True if made() must be called at this frame.
  [[nodiscard]] virtual bool wants(int frame) const = 0;
  /// Called when the world has reached a selected frame. May read back state, which waits for the device.
  virtual void made(const sim::World& world) = 0;
  /// Receives the picture of each frame, in frame order. May be called later than made() for the same
  /// frame.
  virtual void drawn(int frame, const Image& image) = 0;
};

/// Additional outputs and options of renderSequence().
struct SequenceOptions {
  /// writes raw field values of the same frames; if null, none are written
  FieldFiles* fields = nullptr;
  /// start time of the command, from which StageTimes::start is measured
  Clock::time_point began = Clock::now();
  bool counts = true;  ///< true to pass the simulations' counts to the sink
  Checkpoints checkpoints = {};
  FrameWatch* watch = nullptr;  ///< observer of selected frames; may be null
  /// Light and layers to store, for picture formats other than 8-bit PNG.
  std::optional<draw::LightRequest> layers = std::nullopt;
};

/// Simulates the scene from its start, or from a checkpoint if no wanted frame before it is missing. Draws
/// the wanted frames and passes them to the sink. Frames that the sink does not want are simulated, too.
/// Always calls sink.finish(). Throws UserError(device) if a simulation lost its state (earlier frames are
/// stored), UserError(inputOutput) from the sink, and UserError(different) if a frame stored by an earlier
/// run now has another state hash. Only warns if a checkpoint cannot be written. The checkpoint is removed
/// after the last frame.
[[nodiscard]] SequenceResult renderSequence(const scene::Scene& scene, const gl::Context& context,
                                            const std::vector<int>& frames, FrameSink& sink,
                                            RunListener& progress, const SequenceOptions& beside = {});

}  // namespace simreel::frame
