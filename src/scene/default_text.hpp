#pragma once
#include "scene/animated.hpp"

#include <string>

#include <fmt/format.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace simreel::scene {

/// A default as JSON that reads the way it was written in the source: 0.05F is 0.05, not
/// 0.05000000074505806.
template <class Number>
[[nodiscard]] nlohmann::ordered_json shortest(Number value) {
  return nlohmann::ordered_json::parse(fmt::format("{}", value));
}
[[nodiscard]] inline nlohmann::ordered_json shortest(const glm::vec3& value) {
  return {shortest(value.x), shortest(value.y), shortest(value.z)};
}
[[nodiscard]] inline nlohmann::ordered_json shortest(const glm::ivec2& value) {
  return {value.x, value.y};
}

/// Of a value that moves: how it is written with keyframes.
template <class T>
[[nodiscard]] nlohmann::ordered_json shortest(const Animated<T>& value) {
  if (!value.moves()) return shortest(value.at(0.0));
  nlohmann::ordered_json keys = nlohmann::ordered_json::array();
  for (const auto& key : value.keys())
    keys.push_back(nlohmann::ordered_json::array({shortest(key.time), shortest(key.value)}));
  return {{"keys", keys}, {"ease", value.ease() == Ease::smooth ? "smooth" : "linear"}};
}

}  // namespace simreel::scene
