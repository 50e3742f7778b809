#include "sim/water/water.hpp"

#include "gpu/context.hpp"
#include "reference/water_twin.hpp"
#include "scene/load.hpp"
#include "sim/grid/field_values.hpp"
#include "sim/water/quantities.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr double pondFrame = 1.0 / 30;

/// Returns a pond with an island, a beach, a breaking dam, rain and a source.
sim::WaterParameters pond(int width, int height) {
  sim::WaterParameters p;
  p.size = {width, height};
  p.cell = 0.1F;
  p.bed = -0.4F;
  const float w = 0.05F * static_cast<float>(width);
  p.hills = {{{0.3F * w, 0, 0}, {0.5F * w, 0, 0.4F * w}, 0.7F}, {{-w, 0, -w}, {w, 0, w}, 0.6F}};
  p.pools = {{{-10, 0, -10}, {-0.4F * w, 0, 10}, 0.3F}};
  p.greatestSpeed = 4;
  p.foam = 2;
  p.drains = {{{0.3F * w, 0, 0.6F * w}, 0.3F, 0.8F, 0.05, 0.3}};
  p.drops = {{0.1, {0.1F, 0, 0.2F}, 0.5F, 0.2F}};
  p.rain.emplace();
  p.rain->rate = 100;
  sim::StrokeParameters source;
  source.at = 0.02;
  source.until = 0.2;
  source.from = source.to = {static_cast<float>(width) * 0.7F, 2, 0};
  source.radius = 2.2F;
  source.value = 0.4;
  source.fraction = 0.8F;
  p.strokes.push_back(source);
  return p;
}

std::unique_ptr<sim::Simulation> waterOn(scene::Object& object, const sim::WaterParameters& parameters) {
  testContext();
  object.name = "pond";
  object.kind = "water";
  object.parameters = std::make_unique<sim::WaterParameters>(parameters);
  static const std::vector<sim::ColliderShape> none;
  return sim::waterKind().make(object, {false, 5, pondFrame, &none});
}

std::size_t differing(const std::vector<glm::vec4>& got, const std::vector<glm::vec4>& want) {
  REQUIRE(got.size() == want.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < got.size(); ++i)
    for (int c = 0; c < 4; ++c)
      different +=
          std::bit_cast<std::uint32_t>(got[i][c]) != std::bit_cast<std::uint32_t>(want[i][c]) ? 1 : 0;
  return different;
}

std::size_t differing(const std::vector<glm::ivec4>& got, const std::vector<glm::ivec4>& want) {
  REQUIRE(got.size() == want.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < got.size(); ++i) different += got[i] != want[i] ? 1 : 0;
  return different;
}

/// Adds two balls, one of which falls onto the other, a driven box and a towed box.
void addFloats(sim::WaterParameters& p) {
  const float w = 0.05F * static_cast<float>(p.size.x);
  sim::WaterFloat ball;
  ball.radius = 0.15F;
  ball.position = {-0.3F * w, 0.1F, 0.1F};
  ball.spin = {40, 300, -200};
  p.floats.push_back(ball);
  ball.position += glm::vec3(0.1F, 0.35F, 0.05F);
  ball.density = 150;
  ball.air = 2;
  p.floats.push_back(ball);
  sim::WaterFloat box;
  box.shape = sim::WaterFloatShape::box;
  box.size = {0.3F, 0.2F, 0.5F};
  box.position = {-0.6F * w, 0.3F, -0.3F * w};
  box.rotation = {10, 40, -25};
  box.keel = 5;
  box.thrust = 60.0F;
  box.steering = 4.0F;
  p.floats.push_back(box);
  box.position = {0.9F * w, 0.2F, 0.6F * w};
  box.tow.emplace().position =
      scene::Animated<glm::vec3>({{0, box.position}, {0.4, {-w, 0, 0.2F}}}, scene::Ease::smooth);
  p.floats.push_back(box);
}

/// Steps the GPU water and its CPU twin and compares every word of the state and of the drawn surface.
void compareWater(const sim::WaterParameters& parameters, int frames) {
  scene::Object object;
  const auto gpu = waterOn(object, parameters);
  WaterTwin twin(sim::WaterPlan(parameters, "pond", 5, pondFrame));
  for (int frame = 0; frame < frames; ++frame) {
    gpu->step(frame * pondFrame, {});
    twin.step(frame * pondFrame);
  }
  CHECK(differing(gpu->state()[0].buffer->readAll<glm::vec4>(), twin.cells) == 0);
  const bool floating = !parameters.floats.empty();
  if (floating) {
    CHECK(differing(gpu->state()[1].buffer->readAll<glm::vec4>(), twin.floats) == 0);
    CHECK(differing(gpu->state()[2].buffer->readAll<glm::ivec4>(), twin.displaced) == 0);
    CHECK(gpu->measure() == sim::measureWater(twin.plan(), twin.cells, twin.floats));
  }
  double moving = 0;
  for (const glm::vec4& cell : twin.cells) moving = std::max<double>(moving, std::abs(cell.y));
  CHECK(moving > 1e-3);
  const std::vector<glm::vec4> shown = twin.look();
  sim::Drawables drawables;
  gpu->publish(0, drawables);
  REQUIRE(drawables.surfaces.size() == 2 + parameters.floats.size());
  REQUIRE(drawables.fields.size() == 3);
  CHECK(*drawables.fields[1].name == "pond.level");
  for (int channel = 0; channel < 3; ++channel) {
    const std::vector<float> field = sim::fieldValues(drawables.fields[static_cast<std::size_t>(channel)]);
    std::size_t different = 0;
    for (std::size_t i = 0; i < field.size(); ++i)
      different += field[i] != (channel == 1 ? twin.cells[i].x : shown[i][channel]) ? 1 : 0;
    CHECK(different == 0);
  }
  const auto table = gpu->mesh();
  REQUIRE(table);
  std::size_t different = 0;
  const shader::WaterLook look = twin.plan().look();
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const int row = static_cast<int>(i) / parameters.size.x,
              column = static_cast<int>(i) % parameters.size.x;
    const glm::vec3 want(look.left + static_cast<float>(column) * look.cell, shown[i].y,
                         look.back + static_cast<float>(row) * look.cell);
    different += table->positions[i] != want ? 1 : 0;
  }
  CHECK(different == 0);
}

}  // namespace

