// Tests rules that read fields of other objects. The values must be those at the start of the frame, must
// not depend on the order of stepping, and must equal the CPU's values bit for bit.
#include "gpu/context.hpp"
#include "scene/load.hpp"
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

/// Scene text with rules that read bits, bytes, floats and colours, two rules that read each other, and a
/// rule that reads itself.
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

/// The CPU twin of one reaction object of a scene.
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

  void read(const sim::World& world) {
    const sim::Drawables drawables = world.drawables();
    const auto& parameters = plan.parameters().parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].field.empty()) continue;
      const sim::Field from = fieldOf(drawables, parameters[i].field);
      const std::vector<float> values = sim::fieldValues(from);
      if (plan.parameters().depth > 1 &&
          from.display == nullptr) {  // Volumes in these tests read only volumes.
        const glm::ivec3 size(field.size, field.depth);
        const glm::ivec3 sources(from.size.x, glm::ivec2(size.y, size.z) * from.size.x / size.x);
        field.weights[i] = sim::sampledInVolume(values, sources, size);
        continue;
      }
      field.weights[i] = plan.links() == nullptr   ? sim::sampledOnGrid(values, from.size, field.size)
                         : from.size == field.size ? sim::sampledCells(values)
                                                   : sim::sampledAt(values, from.size, plan.places());
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

TEST_CASE("reaction reads fields of every kind with its twin's bits, also fields that read it") {
  testContext();
  const scene::Scene scene = ofObjects(manyReaders);
  sim::World world(scene);
  Reader guest(scene, "guest"), host(scene, "host");
  for (int frame = 0; frame < 5; ++frame) {
    guest.read(world);
    host.read(world);
    guest.step(frame * fieldFrame);
    host.step(frame * fieldFrame);
    world.advanceTo(frame + 1);
    sameBits(valuesOf(world, "guest"), guest.field.stage[0]);
    sameBits(valuesOf(world, "host.v"), host.field.stage[0]);
    sameBits(valuesOf(world, "host.w"), host.field.stage[1]);
  }
  const std::vector<float> shown = valuesOf(world, "host");
  sameBits(shown, sim::evaluateShown(host.plan, host.plan.valuesAt(0), 0, 0, host.field));
  // Stepping without drawing must give the same values.
  sim::World passed(scene);
  passed.advanceUndrawn(5);
  passed.complete();
  sameBits(valuesOf(passed, "guest"), guest.field.stage[0]);
  sameBits(valuesOf(passed, "host"), shown);
}

// Tests du/dt = v and dv/dt = -u, where each equation uses the value of the other species at the start of
// the frame. With the frame duration H, this gives u' = u + H v and v' = v - H u simultaneously. The
// expected values are computed in double precision. Both grids have 4x4 cells.
TEST_CASE("reactions that read each other both read the state before the frame") {
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

// Bilinear sampling reproduces a field that is linear in x and y exactly on any grid, except beyond the
// centres of the grid's outermost cells.
TEST_CASE("a field on another grid is sampled at the same place of the picture") {
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
    CHECK(worst < 4 * 0x1p-15 + 1e-5);  // Weights are multiples of 2^-15.
  }
}

