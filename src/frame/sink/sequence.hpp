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

/// How a sequence ended.
struct SequenceResult {
  int frames = 0;      ///< delivered or found whole
  int signal = 0;      ///< that interrupted it, or 0
  double seconds = 0;  ///< wall clock
  StageTimes stages;   ///< simulate and draw: device time on a GPU; encode is over all threads
};

/// Looks at some frames of a run.
class FrameWatch {
 public:
  virtual ~FrameWatch() = default;
  /// Once the world is there, before its first step.
  virtual void begin(const sim::World& world) = 0;
  /// Whether made() is to be called there.
  [[nodiscard]] virtual bool wants(int frame) const = 0;
  /// The world stands at a frame that is wanted. State may be read back, which waits for the device.
  virtual void made(const sim::World& world) = 0;
  /// The picture of a frame, in the order of frames, some after made().
  virtual void drawn(int frame, const Image& image) = 0;
};

/// What is written beside the pictures.
struct BesideFrames {
  FieldFiles* fields = nullptr;  ///< gets the raw values of fields in the same frames; null: nothing does
  Clock::time_point began = Clock::now();  ///< of the command: what was before the first step counts
  bool counts = true;                      ///< what the simulations count goes to the sink
  Checkpoints checkpoints = {};
  FrameWatch* watch = nullptr;  ///< null: nobody looks
  /// Of pictures that are not made of their bytes.
  std::optional<draw::LightRequest> layers = std::nullopt;
};

/// Simulates the scene from its start, or from a checkpoint that no missing frame lies before, draws the
/// wanted frames and hands them to the sink, which is finished in every case. Frames that the sink does not
/// want are simulated all the same. Throws UserError: device when the state is lost (frames before that are
/// stored), inputOutput from the sink, and different when a frame kept from an earlier run has another
/// state hash now. A checkpoint that cannot be written is a warning. After the last frame it is removed.
[[nodiscard]] SequenceResult renderSequence(const scene::Scene& scene, const gl::Context& context,
                                            const std::vector<int>& frames, FrameSink& sink,
                                            Progress& progress, const BesideFrames& beside = {});

}  // namespace simreel::frame