TEST_CASE("water equals its CPU twin on sizes down to 2x3") {
  for (const glm::ivec2 size :
       {glm::ivec2(2, 3), glm::ivec2(5, 4), glm::ivec2(17, 9), glm::ivec2(67, 45)}) {
    CAPTURE(size.x);
    CAPTURE(size.y);
    compareWater(pond(size.x, size.y), 12);
  }
}

TEST_CASE("water with every border type and friction equals its CPU twin") {
  using enum sim::WaterBorder;
  auto p = pond(33, 29);
  p.sides = {open, wall, periodic, periodic};
  p.manning = 0.03F;
  p.drag = 0.2F;
  p.rainfall = 5000.0F;
  compareWater(p, 10);
  p.sides = {periodic, periodic, wall, open};
  compareWater(p, 10);
}

TEST_CASE("water with bodies that float equals its CPU twin") {
  using enum sim::WaterBorder;
  auto p = pond(37, 31);
  p.greatestSpeed = 6;
  addFloats(p);
  compareWater(p, 14);
  p.sides = {periodic, periodic, open, wall};
  compareWater(p, 8);
  p = pond(7, 5);
  addFloats(p);
  p.sides.fill(periodic);
  compareWater(p, 5);
}

TEST_CASE("water with incoming waves equals its CPU twin") {
  using enum sim::WaterBorder;
  auto p = pond(29, 35);
  p.sides = {sea, wall, sea, sea};
  p.swell = {{3, 0.2F, 0.7, 0}, {3, 0.1F, 0.5, 0.3}, {0, 0.1F, 0.9, 0.1}};
  compareWater(p, 10);
  p.sides = {wall, sea, sea, open};
  p.swell = {{1, 0.2F, 0.7, 0}, {2, 0.1F, 0.5, 0.3}};
  compareWater(p, 6);
}

TEST_CASE("water: particles rest on the water surface and on dry ground") {
  testContext();
  const scene::Scene scene = scene::parseScene(R"({"version": 1, "objects": {
    "grains": {"particles": {"method": "none", "collides": true, "bounce": 0, "margin": 0.05,
      "acceleration": [0, -9.81, 0], "groups": [{"shape": "cube", "count": 200, "radius": 1.5, "position": [0, 2, 0]}]}},
    "pond": {"water": {"size": [41, 37], "cell": 0.1, "collides": true, "grip": 1000, "position": [0, 0.2, 0],
      "terrain": {"bed": -0.5, "hills": [{"radii": [1, 0, 1], "height": 1.2}]}}}}})",
                                               "test.json", {}, sim::kinds());
  sim::World world(scene);
  world.advanceTo(120);
  int afloat = 0;
  int ashore = 0;
  for (const glm::vec4& p : world.object(0).state()[0].buffer->readAll<glm::vec4>()) {
    CHECK(p.y > 0.25 - 1e-4);
    const double inside =
        std::max(0.0, 1 - static_cast<double>(p.x) * p.x - static_cast<double>(p.z) * p.z);
    const double ground = 0.2 - 0.5 + 1.2 * inside * inside;
    afloat += std::abs(p.y - 0.25) < 1e-4 ? 1 : 0;
    ashore += ground > 0.22 && std::abs(p.y - ground - 0.05) < 0.01 ? 1 : 0;
  }
  CHECK(afloat > 100);
  CHECK(ashore > 3);
}

TEST_CASE("water warns if steps are too long, with the step count needed") {
  auto p = pond(31, 30);
  p.greatestSpeed = 0.01;
  p.greatestDepth = 0.05;
  scene::Object object;
  const auto gpu = waterOn(object, p);
  for (int frame = 0; frame < 5; ++frame) gpu->step(frame * pondFrame, {});
  const auto words = gpu->status()->readAll<unsigned>();
  CHECK(words[0] == 0xffffffffU);
  REQUIRE(words[2] != 0);
  CHECK(std::bit_cast<float>(words[2]) > 0.5F);
  CHECK(gpu->remark(5).find("Courant number of") != std::string::npos);
}
