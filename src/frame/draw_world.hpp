#pragma once
#include "draw/screen/renderer.hpp"
#include "sim/world/world.hpp"

namespace simreel::frame {

/// Makes the world pass the previous frame's drawables to the renderer, if the renderer needs them for
/// motion blur or velocities. Call it after Renderer::keepLayers().
inline void followMotion(draw::Renderer& renderer, sim::World& world) {
  if (renderer.hearsBefore())
    world.onFrameBefore([&renderer](const sim::Drawables& before) { renderer.keepBefore(before); });
}

/// Draws the world's current frame. If a simulation's draw buffers turn out to be too small, World::grow()
/// enlarges them and the frame is drawn again, so no incomplete frame is output. The usual case needs no
/// redraw: the device draws while the CPU checks.
inline void drawWorld(draw::Renderer& renderer, sim::World& world,
                      const draw::Renderer::StageWatch& watch = {}) {
  renderer.draw(world.time(), world.drawables(), watch);
  while (world.grow()) renderer.draw(world.time(), world.drawables(), watch);
}

}  // namespace simreel::frame
