// Tests cloth and particles that touch the walls of changing caves and contours. They must equal their CPU
// twins word by word.
#include "sim/contour/walls.hpp"

#include "gpu/context.hpp"
#include "gpu/sim/words.hpp"
#include "reference/cloth_twin.hpp"
#include "reference/garment_twin.hpp"
#include "reference/particles_twin.hpp"
#include "scene/load.hpp"
#include "sim/cave/parameters.hpp"
#include "sim/contour/parameters.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <bit>
#include <cstdint>
#include <memory>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

constexpr double wallsFrame = 1.0 / 60.0;

/// Returns a scene whose first object falls and precedes the object with the walls, so that the test fails
/// if the objects step in this order.
scene::Scene wallsScene(const std::string& faller, const std::string& objects) {
  return scene::parseScene(
      fmt::format(R"({{"version": 1, "seed": 5, "objects": {{"faller": {{{}}}, {}}}}})", faller, objects),
      "test.json", {}, sim::kinds());
}

const char* const livingTerraces = R"("hills": {"contour": {"field": "pattern", "levels": 4, "low": 0.05,
    "high": 0.3, "position": [0.1, -0.2, 0.05], "width": 3, "grip": 5,
    "height": {"keys": [[0, 0.3], [1, 0.6]]}}},
  "pattern": {"grayScott": {"size": [47, 33], "preset": "maze", "presteps": 400, "steps": 30,
    "seeds": {"count": 5, "radius": 4}, "display": {"layer": "none"}}})";
const char* const growingCave = R"("hall": {"cave": {"size": [45, 31], "stepSeconds": 0.05, "cell": 0.06,
    "position": [0.1, -0.2, 0], "height": 0.4, "grip": 3, "fill": 0.42, "smallestRoom": 4, "smallestRock": 4,
    "ceiling": CEILING}})";

const char* const wallGrains =
    R"("particles": {"method": "METHOD", "walls": "NAME", "bounce": 0.5, "margin": MARGIN,
  "acceleration": [0, -9.81, 0], "substeps": 3, "gravity": 0.001,
  "groups": [{"shape": "cube", "count": 333, "radius": 1.1, "position": [0.1, 0.9, 0.2], "speed": 2}],
  "emitters": [{"rate": 200, "position": [-0.4, 0.1, 0], "lifetime": 0.7, "velocity": [2, -2, 0]}]})";
const char* const wallSheet = R"("cloth": {"size": [35, 23], "spacing": 0.06, "position": [0.4, 0.5, 0.1],
  "rotation": [4, 20, 0], "mass": 0.004, "stiffness": 60, "margin": MARGIN, "wind": [0, 0, 0], "pins": [],
  "walls": "NAME", "substeps": 5, "solver": "METHOD"})";

std::string with(std::string text, const std::string& what, const std::string& value) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what))
    text.replace(at, what.size(), value);
  return text;
}

/// Builds the CPU twin of a solid from the field memory that the source object publishes.
class LivingWalls {
 public:
  LivingWalls(const scene::Scene& scene, const sim::World& world)
      : world_(world), solid_(*scene.objects.at(1).parameters) {}

  /// Returns the twin of the solid at the world's current frame, or nullopt if there is no solid.
  std::optional<WallsTwin> twin() {
    // The last object publishes the field. Its first state array contains the cells.
    const std::size_t source = world_.objectCount() - 1;
    const std::string name = world_.objectName(source);
    for (const sim::Field& field : world_.drawables().fields)
      if (field.name->starts_with(name) && !found_) {
        layout_ = field;
        found_ = true;
      }
    REQUIRE(found_);
    words_ = world_.object(source).state()[0].buffer->readAll<std::uint32_t>();
    const auto value = [this](int x, int y) { return valueAt(x, y); };
    if (const auto* cave = dynamic_cast<const sim::CaveParameters*>(&solid_))
      return WallsTwin(cave->shape(world_.time()), value, cave->position, cave->grip);
    const auto& contour = dynamic_cast<const sim::ContourParameters&>(solid_);
    return WallsTwin(contour.shape(layout_, world_.time()), value, contour.position, contour.grip);
  }

 private:
  [[nodiscard]] float valueAt(int x, int y) const {
    const int row = layout_.firstWord + y * layout_.rowWords;
    const auto word = [&](int i) { return words_.at(static_cast<std::size_t>(i)); };
    if (layout_.cells == sim::Field::Cells::bits)
      return static_cast<float>(word(row + x / 32) >> static_cast<unsigned>(x % 32) & 1U);
    return std::bit_cast<float>(word(row + x * layout_.cellWords));
  }
  const sim::World& world_;
  const scene::Parameters& solid_;
  sim::Field layout_;
  bool found_ = false;
  std::vector<std::uint32_t> words_;
};

