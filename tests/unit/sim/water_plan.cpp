#include "base/error.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/water/plan.hpp"
#include "sim/world/list.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

std::string waterFailure(const std::string& members) {
  try {
    static_cast<void>(scene::parseScene(R"({"version": 1, "objects": {"w": {"water": {)" + members + "}}}}",
                                        "test.json", {}, sim::kinds()));
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    return error.what();
  }
  return "no failure";
}

}  // namespace

TEST_CASE("water: \"auto\" substeps limit motion to a quarter cell per step") {
  sim::WaterParameters p;
  p.size = {5, 4};
  p.cell = 0.1F;
  p.bed = 0;
  p.level = 1;
  // The speed is sqrt(9.81) + sqrt(9.81) = 6.264 m/s. This is 0.2088 m per frame, which is 8.35 quarters of
  // a cell.
  CHECK(sim::WaterPlan(p, "w", 1, 1.0 / 30).substeps() == 9);
  p.greatestSpeed = 0;
  CHECK(sim::WaterPlan(p, "w", 1, 1.0 / 30).substeps() == 5);
  p.greatestDepth = 4;
  CHECK(sim::WaterPlan(p, "w", 1, 1.0 / 30).substeps() == 9);
  p.cell = 1e-3F;
  CHECK_THROWS_AS(sim::WaterPlan(p, "w", 1, 1000.0), UserError);
}

TEST_CASE("water: each drop falls into one state, in any frame") {
  sim::WaterParameters p;
  p.size = {60, 40};
  p.rain.emplace();
  p.rain->rate = 37;
  p.rain->from = 0.2;
  p.rain->until = 2;
  p.drops = {{0.5, {0, 0, 0}, 0.2F, 0.1F}, {0, {0, 0, 0}, 0.2F, 0.1F}};
  const sim::WaterPlan plan(p, "w", 1, 1.0 / 30);
  std::size_t drops = plan.fallsAt(0, 0).drops.size();
  CHECK(drops == 1);
  for (int frame = 0; frame < 90; ++frame)
    for (int i = 1; i <= plan.substeps(); ++i) {
      const sim::WaterFalls falls = plan.fallsAt(frame / 30.0, i);
      drops += falls.drops.size();
      for (const shader::WaterDrop& drop : falls.drops) CHECK(plan.box(drop).z > 0);
    }
  CHECK(drops == 2 + 67);  // Drops fall at 0.2 s and then every 1/37 s up to 2 s.
}

TEST_CASE("water: a drop's water arrives over its duration, and drops vary around the mean height") {
  sim::WaterParameters p;
  p.size = {60, 40};
  p.cell = 0.05F;
  p.rain = {.rate = 40,
            .radius = 0.2F,
            .height = 0.1F,
            .duration = 0.1,
            .variation = 0.5,
            .from = 0.2,
            .until = 4.2};
  const sim::WaterPlan plan(p, "w", 1, 1.0 / 30);
  std::map<std::pair<float, float>, std::vector<double>> drops;
  for (int frame = 0; frame < 150; ++frame)
    for (int i = 1; i <= plan.substeps(); ++i)
      for (const shader::WaterDrop& drop : plan.fallsAt(frame / 30.0, i).drops)
        drops[{drop.center.x, drop.center.y}].push_back(static_cast<double>(drop.height));
  CHECK(drops.size() == doctest::Approx(160).epsilon(0.02));
  double least = 1, most = 0, sum = 0;
  for (const auto& [place, heights] : drops) {
    const double whole = std::accumulate(heights.begin(), heights.end(), 0.0);
    least = std::min(least, whole);
    most = std::max(most, whole);
    sum += whole;
    CHECK(static_cast<double>(heights.size()) * plan.stepSeconds() == doctest::Approx(0.1).epsilon(0.15));
    CHECK(*std::max_element(heights.begin(), heights.end()) < 1.6 * whole * plan.stepSeconds() / 0.1);
  }
  CHECK(least == doctest::Approx(0.05).epsilon(0.1));
  CHECK(most == doctest::Approx(0.15).epsilon(0.1));
  CHECK(sum / static_cast<double>(drops.size()) == doctest::Approx(0.1).epsilon(0.06));
}

TEST_CASE("water: errors are reported at their place") {
  CHECK(waterFailure("") == "no failure");
  test::checkHas(waterFailure(R"("sides": {"west": "periodic"})"), "periodic together or not at all");
  test::checkHas(waterFailure(R"("terrain": {"low": 1})"), "give \"image\"");
  test::checkHas(waterFailure(R"("terrain": {"repeat": 2})"), "give \"texture\"");
  test::checkHas(waterFailure(R"("terrain": {"hills": [{"radii": [0, 0, 1]}]})"), "at least 0.001 m");
  test::checkHas(waterFailure(R"("grip": 2)"), "with \"collides\": true");
  test::checkHas(waterFailure(R"("size": [16384, 16384])"), "more than");
  test::checkHas(waterFailure(R"("size": [1, 5])"), "size");
  test::checkHas(waterFailure(R"("swell": [{"side": "west"}])"), "a side that is \"sea\"");
  test::checkHas(waterFailure(R"("floats": [{"shape": "file"}])"), "needs \"file\"");
  test::checkHas(waterFailure(R"("floats": [{"size": [1, 1, 1]}])"), "\"size\" is only for a \"box\"");
  test::checkHas(waterFailure(R"("floats": [{"mass": 3, "density": 20}])"), "leave out \"density\"");
  test::checkHas(waterFailure(R"("floats": [{"scale": 3}])"), "give \"drawn\"");
}

TEST_CASE("water: a float too large for a window of cells is refused") {
  sim::WaterParameters p;
  p.cell = 0.01F;
  p.floats.resize(1);
  p.floats[0].radius = 20;
  CHECK_THROWS_WITH_AS(sim::WaterPlan(p, "w", 1, 1.0 / 30),
                       doctest::Contains("and the maximum is 1024; make it smaller"), UserError);
}
