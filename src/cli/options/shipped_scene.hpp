#pragma once

namespace CLI {
class Option;
}

namespace simreel::cli {

/// Passes a scene argument through scene::sceneFile(). Sets `shipped` to true if the argument names a
/// shipped scene.
void findShipped(CLI::Option& option, bool* shipped = nullptr);

}  // namespace simreel::cli
