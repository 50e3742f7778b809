#pragma once
#include "draw/screen/renderer.hpp"
#include "sim/world/world.hpp"

namespace simreel::frame {

/// From now on the renderer hears of the frame before each that the world advances to, as motion blur and
/// velocities ask for: after keepLayers().
inline void followMotion(draw::Renderer& renderer, sim::World& world) {
  if (renderer.hearsBefore())
    world.onFrameBefore([&renderer](const sim::Drawables& before) { renderer.keepBefore(before); });
}

/// Draws the world as it is. What turns out to have lacked memory gets it, and everything is drawn again,
/// so that no frame leaves without it; where all had enough, which is nearly always, the device is never
/// idle: it draws while the CPU hears so.
inline void drawWorld(draw::Renderer& renderer, sim::World& world,
                      const draw::Renderer::StageWatch& watch = {}) {
  renderer.draw(world.time(), world.drawables(), watch);
  while (world.grow()) renderer.draw(world.time(), world.drawables(), watch);
}

}  // namespace simreel::frame