template <class Twin>
void checkBesideWalls(const scene::Scene& scene, Twin twin, int frames) {
  testContext();
  sim::World world(scene);
  LivingWalls walls(scene, world);
  for (int frame = 1; frame <= frames; ++frame) {
    world.advanceTo(frame);
    twin.walls = walls.twin();
    twin.step((frame - 1) * wallsFrame);
    const auto state = world.object(0).state();
    REQUIRE(wordsUnlike(*state[0].buffer, twin.positions) == 0);
    REQUIRE(wordsUnlike(*state[1].buffer, twin.velocities) == 0);
  }
  testContext().check();
}

ParticlesTwin particlesOf(const scene::Scene& scene) {
  const auto& p = dynamic_cast<const sim::ParticleParameters&>(*scene.objects.at(0).parameters);
  return ParticlesTwin(sim::ParticlePlan(p, 5, wallsFrame));
}
ClothTwin clothOf(const scene::Scene& scene) {
  const auto& p = dynamic_cast<const sim::ClothParameters&>(*scene.objects.at(0).parameters);
  return ClothTwin(sim::ClothPlan(p, 5, wallsFrame, {}));
}

}  // namespace

TEST_CASE("walls: particles among living terraces (a changing contour) equal their CPU twin") {
  for (const char* method : {"none", "all-pairs"})
    for (const char* margin : {"0.02", "0.1"}) {  // The margin spans one square or two.
      CAPTURE(method);
      CAPTURE(margin);
      const std::string grains =
          with(with(with(wallGrains, "METHOD", method), "NAME", "hills"), "MARGIN", margin);
      const auto scene = wallsScene(grains, livingTerraces);
      checkBesideWalls(scene, particlesOf(scene), 40);
    }
}

TEST_CASE("walls: balls more than ten grid squares wide equal their CPU twin") {
  const std::string grains =
      with(with(with(wallGrains, "METHOD", "none"), "NAME", "hills"), "MARGIN", "0.6");
  const auto scene = wallsScene(grains, livingTerraces);
  checkBesideWalls(scene, particlesOf(scene), 3);
}

TEST_CASE("walls: particles in a growing cave equal their CPU twin") {
  for (const char* ceiling : {"false", "true"}) {
    CAPTURE(ceiling);
    const std::string grains =
        with(with(with(wallGrains, "METHOD", "none"), "NAME", "hall"), "MARGIN", "0");
    const auto scene = wallsScene(grains, with(growingCave, "CEILING", ceiling));
    checkBesideWalls(scene, particlesOf(scene), 50);
  }
}

TEST_CASE("walls: cloth on a changing contour equals its CPU twin") {
  for (const char* solver : {"springs", "constraints"}) {
    CAPTURE(solver);
    const std::string sheet =
        with(with(with(wallSheet, "METHOD", solver), "NAME", "hills"), "MARGIN", "0.02");
    const auto scene = wallsScene(sheet, livingTerraces);
    checkBesideWalls(scene, clothOf(scene), 40);
  }
}

TEST_CASE("walls: mesh cloth on a changing contour equals its CPU twin") {
  const auto scene = wallsScene(
      R"("cloth": {"mesh": {"shape": "sphere", "radius": 0.5, "resolution": [9, 3]}, "position": [0.4, 0.9, 0.1],
  "fabric": {"material": "rubber"}, "margin": 0.02, "walls": "hills"})",
      livingTerraces);
  const auto& p = dynamic_cast<const sim::ClothParameters&>(*scene.objects.at(0).parameters);
  checkBesideWalls(scene, GarmentTwin(sim::GarmentPlan("ball", p, 5, wallsFrame, {})), 40);
}

TEST_CASE("walls: skipping frames gives the same state as stepping through them") {
  testContext();
  const std::string grains =
      with(with(with(wallGrains, "METHOD", "none"), "NAME", "hills"), "MARGIN", "0.02");
  const auto scene = wallsScene(grains, livingTerraces);
  sim::World stepped(scene), passed(scene);
  stepped.advanceTo(30);
  passed.advanceUndrawn(30);
  passed.complete();
  for (std::size_t object = 0; object < stepped.objectCount(); ++object)
    for (std::size_t i = 0; i < stepped.object(object).state().size(); ++i)
      CHECK(stepped.object(object).state()[i].buffer->readAll<std::uint32_t>() ==
            passed.object(object).state()[i].buffer->readAll<std::uint32_t>());
}

TEST_CASE("walls: a margin over too many grid squares is refused with advice") {
  testContext();
  const std::string grains = with(with(with(wallGrains, "METHOD", "none"), "NAME", "hall"), "MARGIN", "1");
  const auto scene = wallsScene(grains, with(growingCave, "CEILING", "false"));
  CHECK_THROWS_WITH(sim::World{scene}, doctest::Contains("make it 0.72 m or less"));
}
