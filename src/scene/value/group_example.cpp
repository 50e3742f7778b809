#include "scene/value/group_example.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace simreel::scene {

std::string expectedGroup(std::string_view key) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 9> examples = {{
      {"panels", R"(views by name, such as {"above": {"view": "top"}})"},
      {"lights", R"(lamps by name, such as {"lamp": {"position": [0, 3, 2]}})"},
      {"material", R"(an object, such as {"color": "gold", "metallic": 1})"},
      {"camera", R"(an object, such as {"position": [4, 2, 6]})"},
      {"sun", R"(an object, such as {"intensity": 3}; 0 turns the sun off)"},
      {"sky", R"(an object, such as {"ambient": 0.5}; "stage": "sunset" is a preset)"},
      {"ground", R"(true, false or an object, such as {"color": "grey"})"},
      {"render", R"(an object, such as {"size": [640, 360]})"},
      {"time", R"(an object, such as {"duration": 4})"},
  }};
  const auto* const found =
      std::find_if(examples.begin(), examples.end(), [&](const auto& one) { return one.first == key; });
  return std::string(found == examples.end() ? "an object" : found->second);
}

}  // namespace simreel::scene
