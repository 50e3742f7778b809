// Tests sources of water that move and change by keyframes.
#include "scene/load.hpp"
#include "sim/water/plan.hpp"
#include "sim/world/list.hpp"

#include <cmath>

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("keyed strokes: a water source follows its keyframed strength") {
  const auto scene = scene::parseScene(R"({"version": 1, "objects": {"it": {"water": {"size": [40, 30],
      "substeps": 4, "strokes": [{"until": 9, "radius": 3, "value": 0.5,
        "path": {"keys": [[0, [5, 5, 0]], [2, [25, 5, 0]]]}, "strength": {"keys": [[0, 0], [2, 4]]}}]}}}})",
                                       "test.json", {}, sim::kinds());
  const auto& p = dynamic_cast<const sim::WaterParameters&>(*scene.objects.at(0).parameters);
  const sim::WaterPlan plan(p, "it", 1, 0.5);
  const auto falls = plan.fallsAt(0.5, 4);  // sources at the time 1 s
  REQUIRE(falls.strokes.size() == 1);
  CHECK(std::abs(falls.strokes[0].value - 0.5F * 2 * 0.125F) <
        1e-7F);  // The expected amount is what the source adds in an eighth of a second.
  CHECK(falls.strokes[0].to == glm::vec2(15, 5));
}
