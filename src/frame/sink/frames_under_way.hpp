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

/// Frames between their drawing and their sink: while the device draws one, those before it are read back
/// and encoded.
class FramesUnderWay {
 public:
  /// `awaitSummary` waits for the next summary and calls know(). `fields`: null where no raw values go
  /// beside the pictures.
  FramesUnderWay(const scene::Scene& scene, FrameSink& sink, const FieldFiles* fields, Progress& progress,
                 StageTimers& timers, std::function<void()> awaitSummary);

  /// From now on draws know of the frame before theirs, where pictures have motion blur or velocities.
  void follow(sim::World& world);
  /// From now on pictures have their light, and layers.
  void keepLayers(const draw::LightRequest& wanted);
  /// Who hears of each picture before the sink gets it.
  void onPicture(std::function<void(int frame, const Image& image)> hear) { hear_ = std::move(hear); }
  /// Whether anything of a frame is to be written.
  [[nodiscard]] bool misses(int frame) const;
  /// The present frame of the world, drawn if it is wanted. Waits for an older one where too many are under
  /// way.
  void draw(sim::World& world, std::optional<std::string> stateHash);
  /// The state hash of a frame. Those of frames that are not under way are of no use here.
  void know(int frame, const std::string& stateHash);
  /// A frame that an earlier run has stored whole.
  void pass(int frame);
  /// Hands all to the sink.
  void drain();
  [[nodiscard]] int delivered() const { return delivered_; }

 private:
  struct Waiting {
    int frame;
    bool drawn;
    std::vector<FrameFile> files;  ///< stored when the frame is known to be sound
    std::shared_ptr<const draw::PictureLayers> layers;
    std::optional<std::string> stateHash;
  };

  void deliverOldest();
  void store(Waiting waiting);
  void compareWithStored(Waiting waiting);

  FrameSink& sink_;
  const FieldFiles* fields_;
  Progress& progress_;
  StageTimers& timers_;
  std::function<void()> awaitSummary_;
  std::function<void(int frame, const Image& image)> hear_;
  glm::ivec2 size_;
  bool alpha_;  ///< whether pictures have it
  bool keepsLayers_ = false;
  draw::Renderer renderer_;
  draw::Readback readback_;
  std::deque<Waiting> waiting_;
  int delivered_ = 0;
  double toldEncode_ = 0;  ///< of encodeSeconds(), what progress has heard of
};

}  // namespace simreel::frame
