// Fuzzes -D. Each line of the input changes one value of a scene that uses every feature.
#include "base/error.hpp"
#include "fuzz/reader.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/world/list.hpp"

namespace simreel::fuzz {
namespace {

constexpr const char* whole = R"({"version": 1, "title": "t", "seed": 7,
 "render": {"size": [64, 32], "exposure": {"keys": [[0, 1], [1.5, -2]], "ease": "smooth"}},
 "time": {"fps": 30, "duration": 1}, "camera": {"position": {"keys": [[0, [1, 2, 3]]]}}, "ground": {"height": -1},
 "lights": {"lamp": {"position": [0, 1, 0]}},
 "objects": {
  "flag": {"cloth": {"pins": [{"rows": [0, 0]}]}, "material": {"color": [1, 0, 0.5]}},
  "ball": {"sphere": {"radius": 1}}, "skin": {"grayScott": {"size": [64, 64]}},
  "cells": {"life": {"size": [64, 64], "fill": 0.3}}, "stars": {"particles": {"groups": [{"shape": "disk", "count": 10, "radius": 1}]}}},
 "test": {"frames": [0]}, "checks": [{"what": "no-nan"}]})";
constexpr std::size_t maxLines = 8;

/// True if the unchanged scene is valid. If it were not, every input would be refused.
bool good() {
  try {
    static_cast<void>(scene::parseScene(whole, "fuzz.json", {}, sim::kinds()));
    return true;
  } catch (const UserError&) {
    return false;
  }
}

void readOverride(std::string_view bytes) {
  static const bool usable = good();
  SIMREEL_CHECK(usable);
  std::vector<scene::Override> changes;
  while (!bytes.empty() && changes.size() < maxLines) {
    const auto end = bytes.find('\n');
    changes.push_back(scene::parseOverride(bytes.substr(0, end)));
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
  }
  const scene::Scene scene = scene::parseScene(whole, "fuzz.json", changes, sim::kinds());
  SIMREEL_CHECK(scene.frameCount() >= 1);
}

const Reader overrideReader("override", readOverride);

}  // namespace
}  // namespace simreel::fuzz