// A mesh samples grids at its texture coordinates, or by projection from one side ("maps"). Objects on the
// same mesh are read cell by cell, regardless of their positions.
TEST_CASE("reaction on a mesh reads grids and its own mesh with its twin's bits") {
  testContext();
  const scene::Scene scene = ofObjects(R"X(
    "leaf": {"reaction": {"mesh": {"shape": "plane", "resolution": [23, 14]}, "dt": 0.05, "steps": 3,
      "parameters": {"heat": {"field": "smoke.temperature"}, "alive": {"field": "cells"}, "on": {"field": "other.w"}},
      "species": {"u": {"start": "random(1)", "rate": "heat + 0.5*alive - u + 0.2*on"}}}},
    "other": {"reaction": {"mesh": {"shape": "plane", "resolution": [23, 14], "position": [9, 1, 0], "maps": "top"}, "dt": 0.05,
      "parameters": {"u": {"field": "leaf"}, "alive": {"field": "cells"}},
      "species": {"v": {"rate": "u - v"}, "w": {"diffusion": 0.1, "rate": "laplacian(u) + alive - w"}}}},
    "ball": {"reaction": {"mesh": {"shape": "sphere", "resolution": [16, 9], "maps": "front"}, "dt": 0.05, "steps": 1,
      "parameters": {"heat": {"field": "smoke"}}, "species": {"u": {"rate": "heat - u"}}}},
    "smoke": {"fluid": {"size": [31, 22], "substeps": 1, "show": "temperature",
      "strokes": [{"until": 9, "radius": 5, "from": [15, 11, 0], "temperature": 2, "velocity": [25, 3, 0]}]}},
    "cells": {"life": {"size": [97, 53], "stepsPerSecond": 60}}
  )X");
  sim::World world(scene);
  Reader leaf(scene, "leaf"), other(scene, "other"), ball(scene, "ball");
  for (int frame = 0; frame < 3; ++frame) {
    for (Reader* reader : {&leaf, &other, &ball}) {
      reader->read(world);
      reader->step(frame * fieldFrame);
    }
    world.advanceTo(frame + 1);
    sameBits(valuesOf(world, "leaf"), leaf.field.stage[0]);
    sameBits(valuesOf(world, "other.v"), other.field.stage[0]);
    sameBits(valuesOf(world, "other.w"), other.field.stage[1]);
    sameBits(valuesOf(world, "ball"), ball.field.stage[0]);
  }
}

// Interpolates trilinearly between cell centres, independently of the kernels. Clamps positions beyond the
// outermost centres.
double trilinear(const std::vector<float>& values, glm::ivec3 sources, glm::dvec3 at) {
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::size_t index = 0;
    for (int axis = 2; axis >= 0; --axis) {
      const double place = std::clamp(at[axis] - 0.5, 0.0, sources[axis] - 1.0);
      const int low = std::min(static_cast<int>(place), sources[axis] - 2), upper = corner >> axis & 1;
      weight *= upper == 1 ? place - low : 1 - (place - low);
      index = index * static_cast<std::size_t>(sources[axis]) + static_cast<std::size_t>(low + upper);
    }
    sum += weight * static_cast<double>(values[index]);
  }
  return sum;
}

TEST_CASE(
    "a volume reads another volume of equal proportions by trilinear sampling, with its twin's bits") {
  testContext();
  const scene::Scene scene = ofObjects(R"X(
    "coarse": {"reaction": {"size": [9, 6], "depth": 12, "dt": 0.1, "steps": 2, "parameters": {"fine": {"field": "fine"}},
      "species": {"s": {"start": "random(1)", "diffusion": 0.1, "rate": "fine - s"}, "q": {"start": "x*x - 0.3*y*z"}}}},
    "fine": {"reaction": {"size": [21, 14], "depth": 28, "dt": 0.05, "steps": 1, "parameters": {"heat": {"field": "coarse.q"}, "s": {"field": "coarse"}},
      "species": {"u": {"next": "heat"}, "w": {"start": "random(2)", "rate": "s - w"}}}},
    "alike": {"reaction": {"size": [9, 6], "depth": 12, "parameters": {"q": {"field": "coarse.q"}}, "species": {"u": {"next": "q"}}}}
  )X");
  sim::World world(scene);
  const std::vector<float> source = valuesOf(world, "coarse.q");
  Reader coarse(scene, "coarse"), fine(scene, "fine");
  for (int frame = 0; frame < 3; ++frame) {
    for (Reader* reader : {&coarse, &fine}) reader->read(world);
    coarse.step(frame * fieldFrame);
    fine.step(frame * fieldFrame);
    world.advanceTo(frame + 1);
    sameBits(valuesOf(world, "coarse"), coarse.field.stage[0]);
    sameBits(valuesOf(world, "fine"), fine.field.stage[0]);
    sameBits(valuesOf(world, "fine.w"), fine.field.stage[1]);
  }
  sameBits(valuesOf(world, "alike"), source);  // A grid of equal size is read cell by cell.
  const std::vector<float> got = valuesOf(world, "fine");
  double worst = 0;
  for (int z = 0; z < 28; ++z)
    for (int y = 0; y < 14; ++y)
      for (int x = 0; x < 21; ++x) {
        const double want = trilinear(source, {9, 6, 12}, (glm::dvec3(x, y, z) + 0.5) * (9.0 / 21));
        worst = std::max(
            worst,
            std::abs(static_cast<double>(got[static_cast<std::size_t>((z * 14 + y) * 21 + x)]) - want));
      }
  CHECK(worst < 60 * 0x1p-15);  // Weights are multiples of 2^-15. Neighbouring values differ by up to 15.
}

