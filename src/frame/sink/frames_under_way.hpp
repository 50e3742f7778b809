#pragma once
#include "draw/screen/readback.hpp"
#include "draw/screen/renderer.hpp"
#include "frame/file/run_info.hpp"
#include "frame/image.hpp"
#include "frame/sink/field_files.hpp"
#include "frame/sink/frame_sink.hpp"
#include "frame/sink/progress.hpp"
#include "frame/sink/stage_timers.hpp"
#include "scene/scene.hpp"
#include "sim/world/world.hpp"

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::frame {

/// Pipeline from drawing to the sink: while the device draws a frame, earlier frames are read back and
/// encoded.
class FramePipeline {
 public:
  /// `awaitSummary`: waits for the next state summary and calls know(). `fields`: null if no raw field
  /// values are written.
  FramePipeline(const scene::Scene& scene, FrameSink& sink, const FieldFiles* fields, RunListener& progress,
                StageTimers& timers, std::function<void()> awaitSummary);

  /// Makes the renderer receive each previous frame, if pictures have motion blur or velocities. Must be
  /// called before the first draw().
  void follow(sim::World& world);
  /// Makes the following pictures store their light and the requested layers.
  void keepLayers(const draw::LightRequest& wanted);
  /// Sets a callback that receives each picture before the sink receives it.
  void onPicture(std::function<void(int frame, const Image& image)> callback) {
    onPicture_ = std::move(callback);
  }
  /// True if a picture or additional file of the frame must be written.
  [[nodiscard]] bool misses(int frame) const;
  /// Draws the world's current frame if it must be written. If too many frames are in flight, first
  /// delivers the oldest one.
  void draw(sim::World& world, std::optional<std::string> stateHash);
  /// Sets the state hash of a frame in flight. Ignored for other frames.
  void know(int frame, const std::string& stateHash);
  /// Counts a frame that need not be drawn, because an earlier run has already stored it.
  void pass(int frame);
  /// Passes all frames in flight to the sink.
  void drain();
  [[nodiscard]] int delivered() const { return delivered_; }

 private:
  struct Waiting {
    int frame;
    bool drawn;
    std::vector<FrameFile> files;  ///< additional files of the frame, which are stored when the frame's
                                   ///< state is known to be valid
    std::shared_ptr<const draw::PictureLayers> layers;
    std::optional<std::string> stateHash;
  };

  void deliverOldest();
  void store(Waiting waiting);
  void compareWithStored(Waiting waiting);

  FrameSink& sink_;
  const FieldFiles* fields_;
  RunListener& progress_;
  StageTimers& timers_;
  std::function<void()> awaitSummary_;
  std::function<void(int frame, const Image& image)> onPicture_;
  glm::ivec2 size_;
  bool alpha_;  ///< true if pictures have an alpha channel
  bool keepsLayers_ = false;
  draw::Renderer renderer_;
  draw::Readback readback_;
  std::deque<Waiting> waiting_;
  int delivered_ = 0;
  double reportedEncode_ = 0;  ///< part of the sink's encodeSeconds() that has already been reported to
                               ///< progress_
};

}  // namespace simreel::frame
