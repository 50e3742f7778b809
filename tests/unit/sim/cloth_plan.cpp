#include "base/error.hpp"
#include "scene/load.hpp"
#include "sim/cloth/plan.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/world/list.hpp"
#include "source_folder.hpp"
#include "unit/help.hpp"

#include <cmath>
#include <string>

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("a sheet starts flat, centred and pinned at its last row") {
  const sim::ClothPlan plan(sim::ClothParameters{}, 1, 1.0 / 60, {});
  const auto positions = plan.firstPositions();
  REQUIRE(positions.size() == 32 * 32);
  CHECK(positions[0].x == doctest::Approx(-1.55));
  CHECK(positions[0].y == 0.0F);
  CHECK(positions[0].z == doctest::Approx(-1.55));
  CHECK(positions[31].x == doctest::Approx(1.55));
  CHECK(positions[0].w == 1.0F);
  for (std::size_t i = 0; i < 32; ++i) CHECK(positions[31 * 32 + i].w == 0.0F);
}

TEST_CASE("pins are selected by row, column, corner and point") {
  sim::ClothParameters p;
  p.size = {5, 4};
  sim::PinGroup group;
  group.rows = {0};
  group.every = 3;
  CHECK(p.pinnedBy(group) == std::vector<int>{0, 3, 4});
  group = {};
  group.columns = {-1};
  CHECK(p.pinnedBy(group) == std::vector<int>{4, 9, 14, 19});
  group = {};
  group.corners = {1, 2};
  group.points = {{2, 1}, {2, 1}};
  CHECK(p.pinnedBy(group) == std::vector<int>{4, 7, 15});
}

TEST_CASE("\"auto\" takes as many substeps as the springs need") {
  sim::ClothParameters p;
  p.substeps.reset();
  // w = sqrt(4 * 500 * 2.3 / 1) = 67.8 1/s. The stability limit 2 / w is 29.5 ms. 0.7 times the limit is
  // 20.6 ms, so one substep of 16.7 ms is enough.
  CHECK(p.substepsPerFrame(1.0 / 60) == 1);
  p.stiffness = 50000;
  CHECK(p.stableSeconds() == doctest::Approx(2.0 / std::sqrt(4 * 50000 * 2.3)).epsilon(1e-6));
  CHECK(p.substepsPerFrame(1.0 / 60) == 9);
}

TEST_CASE("\"auto\" for a fabric in gusts scales with 1 / L^1.5 for long lines") {
  // The cloth has the parameters of flag.json at several resolutions, as in bench_studies resolution.
  const auto substeps = [](int columns, bool gusts) {
    sim::ClothParameters p;
    p.fabric.emplace();
    p.fabric->material = sim::FabricMaterial::nylon;
    p.substeps.reset();
    p.damping = 0.2F;
    p.wind = glm::vec3(0);
    p.spacing = 95 * 0.0215F / static_cast<float>(columns - 1);
    p.size = {columns, 2 * columns / 3};
    p.air.emplace();
    p.air->velocity = glm::vec3(9.5F, 0.5F, 1.6F);
    p.air->drag = 0.8F;
    p.air->lift = 0.15F;
    p.air->gusts = 0.36F;
    if (!gusts) p.air.reset();
    return p.substepsPerFrame(1.0 / 60);
  };
  CHECK(substeps(48, true) == 13);
  CHECK(substeps(96, true) == 27);  // With 20 substeps, the flag's corner would stretch by two thirds.
  const double finer = static_cast<double>(substeps(768, true)) / substeps(384, true);
  CHECK(finer > 2.5);
  CHECK(finer < 2.9);
  CHECK(substeps(96, false) == 8);
  CHECK(substeps(192, true) == 63);
}

TEST_CASE("damping does not depend on the number of substeps") {
  sim::ClothParameters p;
  for (const int n : {1, 4, 9}) {
    p.substeps = n;
    sim::ClothPlan plan(p, 1, 1.0 / 60, {});
    double kept = 1;
    for (const auto& step : plan.frame(0)) kept *= step.kept;
    CHECK(kept == doctest::Approx(std::exp(-4.85 / 60)).epsilon(1e-5));
  }
}

TEST_CASE("fabric: scene parameters of fabric are read, and errors are named") {
  const auto mistakes = [](const std::string& parameters) -> std::string {
    const std::string text = R"({"version": 1, "objects": {"sheet": {"cloth": )" + parameters + "}}}";
    try {
      const auto scene = scene::parseScene(text, sourceFolder() + "/assets/sheet.json", {}, sim::kinds());
      const auto& p = sim::parametersOf<sim::ClothParameters>(scene.objects.front());
      CHECK(p.constrained());
      CHECK(!p.substeps);                   // Without a value, "auto" applies.
      CHECK(p.wind.at(0) == glm::vec3(0));  // A material does not set a wind.
      CHECK(p.fabric->constants().density == 0.4F);
      CHECK(p.fabric->constants().bending == 1e-3F);
    } catch (const UserError& error) {
      CHECK(error.code() == ExitCode::usage);
      return error.what();
    }
    return "";
  };
  CHECK(mistakes(R"({"fabric": {"material": "denim", "bending": 1e-3}})").empty());
  CHECK(test::has(mistakes(R"({"fabric": {"material": "denim", "bend": 1}})"), "bending"));
  CHECK(test::has(mistakes(R"({"fabric": {"material": "linen"}})"), "canvas"));
  CHECK(test::has(mistakes(R"({"fabric": {"density": 0}})"), "density"));
  for (const char* given :
       {"mass", "stiffness", "shear", "bend", "compliance", "shearCompliance", "bendCompliance"})
    CHECK(test::has(mistakes(std::string(R"({"fabric": {}, ")") + given + "\": 1}"),
                    "leave out \"" + std::string(given) + "\""));
  CHECK(test::has(mistakes(R"({"fabric": {}, "solver": "springs"})"), "leave out \"solver\""));
  CHECK(test::has(mistakes(R"({"pins": [{"columns": [0], "clamp": true}]})"), "give \"fabric\""));
  CHECK(
      test::has(mistakes(R"({"fabric": {}, "pins": [{"columns": [3], "clamp": true}]})"), "first or last"));
}

TEST_CASE("contact thickness is the fabric's, clamped to 1/8 to 0.35 of the vertex spacing") {
  sim::ClothParameters p;
  p.fabric.emplace();
  p.fabric->thickness = 0.004;
  CHECK(p.contactThickness(0.02F) == doctest::Approx(0.004));
  CHECK(p.contactThickness(0.1F) == doctest::Approx(0.0125));   // The thickness is an eighth of the edge
                                                                // length.
  CHECK(p.contactThickness(0.01F) == doctest::Approx(0.0035));  // The thickness is 0.35 of the edge length.
  p.contact.emplace().thickness = 0.003;
  CHECK(p.contactThickness(0.1F) == doctest::Approx(0.003));
}
