#pragma once
#include "sim/world/world.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::frame {

/// Name and size of one array or number of the state that a world keeps from frame to frame.
struct StatePart {
  std::string object, name;
  std::size_t bytes = 0;
};

/// State of a simulation between two frames, in CPU memory. A checkpoint stores it on disk. The player
/// restores it to jump back.
struct WorldState {
  int frame = 0;
  std::vector<StatePart> parts;
  std::string bytes;  ///< concatenated bytes of all parts
};

/// Reads back the world's state. Waits for the GPU.
[[nodiscard]] WorldState stateOf(sim::World& world);

/// Restores parts into a world of the same simulation, and sets the world's current frame to `frame`.
/// Throws UserError(usage) if a part does not fit, for example because it belongs to another simulation.
/// The world is then unusable. `from`: origin of the parts, for the message.
void putBack(sim::World& world, int frame, const std::vector<StatePart>& parts, std::string_view bytes,
             const std::string& from);

}  // namespace simreel::frame