// With one Euler step per frame, two objects that read each other equal one object with two species.
TEST_CASE(
    "two reactions that read each other on one mesh equal one reaction with two species, bit for bit") {
  testContext();
  const std::string mesh =
      R"("mesh": {"shape": "torus", "resolution": [33, 17]}, "dt": 0.02, "steps": 1, )";
  const std::string u = R"X("diffusion": 1, "start": "random(1)", "rate": "u - u^3 - v")X";
  const std::string v = R"X("diffusion": 0.2, "start": "random(2)", "rate": "0.1*(u - v)")X";
  const auto half = [&](const char* name, const std::string& species, const char* from) {
    return fmt::format(
        R"("{0}": {{"reaction": {{{1}"parameters": {{"{2}": {{"field": "{2}"}}}}, "species": {{"{0}": {{{3}}}}}}}}})",
        name, mesh, from, species);
  };
  sim::World two(ofObjects(half("u", u, "v") + ", " + half("v", v, "u")));
  sim::World one(ofObjects(
      fmt::format(R"("both": {{"reaction": {{{}"species": {{"u": {{{}}}, "v": {{{}}}}}}}}})", mesh, u, v)));
  two.advanceTo(9);
  one.advanceTo(9);
  sameBits(valuesOf(two, "u"), valuesOf(one, "both.u"));
  sameBits(valuesOf(two, "v"), valuesOf(one, "both.v"));
}

// A function that is linear on the grid must be linear on the mesh, up to the centres of the outermost
// cells.
TEST_CASE("a mesh samples a grid where it covers it") {
  testContext();
  sim::World world(ofObjects(R"X(
    "ramp": {"reaction": {"size": [40, 24], "steps": 0, "species": {"r": {"start": "x + 100*y"}}}},
    "leaf": {"reaction": {"mesh": {"shape": "plane", "resolution": [9, 5]}, "dt": 1, "steps": 1, "parameters": {"r": {"field": "ramp"}},
      "species": {"s": {"next": "r"}}}}
  )X"));
  world.advanceTo(1);
  const std::vector<float> got = valuesOf(world, "leaf");
  const scene::Scene scene = ofObjects(
      R"X("leaf": {"reaction": {"mesh": {"shape": "plane", "resolution": [9, 5]}, "species": {"s": {"rate": "0"}}}})X");
  const Reader leaf(scene, "leaf");
  REQUIRE(got.size() == 45);
  for (std::size_t i = 0; i < got.size(); ++i) {
    const glm::dvec3 share = leaf.plan.cells().places[i] / glm::dvec3(4, 1, 4) + 0.5;
    const double x = std::clamp(40 * share.x, 0.5, 39.5), y = std::clamp(24 * share.z, 0.5, 23.5);
    CHECK(static_cast<double>(got[i]) == doctest::Approx(x + 100 * y).epsilon(2e-5));
  }
}
