#pragma once
#include <string>
#include <vector>

namespace simreel::sim {

/// Simulation whose dispatches can be checked for data races. A race occurs if an invocation reads or
/// writes memory that another invocation of the same dispatch writes; the result then depends on the
/// machine.
class RaceChecked {
 public:
  virtual ~RaceChecked() = default;
  /// Runs the steps of the next frame twice with checking variants of the kernels, then restores the
  /// current state. Returns one line for each kernel statement with a race; each kernel is checked once.
  /// Waits for the GPU.
  [[nodiscard]] virtual std::vector<std::string> races(double time) = 0;
};

}  // namespace simreel::sim
