// -D: each line of the input changes one value of a scene that has something of everything.
#include "base/error.hpp"
#include "fuzz/reader.hpp"
#include "scene/scene.hpp"
#include "sim/world/list.hpp"

namespace {

constexpr const char* whole = R"({"version": 1, "title": "t", "seed": 7,
 "render": {"size": [64, 32], "exposure": {"keys": [[0, 1], [1.5, -2]], "ease": "smooth"}},
 "time": {"fps": 30, "duration": 1}, "camera": {"position": {"keys": [[0, [1, 2, 3]]]}}, "ground": {"height": -1},
 "objects": {
  "flag": {"cloth": {"pins": [{"row": 1}, {}]}, "material": {"color": [1, 0, 0.5]}},
  "ball": {"sphere": {"radius": 1}}, "skin": {"gray-scott": {"size": [64, 64]}},
  "cells": {"life": {"size": [64, 64], "fill": 0.3}}, "stars": {"particles": {"count": 10}}},
 "test": {"frames": [0]}, "checks": [{"what": "no-nan"}]})";
constexpr std::size_t maxLines = 8;

}  // namespace

void simreel::fuzz::read(std::string_view bytes) {
  std::vector<scene::Override> changes;
  while (!bytes.empty() && changes.size() < maxLines) {
    const auto end = bytes.find('\n');
    changes.push_back(scene::parseOverride(bytes.substr(0, end)));
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
  }
  const scene::Scene scene = scene::parseScene(whole, "fuzz.json", changes, sim::kinds());
  SIMREEL_CHECK(scene.frameCount() >= 1);
}
