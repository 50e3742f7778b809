#pragma once
#include "sim/world/world.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::frame {

/// One array or number of what a world carries from a frame to the next.
struct StatePart {
  std::string object, name;
  std::size_t bytes = 0;
};

/// The state between two frames of a simulation, on the CPU: what a checkpoint has on disk, and what a
/// player goes back to.
struct WorldState {
  int frame = 0;
  std::vector<StatePart> parts;
  std::string bytes;  ///< of all parts, one after the other
};

/// Reads the world's state back; waits for the GPU.
[[nodiscard]] WorldState stateOf(sim::World& world);

/// Puts parts back into the world of the same simulation, whose present frame is `frame` then. `from` names
/// them in the UserError(usage) thrown where one does not fit, as those of another simulation; the world is
/// of no use then.
void putBack(sim::World& world, int frame, const std::vector<StatePart>& parts, std::string_view bytes,
             const std::string& from);

}  // namespace simreel::frame
