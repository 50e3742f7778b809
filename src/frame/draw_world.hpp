#pragma once
#include "draw/screen/renderer.hpp"
#include "sim/world/world.hpp"

namespace simreel::frame {

/// Makes the world pass the previous frame's drawables to the renderer, if the renderer needs them for
/// motion blur or velocities. Must be called after Renderer::keepLayers().
inline void followMotion(draw::Renderer& renderer, sim::World& world) {
  if (renderer.needsPreviousFrame())
    world.onFrameBefore([&renderer](const sim::Drawables& before) { renderer.setPreviousFrame(before); });
}

/// Draws the world's current frame. If a simulation's draw buffers are too small, World::grow() enlarges
/// them and the frame is drawn again, so that incomplete frames are never output. The CPU checks the
/// buffers while the device draws.
inline void drawWorld(draw::Renderer& renderer, sim::World& world,
                      const draw::Renderer::StageWatch& watch = {}) {
  renderer.draw(world.time(), world.drawables(), watch);
  while (world.grow()) renderer.draw(world.time(), world.drawables(), watch);
}

}  // namespace simreel::frame
