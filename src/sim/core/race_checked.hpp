#pragma once
#include <string>
#include <vector>

namespace simreel::sim {

/// A simulation whose dispatches can be searched for races: kernels in which an invocation reads or writes
/// what another invocation of the same dispatch writes, so that the result depends on the machine.
class RaceChecked {
 public:
  virtual ~RaceChecked() = default;
  /// Runs the next frame's steps twice over, in checking variants of the kernels, and puts the present state
  /// back. Returns a line for each place of a kernel that races; each kernel is searched once. Waits for the
  /// GPU.
  [[nodiscard]] virtual std::vector<std::string> races(double time) = 0;
};

}  // namespace simreel::sim
