// Rules that read other objects' fields: as these are when a frame begins, whoever steps first, bit for bit
// as on the CPU.
#include "gpu/context.hpp"
#include "scene/scene.hpp"
#include "sim/grid/field_values.hpp"
#include "sim/reaction/plan.hpp"
#include "sim/reaction/sampling.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

constexpr int fieldSeed = 3;
constexpr double fieldFrame = 1.0 / 60;

scene::Scene ofObjects(const std::string& objects) {
  return scene::parseScene(
      fmt::format(R"({{"version": 1, "seed": {}, "objects": {{{}}}}})", fieldSeed, objects), "s.json", {},
      sim::kinds());
}

sim::Field fieldOf(const sim::Drawables& drawables, const std::string& name) {
  for (const sim::Field& field : drawables.fields)
    if (*field.name == name) return field;
  FAIL("no field " << name);
  return {};
}

std::vector<float> valuesOf(const sim::World& world, const std::string& name) {
  const sim::Drawables drawables = world.drawables();
  return sim::fieldValues(fieldOf(drawables, name));
}

/// Bits, bytes, floats, colours, a rule that is read by the one that it reads, and one that reads itself.
const std::string manyReaders = R"X(
  "guest": {"reaction": {"size": [23, 31], "dt": 0.05, "steps": 3,
    "parameters": {"heat": {"field": "smoke.temperature"}, "dye": {"field": "smoke"}, "host": {"field": "host.w"}, "self": {"field": "guest"}, "f": {"value": 1, "down": 2}},
    "species": {"u": {"start": "random(1)", "rate": "f*heat + 0.1*dye - u + host - 0.3*laplacian(host)*self"}}}},
  "smoke": {"fluid": {"size": [31, 22], "substeps": 1, "show": "temperature",
    "strokes": [{"until": 9, "radius": 5, "from": [15, 11, 0], "temperature": 2, "velocity": [25, 3, 0]}]}},
  "host": {"reaction": {"size": [64, 9], "dt": 0.1, "steps": 2, "method": "rk4", "boundary": "no-flux", "show": "w*guest + alive",
    "parameters": {"guest": {"field": "guest"}, "alive": {"field": "cells"}, "states": {"field": "sparks"}},
    "species": {"v": {"start": "x*0.01", "rate": "alive - v"}, "w": {"rate": "guest*v - w + 0.1*states"}}}},
  "cells": {"life": {"size": [97, 53], "stepsPerSecond": 60}},
  "sparks": {"life": {"size": [47, 33], "rule": "B2/S/3", "stepsPerSecond": 60}}
)X";

/// The twin of one object of `manyReaders`.
struct Reader {
  Reader(const scene::Scene& scene, const std::string& name)
      : plan(sim::parametersOf<sim::ReactionParameters>(objectOf(scene, name)), name, fieldSeed,
             fieldFrame),
        field(plan.firstField()) {}

  static const scene::Object& objectOf(const scene::Scene& scene, const std::string& name) {
    for (const scene::Object& object : scene.objects)
      if (object.name == name) return object;
    FAIL("no object " << name);
    return scene.objects.front();
  }

  void take(const sim::World& world) {
    const sim::Drawables drawables = world.drawables();
    const auto& parameters = plan.parameters().parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].field.empty()) continue;
      const sim::Field from = fieldOf(drawables, parameters[i].field);
      field.weights[i] = sim::sampledOnGrid(sim::fieldValues(from), from.size, field.size);
    }
  }
  void step(double time) {
    for (int i = 0; i < plan.parameters().steps; ++i)
      sim::evaluateStep(plan, plan.valuesAt(time), plan.stepAt(time) + i, 0, field);
  }

  sim::ReactionPlan plan;
  sim::RuleField field;
};

void sameBits(const std::vector<float>& got, const std::vector<float>& want) {
  REQUIRE(got.size() == want.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < got.size(); ++i)
    different += std::bit_cast<std::uint32_t>(got[i]) != std::bit_cast<std::uint32_t>(want[i]) ? 1 : 0;
  CHECK(different == 0);
}

}  // namespace

