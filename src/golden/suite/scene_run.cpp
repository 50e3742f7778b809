#include "golden/suite/scene_run.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "draw/screen/readback.hpp"
#include "draw/screen/renderer.hpp"
#include "frame/draw_world.hpp"
#include "frame/interrupt.hpp"
#include "frame/summaries.hpp"
#include "golden/suite/check.hpp"
#include "sim/world/world.hpp"

#include <algorithm>

namespace simreel::golden {

namespace {

class Runner {
 public:
  Runner(const scene::Scene& scene, std::span<const int> frames)
      : world_((sim::compileWorldAhead(scene), scene)),
        summaries_(world_, [this](const auto& summary) { summary_ = summary; }),
        renderer_(scene, scene.render.size, scene.render.samples),
        readback_(scene.render.size),
        size_(scene.render.size),
        alpha_(scene.render.transparent),
        checker_(scene, world_, frames) {
    frame::followMotion(renderer_, world_);
    draw::compileAhead(scene, scene.render.size, scene.render.samples, world_.time(), world_.drawables());
  }

  SceneRun run(std::span<const int> frames) {
    std::vector<int> stops(frames.begin(), frames.end());
    const auto wanted = checker_.frames();
    stops.insert(stops.end(), wanted.begin(), wanted.end());
    std::sort(stops.begin(), stops.end());
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    for (const int frame : stops) {
      simulateTo(frame);
      if (frame == stops.front()) searchRaces(frame);
      if (std::find(frames.begin(), frames.end(), frame) == frames.end()) {
        checker_.state(frame, world_);
        continue;
      }
      result_.frames.push_back(draw(frame));
      checker_.state(frame, world_);
      checker_.picture(frame, result_.frames.back().image);
    }
    const auto checks = checker_.results();
    result_.checks.insert(result_.checks.end(), checks.begin(), checks.end());
    return std::move(result_);
  }

 private:
  void simulateTo(int frame) {
    const Clock::time_point begin = Clock::now();
    while (!started_ || world_.frame() < frame) {
      frame::throwIfInterrupted();
      world_.advanceTo(started_ ? world_.frame() + 1 : 0);
      started_ = true;
      summaries_.start();
    }
    summaries_.takeAll();
    glFinish();
    result_.simulateSeconds += secondsSince(begin);
  }

  /// Adds a failed check for each data race in a user's kernels, because the result of a race depends on
  /// the machine.
  void searchRaces(int frame) {
    for (const std::string& line : world_.races())
      result_.checks.push_back({"races", frame, {}, {}, {}, false, line});
  }

  RunFrame draw(int frame) {
    frame::drawWorld(renderer_, world_);
    readback_.start(renderer_.target(), frame);
    RunFrame made{frame, world_.time(), {size_.x, size_.y, {}, alpha_}, {}, {}};
    made.image.bytes = readback_.nextPicture(true)->second;
    made.pixels = frame::pixelHash(made.image);
    const auto arrays = world_.arrays();
    SIMREEL_CHECK_EQ(arrays.size(), summary_.arrays.size());
    for (std::size_t i = 0; i < arrays.size(); ++i)
      made.state[arrays[i].object + "." + arrays[i].array] = summary_.arrays[i];
    return made;
  }

  sim::World world_;
  frame::Summaries summaries_;  ///< summaries of all frames, which detect a lost state
  draw::Renderer renderer_;
  draw::Readback readback_;
  glm::ivec2 size_;
  bool alpha_;  ///< true if pictures have an alpha channel
  Checker checker_;
  sim::World::Summary summary_;  ///< latest state summary
  SceneRun result_;
  bool started_ = false;
};

}  // namespace

SceneRun runScene(const scene::Scene& scene, std::span<const int> frames) {
  return Runner(scene, frames).run(frames);
}

std::string runDifference(const SceneRun& first, const SceneRun& second) {
  SIMREEL_CHECK_EQ(first.frames.size(), second.frames.size());
  for (std::size_t i = 0; i < first.frames.size(); ++i) {
    const RunFrame& a = first.frames[i];
    const RunFrame& b = second.frames[i];
    for (const auto& [array, hash] : a.state)
      if (b.state.at(array) != hash)
        return fmt::format("frame {}: the state of {} differs", a.frame, array);
    if (a.pixels != b.pixels) return fmt::format("frame {}: the pictures differ", a.frame);
  }
  return {};
}

}  // namespace simreel::golden
