#pragma once
#include "gl/context.hpp"
#include "scene/scene.hpp"
#include "sim/core/numerics.hpp"

namespace CLI {
class App;
}

namespace simreel::cli {

/// --device and --memory-path.
void addDevice(CLI::App& command, gl::ContextOptions& options);

/// Throws UserError(device) where the scene wants exact numerics and the device does not compute so.
void requireExact(const scene::Scene& scene, const sim::Numerics& numerics);

}  // namespace simreel::cli
