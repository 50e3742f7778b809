#include "base/error.hpp"
#include "scene/load.hpp"
#include "sim/gray_scott/plan.hpp"
#include "sim/world/list.hpp"
#include "source_folder.hpp"
#include "unit/help.hpp"

#include <string>

#include <doctest/doctest.h>

using namespace simreel;
using simreel::test::has;

namespace {

/// Returns the errors of a scene with these parameters of the field, or "" for a valid scene.
std::string mistakes(const std::string& parameters) {
  const std::string text = R"({"version": 1, "objects": {"dish": {"grayScott": )" + parameters + "}}}";
  try {
    (void)scene::parseScene(text, sourceFolder() + "/assets/dish.json", {}, sim::kinds());
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("grayScott: errors in a scene are named") {
  CHECK(mistakes("{}").empty());
  CHECK(has(mistakes(R"({"preset": "stripe"})"), "stripes"));
  CHECK(has(mistakes(R"({"dt": 4, "diffuseU": 0.5})"),
            "dt * diffuseU is 2, and a step is stable up to 1.25; lower dt to 2.5 or less"));
  CHECK(mistakes(R"({"dt": 4, "diffuseU": 0.3125})").empty());
  CHECK(has(mistakes(R"({"health": {"level": 0.5}, "feed": 0.03})"), "leave out \"feed\""));
  const std::string flag = "textures/flag.png";
  CHECK(has(mistakes(R"({"feedAcross": 0.06, "feedImage": ")" + flag + "\"}"), "leave out one"));
  CHECK(mistakes(R"({"feedImage": ")" + flag + "\"}").empty());
  CHECK(has(mistakes(R"({"size": [3, 9]})"), "dish.json:1:"));
  CHECK(has(mistakes(R"({"feed": 0.5})"), "0.2"));
  CHECK(has(mistakes(R"({"image": "no such picture.png"})"), "no such picture.png"));
}

TEST_CASE("grayScott: an invalid picture is refused") {
  sim::GrayScottParameters p;
  p.image = sourceFolder() + "/README.md";
  const sim::GrayScottPlan plan(p, "dish", 1, 1.0 / 30);
  try {
    (void)plan.firstCells();
    FAIL("read");
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::inputOutput);
    CHECK(has(error.what(), "README.md"));
  }
}

TEST_CASE("grayScott: the first state has seeds on a torus, and the padding of an odd row repeats cell 0") {
  sim::GrayScottParameters p;
  p.size = {37, 21};
  p.seedCount = 1;
  p.seedRadius = 4;
  p.seedNoise = 0;
  const auto cells = sim::GrayScottPlan(p, "dish", 7, 1.0 / 30).firstCells();
  REQUIRE(cells.size() == 19 * 21);
  int seeded = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t row = i / 19 * 19;
    if (i % 19 == 18) CHECK(glm::vec2(cells[i].z, cells[i].w) == glm::vec2(cells[row]));
    for (const float v : {cells[i].y, i % 19 == 18 ? 0.0F : cells[i].w}) seeded += v == 0.5F ? 1 : 0;
    CHECK(cells[i].x + cells[i].y == 1.0F);
  }
  CHECK(seeded == 49);  // number of grid points in a disc of radius 4
}

TEST_CASE("grayScott: rates come from preset, keys, health, ramp and picture") {
  sim::GrayScottParameters p;
  p.dt = 0.5;
  p.preset = sim::GrayScottPreset::maze;
  CHECK(sim::GrayScottPlan(p, "dish", 1, 0.1).ratesAt(3).feed == doctest::Approx(0.0125));
  p.health = sim::GrayScottHealth{.level = 0.25F,
                                  .well = sim::GrayScottPreset::stripes,   // feed 0.040, kill 0.060
                                  .ill = sim::GrayScottPreset::unstable};  // feed 0.060, kill 0.062
  CHECK(p.ratesAt(0).feed == doctest::Approx(0.055));
  CHECK(p.ratesAt(0).kill == doctest::Approx(0.0615));
  p.health.reset();
  p.size = {5, 4};
  p.feedAcross = 0.065;
  p.killImage = sourceFolder() + "/assets/textures/gingham.png";
  const sim::GrayScottPlan plan(p, "dish", 1, 0.1);
  CHECK(plan.mapped());
  CHECK(plan.ratesAt(0).feedSpan == doctest::Approx(0.02));
  CHECK(plan.ratesAt(0).killSpan == doctest::Approx(0.005));
  const auto weights = plan.weights();
  CHECK(weights[0].x == 0.0F);
  CHECK(weights[1].x == 0.5F);
  CHECK(weights[2].x == 1.0F);
  CHECK(weights[2].z == 0.0F);  // The value is the weight of cell 0, because the grid wraps around.
}
