#include "sim/mesh/file/library_numbers.hpp"

#include "sim/polygons/words.hpp"

#include <algorithm>
#include <cmath>

namespace simreel::sim {

namespace {

constexpr std::array<NumberKey, 16> numberKeys = {{{"Kd", 3, 1},
                                                   {"Ke", 3, 1e6},
                                                   {"Pr", 1, 1},
                                                   {"Pm", 1, 1},
                                                   {"Ns", 1, unboundedKey},
                                                   {"Pc", 1, 1},
                                                   {"Pcr", 1, 1},
                                                   {"d", 1, 1},
                                                   {"Tr", 1, 1},
                                                   {"Tf", 3, unboundedKey},
                                                   {"aniso", 1, unboundedKey},
                                                   {"Ps", 1, unboundedKey},
                                                   {"Ka", 3, unboundedKey},
                                                   {"Ks", 3, unboundedKey},
                                                   {"Ni", 1, unboundedKey},
                                                   {"illum", 1, unboundedKey}}};

}  // namespace

std::array<float, 3> numbersIn(std::string_view text, float max) {
  std::array<float, 3> numbers{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<double> value = doubleIn(takeWord(text));
    numbers[i] = !value                  ? (i == 0 ? 0.0F : numbers[i - 1])
                 : std::isfinite(*value) ? static_cast<float>(std::clamp(*value, 0.0, double{max}))
                                         : 0.0F;
  }
  return numbers;
}

const NumberKey* findNumberKey(std::string_view key) {
  const auto* const known =
      std::find_if(numberKeys.begin(), numberKeys.end(), [&](const NumberKey& k) { return k.key == key; });
  return known == numberKeys.end() ? nullptr : known;
}

std::optional<float> numberIn(std::string_view text) {
  const std::optional<double> value = doubleIn(takeWord(text));
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return static_cast<float>(std::clamp(*value, -1e6, 1e6));
}

glm::vec3 colorIn(std::string_view text, float max) {
  const std::array<float, 3> v = numbersIn(text, max);
  return {v[0], v[1], v[2]};
}

}  // namespace simreel::sim
