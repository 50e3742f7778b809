// Tests the worked example of src/sim/README.md, which is built from its listings. It must compile, its
// scene must be valid, and it must follow the heat equation.
#include "sim/heat/heat.hpp"

#include "base/error.hpp"
#include "gpu/context.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "source_folder.hpp"

#include <cstdlib>
#include <filesystem>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

/// Adds the example's shaders to the program's shaders for its lifetime.
class ExampleShaders {
 public:
  ExampleShaders() : folder_(std::filesystem::path(EXAMPLE_FOLDER) / "glsl") {
    std::filesystem::copy(
        std::filesystem::path(sourceFolder()) / "glsl", folder_,
        std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
    setenv("SIMREEL_GLSL", folder_.c_str(), 1);  // NOLINT(concurrency-mt-unsafe): one thread
  }
  ~ExampleShaders() { unsetenv("SIMREEL_GLSL"); }  // NOLINT(concurrency-mt-unsafe): one thread
  ExampleShaders(const ExampleShaders&) = delete;
  ExampleShaders& operator=(const ExampleShaders&) = delete;

 private:
  std::filesystem::path folder_;
};

}  // namespace

TEST_CASE("example: the heat of the README spreads as the heat equation says") {
  testContext();
  const ExampleShaders shaders;
  const sim::SimulationKind kind = sim::heatKind();
  const scene::Kinds kinds{std::span(&kind.kind, 1)};
  const scene::Scene scene =
      scene::loadScene(std::filesystem::path(EXAMPLE_FOLDER) / "assets/scenes/heat.json", {}, kinds);
  REQUIRE(scene.objects.size() == 1);
  sim::Setting setting;
  setting.frameSeconds = 1.0 / scene.time.fps;

  SUBCASE("its scene stays between the temperatures that it is given") {
    const auto plate = kind.make(scene.objects[0], setting);
    for (int frame = 0; frame < 20; ++frame) plate->step(frame * setting.frameSeconds, {});
    for (const glm::vec4& cell : plate->state()[0].buffer->readAll<glm::vec4>()) {
      REQUIRE(cell.x >= 0);
      REQUIRE(cell.x <= 100);
    }
  }
  SUBCASE("a warm point spreads to a variance of 2 D t and keeps its heat") {
    const scene::Scene point = scene::parseScene(R"({"version": 1, "objects": {"plate": {"heat": {
        "size": [65, 49], "diffusivity": 60, "temperature": 0,
        "disks": [{"center": [32, 24, 0], "radius": 0, "temperature": 100}]}}}})",
                                                 "point.json", {}, kinds);
    const auto plate = kind.make(point.objects[0], setting);
    for (int frame = 0; frame < 8; ++frame) plate->step(frame * setting.frameSeconds, {});
    double sum = 0, variance = 0;
    const auto cells = plate->state()[0].buffer->readAll<glm::vec4>();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double x = static_cast<double>(i % 65) - 32;
      sum += cells[i].x;
      variance += x * x * cells[i].x / 100;
    }
    CHECK(sum == doctest::Approx(100).epsilon(1e-5));
    CHECK(variance == doctest::Approx(2 * 60 * 8 * setting.frameSeconds).epsilon(1e-4));
    CHECK(plate->measure()[0] == doctest::Approx(100.0 / (65 * 49)).epsilon(1e-5));
  }
  SUBCASE("steps that are too few are refused") {
    const scene::Scene fast = scene::parseScene(
        R"({"version": 1, "objects": {"plate": {"heat": {"diffusivity": 1e4, "steps": 1}}}})", "fast.json",
        {}, kinds);
    CHECK_THROWS_AS(kind.check(fast.objects[0], setting), UserError);
  }
}