TEST_CASE("reaction reads fields of every kind with the bits of its twin, one that reads it among them") {
  testContext();
  const scene::Scene scene = ofObjects(manyReaders);
  sim::World world(scene);
  Reader guest(scene, "guest"), host(scene, "host");
  for (int frame = 0; frame < 5; ++frame) {
    guest.take(world);
    host.take(world);
    guest.step(frame * fieldFrame);
    host.step(frame * fieldFrame);
    world.advanceTo(frame + 1);
    sameBits(valuesOf(world, "guest"), guest.field.stage[0]);
    sameBits(valuesOf(world, "host.v"), host.field.stage[0]);
    sameBits(valuesOf(world, "host.w"), host.field.stage[1]);
  }
  const std::vector<float> shown = valuesOf(world, "host");
  sameBits(shown, sim::evaluateShown(host.plan, host.plan.valuesAt(0), 0, 0, host.field));
  // Frames at which nobody looks count as others do.
  sim::World passed(scene);
  passed.passTo(5);
  passed.show();
  sameBits(valuesOf(passed, "guest"), guest.field.stage[0]);
  sameBits(valuesOf(passed, "host"), shown);
}

// du/dt = v and dv/dt = -u, where each holds still for a frame in the other's eyes: with H the time of a
// frame, u' = u + H v and v' = v - H u at once. In double here, in a picture of 4x4 and 4x4 cells.
TEST_CASE("reactions that read each other both see the state before the frame") {
  testContext();
  const auto one = [](const char* other, const char* rate, const char* start) {
    return fmt::format(
        R"({{"reaction": {{"size": [4, 4], "dt": 0.01, "steps": 4, "parameters": {{"o": {{"field": "{}"}}}},
      "species": {{"s": {{"start": "{}", "rate": "{}"}}}}}}}})",
        other, start, rate);
  };
  const std::string u = R"("u": )" + one("v", "o", "1"), v = R"("v": )" + one("u.s", "-o", "0.25");
  for (const std::string& order : {u + ", " + v, v + ", " + u}) {
    sim::World world(ofObjects(order));
    double a = 1, b = 0.25;
    for (int frame = 1; frame <= 40; ++frame) {
      const double before = a;
      a += 0.04 * b;
      b -= 0.04 * before;
      world.advanceTo(frame);
    }
    CHECK(static_cast<double>(valuesOf(world, "u").at(5)) == doctest::Approx(a).epsilon(2e-6));
    CHECK(static_cast<double>(valuesOf(world, "v").at(5)) == doctest::Approx(b).epsilon(2e-6));
  }
}

// A field that grows evenly across and down is bilinear, so what is read of it on any grid is that of the
// cells' places, but beyond the middles of its outermost cells.
TEST_CASE("a field on another grid is where it is in the picture") {
  testContext();
  for (const glm::ivec2 size :
       {glm::ivec2(40, 24), glm::ivec2(7, 90), glm::ivec2(10, 6), glm::ivec2(5, 4)}) {
    CAPTURE(size.x);
    sim::World world(ofObjects(fmt::format(R"(
      "slope": {{"reaction": {{"size": [10, 6], "steps": 0, "species": {{"s": {{"start": "x - 3*y"}}}}}}}},
      "reader": {{"reaction": {{"size": [{}, {}], "dt": 1, "steps": 1, "parameters": {{"f": {{"field": "slope"}}}},
        "species": {{"s": {{"rate": "f"}}}}}}}})",
                                           size.x, size.y)));
    world.advanceTo(1);
    const std::vector<float> got = valuesOf(world, "reader");
    const auto placed = [](int i, int count, int sources) {
      return std::clamp((i + 0.5) * sources / count, 0.5, sources - 0.5);
    };
    double worst = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const double want = placed(x, size.x, 10) - 3 * placed(y, size.y, 6);
        worst = std::max(
            worst, std::abs(static_cast<double>(got[static_cast<std::size_t>(y * size.x + x)]) - want));
      }
    CHECK(worst < 4 * 0x1p-15 + 1e-5);  // shares are whole parts of 2^15
  }
}
