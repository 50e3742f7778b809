#pragma once
#include "golden/trace/lines.hpp"
#include "golden/trace/passes.hpp"
#include "scene/scene.hpp"
#include "sim/world/world.hpp"

#include <functional>
#include <span>
#include <string>

namespace simreel::golden {

/// Callback that receives a line without its line end. Returns false to stop.
using LineSink = std::function<bool(const std::string& line)>;

/// Writes a line with the state hashes of each frame from `first` to `last`. If `pictures` is a scene, also
/// draws its pictures from frame 0 on and adds their pass hashes. If the state is lost, throws
/// UserError(device) after writing the lines of earlier frames.
void traceFrames(sim::World& world, int first, int last, const LineSink& sink,
                 const scene::Scene* pictures = nullptr);
/// Writes a line with the state hashes after each step of `frame`, object by object.
void traceSteps(sim::World& world, int frame, const LineSink& sink);
/// Returns every array after step `step` (from 1) of `frame`. Objects with fewer steps are read after their
/// last step. Step 0 of the first frame is the state before any step. Throws UserError(usage) if the frame
/// has no such step.
[[nodiscard]] StateDump dumpState(sim::World& world, int frame, int step);

/// Draws the given frames and calls `sink` with everything that the passes of each picture wrote. Frames
/// must ascend and start at 0 or later. Throws UserError(usage) unless the scene uses the exact rasterizer.
void drawPasses(const scene::Scene& scene, sim::World& world, std::span<const int> frames,
                const std::function<void(const PassDump& drawn)>& sink);

}  // namespace simreel::golden
