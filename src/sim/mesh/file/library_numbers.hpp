#pragma once
#include <array>
#include <optional>
#include <string_view>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Numeric key of a material in an OBJ's material library.
struct NumberKey {
  std::string_view key;
  int numbers;  ///< maximum number of values after the key
  double max;   ///< largest meaningful value
};

inline constexpr double unboundedKey = 1e30;  ///< `NumberKey::max` of a key without an upper bound

/// Returns the numeric key with the given name; null if the key is unknown or not numeric.
const NumberKey* findNumberKey(std::string_view key);

/// Returns the first three numbers of a text, clamped to 0..`max`. A missing number repeats the previous
/// one.
std::array<float, 3> numbersIn(std::string_view text, float max);

/// Returns the first three numbers of a text as a colour, clamped to 0..`max`.
glm::vec3 colorIn(std::string_view text, float max);

/// Returns the first word of a text as a number, clamped to +-1e6; nullopt if it is not a number.
std::optional<float> numberIn(std::string_view text);

}  // namespace simreel::sim
