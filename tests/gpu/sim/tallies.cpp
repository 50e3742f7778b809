// Tests the columns that fluids and water add to the table of frames. The GPU's sums must equal
// double-precision sums of the state that is read back.
#include "gpu/context.hpp"
#include "scene/load.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <bit>
#include <cmath>
#include <map>
#include <string>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

/// Returns the columns of an object for the current frame, by name.
std::map<std::string, double> tallyOf(sim::World& world) {
  world.startSummary();
  const auto summary = world.takeSummary(true);
  const auto names = world.countNames().at(0);
  REQUIRE(names.measured);
  REQUIRE(summary->counts.at(0).size() == static_cast<std::size_t>(names.elements));
  std::map<std::string, double> values;
  for (std::size_t c = 0; c < names.columns.size(); ++c)
    values[names.columns[c]] = std::bit_cast<float>(summary->counts[0][c / 4][static_cast<int>(c % 4)]);
  return values;
}

void checkTally(const std::string& object, int frames) {
  testContext();
  const auto scene = scene::parseScene(R"({"version": 1, "seed": 5, "objects": {"it": {)" + object + "}}}",
                                       "test.json", {}, sim::kinds());
  const auto quantities = scene.objects.at(0).parameters->quantities();
  sim::World world(scene);
  for (int frame = 0; frame <= frames; frame += frames) {
    CAPTURE(frame);
    world.advanceTo(frame);
    const auto tally = tallyOf(world);
    const auto measured = world.object(0).measure();
    std::size_t found = 0;
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      const auto column = tally.find(quantities[i].name);
      if (column == tally.end()) continue;
      ++found;
      CAPTURE(quantities[i].name);
      CHECK(std::abs(column->second - measured[i]) <= 3e-6 * std::abs(measured[i]) + 1e-12);
    }
    CHECK(found == tally.size());
  }
  testContext().check();
}

}  // namespace

TEST_CASE("tallies: a fluid's sums equal its measured quantities") {
  checkTally(R"("fluid": {"size": [61, 37], "speed": 90, "lift": 20, "viscosity": 2,
    "obstacles": [{"center": [30, 20, 0], "radius": 5}, {"center": [0, 0, 0], "radius": 7}],
    "strokes": [{"until": 9, "from": [12, 12, 0], "radius": 4, "velocity": [60, -25, 0], "temperature": 2,
      "dye": [1, 0.4, 0.2]}]})",
             4);
}

TEST_CASE("tallies: water's sums equal its measured quantities") {
  checkTally(R"("water": {"size": [151, 117], "cell": 0.2, "level": 0,
    "terrain": {"bed": -0.6, "hills": [{"center": [3, 0, 1], "radii": [4, 0, 3], "height": 1.4}]},
    "drops": [{"at": 0, "center": [-6, 0, 2], "radius": 2, "height": 0.4}]})",
             5);
}
