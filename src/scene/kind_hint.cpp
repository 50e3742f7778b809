#include "scene/kind_hint.hpp"

#include "scene/json/words.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace simreel::scene {

std::string hintForKind(const std::string& key, std::span<const Kind> kinds) {
  constexpr std::array ofMaterials = {"color",        "texture",      "roughness", "metallic",
                                      "translucency", "transmission", "emission",  "opacity"};
  if (std::find(ofMaterials.begin(), ofMaterials.end(), key) != ofMaterials.end())
    return fmt::format("it is part of a material: \"material\": {{\"{}\": ...}}", key);
  constexpr std::array<std::pair<const char*, const char*>, 8> otherWords = {{{"cube", "box"},
                                                                              {"ball", "sphere"},
                                                                              {"rod", "capsule"},
                                                                              {"ring", "torus"},
                                                                              {"circle", "disc"},
                                                                              {"model", "mesh"},
                                                                              {"smoke", "fluid"},
                                                                              {"sheet", "cloth"}}};
  for (const auto& [word, kind] : otherWords)
    if (key == word) return fmt::format("did you mean \"{}\"?", kind);
  std::vector<std::string> names;
  for (const Kind& kind : kinds) names.emplace_back(kind.name);
  names.emplace_back("material");
  return suggestion(key, names);
}

}  // namespace simreel::scene
