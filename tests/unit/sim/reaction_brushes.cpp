// Tests that strokes in volumes and on meshes paint the cells within the brush's radius of their path, with
// distances in double precision.
#include "base/error.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/reaction/plan.hpp"
#include "sim/world/list.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

constexpr double brushFrame = 0.5;

sim::ReactionParameters brushed(const std::string& members) {
  const auto scene = scene::parseScene(
      R"({"version": 1, "objects": {"r": {"reaction": {"steps": 1, "species": {"u": {}, "v": {}}, )" +
          members + "}}}}",
      "s.json", {}, sim::kinds());
  return dynamic_cast<const sim::ReactionParameters&>(*scene.objects.at(0).parameters);
}

std::string brushRefusal(const std::string& members) {
  try {
    static_cast<void>(sim::ReactionPlan(brushed(members), "r", 1, brushFrame));
    return "none";
  } catch (const UserError& error) {
    return error.what();
  }
}

/// Returns the values of "v" that the strokes paint in one frame.
std::vector<float> paintedAfter(const sim::ReactionPlan& plan, double time) {
  sim::RuleField field = plan.firstField();
  for (const auto& painted : plan.strokesAt(time, 1)) sim::evaluateBrush(painted, field);
  return field.stage[1];
}

double distanceToWay(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b) {
  const double length2 = glm::dot(b - a, b - a);
  const double along = length2 > 0 ? std::clamp(glm::dot(p - a, b - a) / length2, 0.0, 1.0) : 0.0;
  return glm::length(p - (a + along * (b - a)));
}

}  // namespace

TEST_CASE("a stroke in a volume paints the cells around its path, across the borders of a torus") {
  const glm::ivec3 size(13, 11, 9);
  const std::string stroke =
      R"("size": [13, 11], "depth": 9, "strokes": [{"species": "v", "until": 1, "from": [1.3, 9.2, 7.9], "to": [9.1, 12.4, 10.2], "radius": 2.21, "value": 3}], )";
  for (const bool torus : {true, false}) {
    const sim::ReactionPlan plan(
        brushed(stroke + (torus ? R"("boundary": "torus")" : R"("boundary": "no-flux")")), "r", 1,
        brushFrame);
    const std::vector<float> got = paintedAfter(plan, 0);
    // From time 0 to the frame's end at 0.5 s, the brush covers half of its path.
    const glm::dvec3 from(1.3, 9.2, 7.9), to = 0.5 * (from + glm::dvec3(9.1, 12.4, 10.2));
    std::size_t cell = 0, reached = 0;
    for (int z = 0; z < size.z; ++z)
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x, ++cell) {
          double nearest = 1e9;
          for (int k = torus ? -2 : 0; k <= (torus ? 2 : 0); ++k)
            for (int j = torus ? -2 : 0; j <= (torus ? 2 : 0); ++j)
              for (int i = torus ? -2 : 0; i <= (torus ? 2 : 0); ++i)
                nearest = std::min(
                    nearest, distanceToWay(glm::dvec3(x + i * size.x, y + j * size.y, z + k * size.z) + 0.5,
                                           from, to));
          CHECK((got[cell] == (nearest <= 2.21 ? 3.0F : 0.0F)));
          reached += nearest <= 2.21 ? 1 : 0;
        }
    CHECK(reached > (torus ? 80 : 40));
    CHECK(reached < 200);
  }
}

TEST_CASE("a stroke on a mesh paints the vertices near it at the mesh's current position") {
  const sim::ReactionPlan plan(
      brushed(
          R"("mesh": {"shape": "torus", "radius": 1, "tube": 0.4, "resolution": [30, 18], "rotation": [20, 40, 70], "scale": 1.7,
              "position": {"keys": [[0, [0, 0, 0]], [1, [2, 1, -1]]]}},
              "strokes": [{"species": "v", "at": 0.5, "from": [2.1, 1.3, 0.2], "radius": 0.83, "value": 2}])"),
      "r", 1, brushFrame);
  const std::vector<float> got = paintedAfter(plan, 0);
  const glm::dmat4 model(plan.parameters().mesh->model(0.5));
  std::size_t reached = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double distance =
        glm::length(glm::dvec3(model * glm::dvec4(plan.cells().places[i], 1)) - glm::dvec3(2.1, 1.3, 0.2));
    if (std::abs(distance - 0.83) < 1e-5) continue;
    CHECK((got[i] == (distance <= 0.83 ? 2.0F : 0.0F)));
    reached += distance <= 0.83 ? 1 : 0;
  }
  CHECK(reached > 10);
  CHECK(reached < got.size() / 2);
}

TEST_CASE("strokes in space: errors are reported in one line") {
  const std::string deep = R"("size": [8, 8], "depth": 8, )";
  test::checkHas(brushRefusal(deep + R"("strokes": [{"shape": "image", "image": "textures/boat.png"}])"),
                 "can be painted only on flat grids");
  test::checkHas(brushRefusal(deep + R"("strokes": [{"shape": "line", "to": [0, 0, 80]}])"),
                 "strokes[0] wraps around the torus of 8x8x8 cells 10 times at once, but at most 8");
}
