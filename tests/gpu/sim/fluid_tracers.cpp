// Tests tracers of a fluid. They must equal their CPU twin word by word.
#include "gpu/context.hpp"
#include "reference/tracers_twin.hpp"
#include "scene/load.hpp"
#include "sim/fluid/plan.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

/// Returns the colours of the cells that a world displays for its fluid.
std::vector<glm::vec4> shownBy(const sim::World& world) {
  const sim::Field field = world.drawables().fields.at(0);
  GLint buffer = 0;
  glGetTextureLevelParameteriv(field.words->name(), 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &buffer);
  std::vector<glm::vec4> cells;
  for (int y = 0; y < field.size.y; ++y)
    for (int x = 0; x < field.size.x; ++x) {
      glm::vec4& cell = cells.emplace_back();
      const GLintptr word = field.firstWord + GLintptr{field.rowWords} * y + GLintptr{field.cellWords} * x;
      glGetNamedBufferSubData(static_cast<GLuint>(buffer),
                              static_cast<GLintptr>(field.words->offset()) + 4 * word, sizeof cell, &cell);
    }
  return cells;
}

void checkTracers(const std::string& sides) {
  testContext();
  const auto scene =
      scene::parseScene(fmt::format(R"({{"version": 1, "seed": 9, "objects": {{"it": {{"fluid": {{
      "size": [45, 29], "speed": 200, "courant": 3, "flow": [40, 9, 0], "sides": {{{}}},
      "obstacles": [{{"center": [22, 14, 0], "radius": 4.4}}],
      "tracers": {{"count": 700, "seconds": 0.4, "streak": 0.1}}, "strokes": []}}}}}}}})",
                                    sides),
                        "test.json", {}, sim::kinds());
  const auto& p = dynamic_cast<const sim::FluidParameters&>(*scene.objects.at(0).parameters);
  const sim::FluidPlan plan(p, "it", scene.seed, 1.0 / 60);
  const auto step =
      sim::tracerStep(*p.tracers, 1.0 / 60 / plan.substeps(), scene.seed, p.wrapsX(), p.wrapsY());
  TracersTwin twin(*p.tracers, p.size, plan.solidsAt(0, 0)->solid(), step, 1.0 / 60);
  sim::World world(scene);
  const auto same = [&] {
    const auto arrays = world.object(0).state();
    REQUIRE(arrays.size() == 4);
    const auto got = arrays[2].buffer->readAll<glm::uvec4>();
    std::size_t different = 0;
    for (std::size_t i = 0; i < twin.tracers.size(); ++i)
      different += got[i] == std::bit_cast<glm::uvec4>(twin.tracers[i]) ? 0 : 1;
    CHECK(different == 0);
    auto trail = arrays[3].buffer->readAll<std::uint32_t>();
    trail.resize(twin.trail.size());
    CHECK(trail == twin.trail);
  };
  same();
  WindTwin wind{sim::fluidWindGrid(p.plane, p.size)};
  for (int frame = 1; frame <= 6; ++frame) {
    twin.beginFrame();
    world.advanceTo(frame, [&](std::size_t, int) {
      wind.flow = world.object(0).state()[0].readAll<glm::vec4>();
      twin.advance(wind);
    });
    same();
  }
  long drawn = 0, anew = 0;
  for (const std::uint32_t level : twin.trail) drawn += level > 0 ? 1 : 0;
  for (const glm::vec4& tracer : twin.tracers) anew += tracer.w > 0 ? 1 : 0;
  CHECK(drawn > 300);
  CHECK(anew > 20);
  testContext().check();
}

}  // namespace

// A streak is blended over a cell by over = color + (under - color) exp(-trail brightness / 4096). `trail`
// is the amount of light in the cell.
TEST_CASE("tracers: streaks are blended over the displayed field, cell by cell") {
  testContext();
  const auto worldOf = [](const std::string& more) {
    return scene::parseScene(fmt::format(R"({{"version": 1, "seed": 9, "objects": {{"it": {{"fluid": {{
      "size": [45, 29], "speed": 200, "flow": [40, 9, 0], "sides": {{"left": {{"kind": "inflow", "velocity": [40, 0, 0]}}, "right": "open"}},
      "display": {{"layer": "over"}}, {} "strokes": [{{"from": [9, 14, 0], "radius": 4, "dye": [0.7, 0.2, 0.1]}}]}}}}}}}})",
                                         more),
                             "test.json", {}, sim::kinds());
  };
  const auto
      plain = worldOf(""),
      streaked = worldOf(
          R"("tracers": {"count": 300, "seconds": 0.4, "streak": 0.1, "color": [0.9, 0.5, 0.3], "brightness": 3},)");
  sim::World without(plain), with(streaked);
  without.advanceTo(5);
  with.advanceTo(5);
  gl::barrier();
  const auto under = shownBy(without), over = shownBy(with);
  const auto trail = with.object(0).state().at(3).readAll<std::uint32_t>();
  REQUIRE(over.size() == 45 * 29);
  const glm::dvec3 color(0.9F, 0.5F, 0.3F);
  int drawn = 0, empty = 0;
  for (std::size_t i = 0; i < over.size(); ++i) {
    (trail[i] > 0 ? drawn : empty) += 1;
    const double through = std::exp(-3.0 / 4096 * trail[i]);
    const glm::dvec3 expected = color + (glm::dvec3(under[i]) - color) * through;
    for (int c = 0; c < 3; ++c)
      CHECK(static_cast<double>(over[i][c]) == doctest::Approx(expected[c]).epsilon(1e-5).scale(1));
    CHECK(over[i].w == under[i].w);
  }
  CHECK(drawn > 100);
  CHECK(empty > 100);
}

TEST_CASE("tracers: tracers of a channel equal their CPU twin") {
  checkTracers(R"("left": {"kind": "inflow", "velocity": [40, 0, 0]}, "right": "open")");
}

TEST_CASE("tracers: tracers on a torus equal their CPU twin") {
  checkTracers(R"("left": "periodic", "right": "periodic", "top": "periodic", "bottom": "periodic")");
}
