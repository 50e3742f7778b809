#pragma once
#include "golden/trace/lines.hpp"
#include "golden/trace/passes.hpp"
#include "scene/scene.hpp"
#include "sim/world/world.hpp"

#include <functional>
#include <span>
#include <string>

namespace simreel::golden {

/// Takes a line without its end; false: nobody reads on.
using TakeLine = std::function<bool(const std::string& line)>;

/// A line for the state at each frame from `first` to `last`. Throws UserError(device) when the state is
/// lost, after the lines of the frames before. `pictures`: the scene, whose pictures are drawn from frame 0
/// on, and the lines have their passes.
void traceFrames(sim::World& world, int first, int last, const TakeLine& take,
                 const scene::Scene* pictures = nullptr);
/// A line for the state after each step of `frame`, object by object.
void traceSteps(sim::World& world, int frame, const TakeLine& take);
/// Every array after step `step` of `frame`, counted from 1; where an object takes fewer steps, after its
/// last. Step 0 is for the first frame: the state before any step. Throws UserError(usage) for a step that
/// the frame does not have.
[[nodiscard]] StateDump dumpState(sim::World& world, int frame, int step);

/// Calls `take` with what the passes of each of the frames' pictures left; frames ascend, from 0 on. Throws
/// UserError(usage) unless the scene's rasterizer is the exact one.
void drawPasses(const scene::Scene& scene, sim::World& world, std::span<const int> frames,
                const std::function<void(const PassDump& drawn)>& take);

}  // namespace simreel::golden
