#pragma once
#include "gl/context.hpp"
#include "scene/scene.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace simreel::frame {

/// How frames are timed. `wait`: each stage is waited for before the next begins, which tells them apart
/// even where a software driver's work hides in threads and tiles, but keeps them from overlapping.
/// `query`: by the device's timestamps, with frames under way as in `render`. `whole`: as in `render`, with
/// no look inside.
enum class Timing { wait, query, whole };

/// What suits the current context: `wait` on a software driver, else `query`.
[[nodiscard]] Timing usualTiming();

/// A stage of a frame; ms, one value a frame.
struct StageSeries {
  std::string name;         ///< "step flag", "shadow", "surfaces", ..., "readback"
  std::vector<double> cpu;  ///< the CPU was in it; with Timing::wait until all of it was done
  std::vector<double> gpu;  ///< the device worked on it; empty unless Timing::query
  /// What the simulation says of its step (Simulation::stageTimes); ms, of the latest frame known then.
  struct Part {
    std::string name;
    std::vector<double> values;
  };
  std::vector<Part> parts;
};

/// Measured frames of one scene, in the order of their frames.
struct FrameTimes {
  std::vector<int> frames;  ///< numbers
  /// ms from the frame before being complete in the CPU's memory to this one being so.
  std::vector<double> wall;
  std::vector<double> waited;  ///< ms of that in which the CPU waited for the device
  /// ms of processor time in it, of all threads: a software driver's too.
  std::vector<double> processor;
  std::vector<StageSeries> stages;
  std::uint64_t rays =
      0;  ///< of the last frame, those that went any way: of quality "high" (BenchRun::countRays)
};

/// One scene, kept ready to run further frames. Frames go on beyond the scene's end.
class BenchRun {
 public:
  /// Makes the simulations and compiles everything on the current context. Throws UserError(device).
  BenchRun(scene::Scene scene, const gl::Context& context, Timing timing);
  ~BenchRun();
  BenchRun(BenchRun&&) noexcept;
  BenchRun& operator=(BenchRun&&) noexcept;
  BenchRun(const BenchRun&) = delete;
  BenchRun& operator=(const BenchRun&) = delete;

  /// Runs `warmUp` frames (and frame 0 before the first), then `frames` that are added to times(). Calls
  /// `done` after each of either; leaves early, with what it has, once it returns false. Throws
  /// UserError(device) when the state is lost.
  void run(int warmUp, int frames, const std::function<bool()>& done);
  /// Draws the last frame once more, untimed, for times().rays.
  void countRays();
  [[nodiscard]] const FrameTimes& times() const;
  [[nodiscard]] const scene::Scene& scene() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace simreel::frame
