#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace simreel::sim {

/// Member of the elements of a state array: a number, or an array of numbers without gaps.
struct StateMember {
  enum class Number { float32, float64, int32, uint32 };
  std::string name;  ///< path, such as "material.color"; empty if the element is the number or array itself
  Number number = Number::float32;
  std::vector<std::size_t> shape;  ///< slowest axis first; empty for one number
  std::size_t offset = 0;          ///< bytes from the start of the element
};

/// Layout of a state array in its buffer.
struct StateLayout {
  std::vector<std::size_t> shape;  ///< number of elements along each axis, slowest axis first
  std::size_t offset = 0;          ///< bytes before the first element
  std::size_t stride = 16;         ///< bytes from one element to the next
  std::vector<StateMember> members;
};

/// Simulation whose state arrays have elements of other types than four words.
class LaidOut {
 public:
  virtual ~LaidOut() = default;
  /// Returns the layouts of the arrays in the order of Simulation::state().
  [[nodiscard]] virtual std::vector<StateLayout> layouts() const = 0;
};

}  // namespace simreel::sim
