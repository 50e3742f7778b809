#pragma once
#include "gl/context.hpp"
#include "scene/scene.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace simreel::frame {

/// Selects how the time of a frame is measured. `wait`: the CPU calls glFinish after each stage. This
/// separates stages even if a software driver defers work to threads and tiles, but stages cannot overlap.
/// `query`: GPU timestamps, with several frames in flight as in `render`. `whole`: only whole frames are
/// timed, with several frames in flight as in `render`.
enum class Timing { wait, query, whole };

/// Returns the suitable timing for the current context: `wait` on a software driver, otherwise `query`.
[[nodiscard]] Timing usualTiming();

/// Times (ms) of one stage of the frame, with one value per frame.
struct StageSeries {
  std::string name;  ///< name of the stage: "step flag", "shadow", "surfaces", ..., "readback"
  /// CPU time; with Timing::wait it includes waiting for the device to finish the stage
  std::vector<double> cpu;
  std::vector<double> gpu;  ///< time between GPU timestamps; empty unless the timing is Timing::query
  /// Sub-stage times (ms) reported by Simulation::stageTimes. They belong to the latest frame whose times
  /// were known when this frame was issued.
  struct Part {
    std::string name;
    std::vector<double> values;
  };
  std::vector<Part> parts;
};

/// Times of the measured frames of one scene, in frame order.
struct FrameTimes {
  std::vector<int> frames;  ///< numbers of the measured frames
  /// Wall time (ms) from the previous frame's arrival in CPU memory to the arrival of the frame.
  std::vector<double> wall;
  std::vector<double> waited;  ///< part of `wall` (ms) that the CPU spent waiting for the device
  /// CPU time (ms) of all threads of the process within `wall`, including the threads of a software driver.
  std::vector<double> processor;
  std::vector<StageSeries> stages;
  /// Number of rays traced for the last frame, for pictures of quality "high". BenchRun::countRays sets it.
  std::uint64_t rays = 0;
};

/// Runs and times the frames of one scene. The scene stays loaded between calls of run(); frame numbers may
/// exceed the scene's last frame.
class BenchRun {
 public:
  /// Creates the simulations and compiles all shaders on the current context. Throws UserError(device).
  BenchRun(scene::Scene scene, const gl::Context& context, Timing timing);
  ~BenchRun();
  BenchRun(BenchRun&&) noexcept;
  BenchRun& operator=(BenchRun&&) noexcept;
  BenchRun(const BenchRun&) = delete;
  BenchRun& operator=(const BenchRun&) = delete;

  /// Runs `warmUp` untimed frames, then `frames` timed frames, which are added to times(). The first call
  /// also runs frame 0, untimed. Calls `done` after every frame and returns early if `done` returns false.
  /// Throws UserError(device) if a simulation lost its state.
  void run(int warmUp, int frames, const std::function<bool()>& done);
  /// Draws the last frame again without timing it, and stores its ray count in times().rays.
  void countRays();
  [[nodiscard]] const FrameTimes& times() const;
  [[nodiscard]] const scene::Scene& scene() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace simreel::frame
