// Tests long-range attachments. Paths to pins must be correct, and there must be no forces on unstretched
// cloth.
#include "reference/garment_twin.hpp"
#include "sim/garment/attachments.hpp"
#include "sim/garment/quantities.hpp"
#include "unit/help.hpp"
#include "unit/sim/garment_help.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

double garmentValue(const GarmentTwin& twin, std::size_t which) {
  auto copy = twin;
  return sim::measureGarment(copy.plan(), twin.positions, twin.velocities, 0)[which];
}
constexpr std::size_t kineticValue = 2;
constexpr std::size_t energyValue = 5;

/// Returns the distance (m) from the pins to the lowest point of a soft square sheet. The sheet hangs by
/// one corner if `corner` is true, and otherwise by both upper corners.
double dropOf(bool corner, int substeps, std::size_t& attachments) {
  sim::ClothParameters p = test::freeCloth();
  p.mesh->size = glm::vec3(0.6F, 0, 0.6F);
  p.mesh->resolution = {17, 17};
  p.rotation = glm::vec3(90, 0, corner ? 45 : 0);
  p.gravity = glm::vec3(0, -9.8F, 0);
  p.damping = 8;
  p.fabric->weft = p.fabric->warp = 60;
  p.fabric->shear = 8;
  p.fabric->bending = 1e-6;
  p.substeps = substeps;
  p.pins.emplace_back().vertices = {0};
  if (!corner) p.pins[0].vertices.push_back(16);
  GarmentTwin twin(sim::GarmentPlan("sheet", p, 1, 1.0 / 60, {}));
  attachments = twin.plan().arrays().attachments.size();
  for (int frame = 0; frame < 120; ++frame) twin.step(frame / 60.0);
  double minimum = 9;
  double maximum = -9;
  for (const glm::vec4& v : twin.positions) {
    minimum = std::min(minimum, static_cast<double>(v.y));
    maximum = std::max(maximum, static_cast<double>(v.y));
  }
  return maximum - minimum;
}

}  // namespace

TEST_CASE("garment: distances to a pinned border and corner equal those on a plane, for any mesh") {
  for (const auto kind : {test::Kind::right, test::Kind::equilateral, test::Kind::random}) {
    CAPTURE(static_cast<int>(kind));
    const sim::ClothTriangles cloth("a", test::rectangle(kind, {40, 30}, 0.02), 1, 0);
    std::vector<bool> row(cloth.points.size(), false);
    std::vector<bool> corner = row;
    double minimum = 1e9;
    for (const glm::dvec3& p : cloth.points) minimum = std::min(minimum, p.x);
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = cloth.points[i].x < minimum + 1e-9;
    corner[0] = true;
    const sim::PathsToPins toRow = sim::waysToPins(cloth, row);
    const sim::PathsToPins toCorner = sim::waysToPins(cloth, corner);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const double across = cloth.points[i].x - minimum;
      CHECK(toRow.lengths[i] > across - 1e-9);
      CHECK(toRow.lengths[i] < across + 0.006);  // A point between two pins is attached to one of them.
      const double way = glm::distance(cloth.points[i], cloth.points[0]);
      CHECK(toCorner.lengths[i] > way - 1e-9);
      CHECK(toCorner.lengths[i] < 1.02 * way + 1e-9);
    }
  }
}

TEST_CASE("garment: attachments hold no more than the fabric: a sheet hangs as low as with many substeps") {
  for (const bool corner : {false, true}) {
    CAPTURE(corner);
    std::size_t few = 0;
    std::size_t many = 0;
    const double quick = dropOf(corner, 8, few);
    const double exact = dropOf(corner, 120, many);
    CHECK(few > 60);
    CHECK(many < 20);
    CHECK(quick == doctest::Approx(exact).epsilon(0.01));
  }
}

TEST_CASE("garment: 256 rows swing from their border and stretch by less than 1%") {
  for (const bool damped : {false, true}) {
    CAPTURE(damped);
    sim::ClothParameters p = test::freeCloth();
    if (damped) p.damping = 1e-6F;
    p.mesh->size = glm::vec3(0.012F, 0, 1);
    p.mesh->resolution = {4, 256};
    p.fabric->bending = 1e-8;  // Bending is so weak that it needs no additional substeps.
    p.gravity = glm::vec3(0, -9.8F, 0);
    test::pinBox(p, glm::vec3(-9), glm::vec3(9, 9, -0.499F));
    GarmentTwin twin(sim::GarmentPlan("strip", p, 1, 1.0 / 60, {}));
    CHECK(twin.plan().substeps() < (damped ? 60 : 180));
    double before = garmentValue(twin, energyValue);
    const double falls = 0.5 * 0.115 * 0.012 * 9.8;  // energy in J of the hanging sheet relative to the
                                                     // horizontal sheet
    double fastest = 0;
    double farthest = 0;
    for (int frame = 0; frame < 120; ++frame) {
      twin.step(frame / 60.0);
      for (const glm::vec4& v : twin.positions)
        farthest = std::max(farthest, static_cast<double>(glm::length(glm::vec3(0, v.y, v.z + 0.5F))));
      if (frame % 10 != 9) continue;
      const double now = garmentValue(twin, energyValue);
      CHECK(now < before + 0.01 * falls);
      before = now;
      fastest = std::max(fastest, garmentValue(twin, kineticValue));
    }
    CHECK(farthest < 1.01);
    CHECK(fastest > 0.5 * falls);
  }
}

TEST_CASE("garment: attachments are slack without stretch, and free cloth has none") {
  sim::ClothParameters p = test::freeCloth();
  p.mesh->resolution = {33, 33};
  CHECK(sim::GarmentPlan("a", p, 1, 1.0 / 60, {}).arrays().attachments.empty());
  test::pinBox(p, glm::vec3(-9), glm::vec3(9, 9, -0.99F));
  p.substeps = 8;
  GarmentTwin twin(sim::GarmentPlan("a", p, 1, 1.0 / 60, {}));
  REQUIRE(twin.plan().arrays().attachments.size() > 900);
  // The sheet is rolled up from the pins. Every path along the cloth keeps its length, but no path is
  // straight.
  for (glm::vec4& v : twin.positions) {
    const double way = 3.0 * (static_cast<double>(v.z) + 1);
    v.y = static_cast<float>((1 - std::cos(way)) / 3);
    v.z = static_cast<float>(std::sin(way) / 3 - 1);
  }
  const auto first = twin.positions;
  twin.step(0);
  double moved = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
    moved = std::max(moved,
                     static_cast<double>(glm::distance(glm::vec3(first[i]), glm::vec3(twin.positions[i]))));
  CHECK(moved < 2e-3);
}
