// Tests fluids on the GPU with all types of sides, sizes and forces. They must equal their CPU twin bit for
// bit.
#include "sim/fluid/fluid.hpp"

#include "gpu/context.hpp"
#include "reference/fluid_twin.hpp"
#include "sim/fluid/kernels.hpp"

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr double fluidFrame = 1.0 / 30;
using Side = sim::FluidSide::Kind;

sim::FluidStroke fluidJet(glm::vec3 from, glm::vec3 velocity, glm::vec3 dye) {
  sim::FluidStroke s;
  s.from = s.to = from;
  s.until = 1e3;
  s.radius = 3.5F;
  s.setsVelocity = s.setsDye = true;
  s.velocity = velocity;
  s.dye = dye;
  return s;
}

sim::FluidParameters jets(int width, int height) {
  sim::FluidParameters p;
  p.size = {width, height};
  p.speed = 90;
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  p.strokes = {fluidJet({0.2F * w, 0.4F * h, 0}, {60, 13, 0}, {1, 0.25F, 0}),
               fluidJet({0.8F * w, 0.55F * h, 0}, {-55, -20, 0}, {0, 0.5F, 1})};
  return p;
}

void setSides(sim::FluidParameters& p, Side left, Side right, Side top, Side bottom) {
  p.left.kind = left;
  p.right.kind = right;
  p.top.kind = top;
  p.bottom.kind = bottom;
}

void checkFluid(const std::vector<glm::vec4>& got, const std::vector<glm::vec4>& want, const char* what) {
  REQUIRE(got.size() >= want.size());
  std::size_t different = 0, first = 0;
  float maximum = 0;
  for (std::size_t i = 0; i < want.size(); ++i) {
    bool same = true;
    for (int c = 0; c < 4; ++c) {
      same = same && std::bit_cast<std::uint32_t>(got[i][c]) == std::bit_cast<std::uint32_t>(want[i][c]);
      maximum = std::max(maximum, std::abs(want[i][c]));
    }
    if (!same && different++ == 0) first = i;
  }
  CHECK_MESSAGE(different == 0, what, ": ", different, " of ", want.size(), " elements differ, first ",
                first);
  CHECK(maximum > 0.01F);  // The state must not stay zero.
}

/// Steps the GPU fluid and its CPU twin and compares every word of the state.
void compareFluid(const sim::FluidParameters& parameters, int frames) {
  testContext();
  scene::Object object;
  object.name = "bath";
  object.kind = "fluid";
  object.parameters = std::make_unique<sim::FluidParameters>(parameters);
  const std::vector<sim::ColliderShape> none;
  const auto gpu = sim::fluidKind().make(object, {false, 5, fluidFrame, &none});
  FluidTwin twin(sim::FluidPlan(parameters, "bath", 5, fluidFrame));
  for (int frame = 0; frame < frames; ++frame) {
    gpu->step(frame * fluidFrame, {});
    twin.step(frame * fluidFrame);
  }
  checkFluid(gpu->state()[0].readAll<glm::vec4>(), twin.flow, "flow");
  checkFluid(gpu->state()[1].readAll<glm::vec4>(), twin.dye, "dye");
  CHECK(gpu->measure()[0] <= sim::maxFluidDivergence);
}

}  // namespace

TEST_CASE("fluid equals its CPU twin between walls, on sizes that are not multiples of a tile") {
  for (const glm::ivec2 size :
       {glm::ivec2(37, 29), glm::ivec2(64, 33), glm::ivec2(4, 5), glm::ivec2(131, 18)}) {
    CAPTURE(size.x);
    CAPTURE(size.y);
    compareFluid(jets(size.x, size.y), 4);
  }
}

// On three levels of the solver, some tiles have no walls or obstacles nearby. Separate kernels process
// these tiles.
TEST_CASE("fluid equals its CPU twin with tiles far from walls and obstacles") {
  auto p = jets(150, 133);
  setSides(p, Side::wall, Side::open, Side::slip, Side::wall);
  p.lift = 20.0F;
  p.strokes[0].setsTemperature = true;
  p.strokes[0].temperature = 1.0F;
  p.obstacles.resize(1);
  p.obstacles[0].center = glm::vec3(90, 60, 0);
  p.obstacles[0].radius = 9;
  CHECK(sim::FluidPlan(p, "bath", 5, fluidFrame).solidsAt(0, 0)->tileGroups()[2].x > 0);
  compareFluid(p, 2);
  p.obstacles.clear();
  setSides(p, Side::periodic, Side::periodic, Side::periodic, Side::periodic);
  p.strokes[1].from.x = p.strokes[1].to.x = 150;  // The stroke crosses the seam.
  compareFluid(p, 2);
}

// On the storage-buffer memory path, one dispatch processes several coarse levels, and each finer level has
// a separate dispatch. On a torus, the cells that a workgroup reads extend across the seam.
TEST_CASE("fluid equals its CPU twin with many multigrid levels") {
  auto p = jets(1100, 41);
  setSides(p, Side::open, Side::slip, Side::open, Side::inflow);
  p.bottom.velocity = glm::vec3(3, -20, 0);
  p.obstacles.resize(1);
  p.obstacles[0].center = glm::vec3(270, 22, 0);
  p.obstacles[0].radius = 7;
  compareFluid(p, 1);
  p = jets(160, 48);
  setSides(p, Side::periodic, Side::periodic, Side::periodic, Side::periodic);
  p.strokes[0].from.x = p.strokes[0].to.x = 0;  // The stroke crosses the seam.
  compareFluid(p, 1);
}

TEST_CASE("fluid equals its CPU twin with every side type") {
  auto p = jets(45, 38);
  setSides(p, Side::inflow, Side::open, Side::slip, Side::wall);
  p.left.velocity = scene::Animated<glm::vec3>({{0.0, glm::vec3(20, 3, 0)}, {0.2, glm::vec3(30, -3, 0)}},
                                               scene::Ease::linear);
  p.bottom.velocity = glm::vec3(-25, 0, 0);
  compareFluid(p, 4);
  // The sides are the same as in the test of many levels, so that no further kernels are compiled.
  setSides(p, Side::open, Side::slip, Side::open, Side::inflow);
  p.bottom.velocity = glm::vec3(5, -25, 0);
  p.obstacles.resize(1);
  p.obstacles[0].center = glm::vec3(20, 18, 0);
  p.obstacles[0].radius = 4;
  compareFluid(p, 4);
}

TEST_CASE("fluid equals its CPU twin with cubic advection, between walls and on a torus") {
  auto p = jets(39, 33);
  p.advection = sim::FluidParameters::Advection::cubic;
  setSides(p, Side::periodic, Side::periodic, Side::wall, Side::slip);
  p.viscosity = 2.0F;
  p.strokes[0].from.x = p.strokes[0].to.x = 0;
  compareFluid(p, 3);
}

TEST_CASE("fluid equals its CPU twin on a torus, also of odd size") {
  for (const glm::ivec2 size : {glm::ivec2(36, 28), glm::ivec2(37, 29), glm::ivec2(9, 70)}) {
    CAPTURE(size.x);
    auto p = jets(size.x, size.y);
    setSides(p, Side::periodic, Side::periodic, Side::periodic, Side::periodic);
    p.strokes[0].from.x = p.strokes[0].to.x = 0;  // The stroke crosses the seam.
    compareFluid(p, 4);
  }
  auto p = jets(41, 30);
  // The sides are the same as in the test of lines across a seam, so that no further kernels are compiled.
  setSides(p, Side::periodic, Side::periodic, Side::wall, Side::open);
  p.obstacles.resize(1);
  p.obstacles[0].center = glm::vec3(39, 14, 0);  // The obstacle crosses the seam.
  p.obstacles[0].radius = 4;
  compareFluid(p, 4);
}

TEST_CASE("fluid equals its CPU twin where warm fluid leaves through an open side") {
  auto p = jets(45, 38);
  setSides(p, Side::wall, Side::open, Side::open, Side::wall);
  p.lift = 30;
  p.strokes[0].from.y = p.strokes[0].to.y = 4;
  for (sim::FluidStroke& stroke : p.strokes) {
    stroke.setsTemperature = true;
    stroke.temperature = 2;
  }
  compareFluid(p, 2);
}

TEST_CASE("fluid with obstacles, heat, friction, confinement and heavy dye equals its CPU twin") {
  for (const bool slip : {false, true}) {
    auto p = jets(67, 45);
    setSides(p, Side::wall, Side::wall, Side::open, Side::wall);
    p.obstaclesSlip = slip;
    p.cycles = 80;  // Many cycles are needed, because coarse grids barely resolve thin walls.
    p.obstacles.resize(3);
    p.obstacles[0].center = glm::vec3(40, 20, 0);
    p.obstacles[1].shape = sim::FluidObstacle::Shape::box;
    p.obstacles[1].center = glm::vec3(20, 30, 0);
    p.obstacles[1].extent = {20, 1.5F, 0};
    p.obstacles[1].turn = 20;
    p.obstacles[2].center = glm::vec3(2, 2, 0);  // The obstacle crosses the grid's border.
    p.obstacles[2].radius = 5;
    p.viscosity = 2.5F;
    p.confinement = 4.0F;
    p.lift = 30.0F;
    p.cooling = 0.7F;
    p.dyeWeight = 12.0F;
    p.strokes[1].setsTemperature = true;
    p.strokes[1].temperature = 2;
    p.strokes[1].force = glm::vec3(30, -40, 0);
    p.strokes[1].value = 0.3;
    p.strokes[0].shape = sim::StrokeParameters::Shape::line;
    p.strokes[0].to = {30, 35, 0};
    p.strokes[0].fraction = 0.7F;
    compareFluid(p, 5);
  }
}

TEST_CASE("fluid equals its CPU twin with semi-Lagrangian advection and with an enclosed pocket") {
  auto p = jets(50, 41);
  p.advection = sim::FluidParameters::Advection::semiLagrangian;
  for (const glm::vec4 wall : {glm::vec4(25, 10, 22, 2), glm::vec4(25, 30, 22, 2), glm::vec4(15, 20, 2, 22),
                               glm::vec4(35, 20, 2, 22)}) {
    sim::FluidObstacle& box = p.obstacles.emplace_back();
    box.shape = sim::FluidObstacle::Shape::box;
    box.center = glm::vec3(wall.x, wall.y, 0);
    box.extent = {wall.z, wall.w, 0};
  }
  // Many cycles are needed, because coarse grids do not resolve thin walls.
  p.cycles = 60;
  p.strokes[0].from = p.strokes[0].to = {25, 20, 0};  // The stroke is inside the enclosed pocket.
  compareFluid(p, 6);
}

TEST_CASE("fluid with moving, rotating, image and pocket-squeezing obstacles equals its CPU twin") {
  const auto file = std::filesystem::temp_directory_path() / "simreel_fluid_obstacle.pgm";
  {
    std::ofstream out(file, std::ios::binary);
    out << "P5 11 9 255\n";
    for (int i = 0; i < 99; ++i)
      out.put(static_cast<char>(i % 11 > 1 && i % 11 < 9 && i > 20 ? 40 + 9 * (i % 23) : 0));
  }
  {
    const bool slip = false;
    auto p = jets(71, 43);
    setSides(p, Side::inflow, Side::wall, slip ? Side::open : Side::slip, Side::wall);
    p.left.velocity = glm::vec3(15, 2, 0);
    p.left.profile = sim::FluidSide::Profile::parabola;
    p.obstaclesSlip = slip;
    p.viscosity = 1.5F;
    p.lift = 20.0F;
    p.strokes[0].setsTemperature = true;
    p.strokes[0].temperature = 1;
    p.obstacles.resize(4);
    p.obstacles[0].center = scene::Animated<glm::vec3>(
        {{0.0, glm::vec3(18, 15, 0)}, {0.3, glm::vec3(25.5, 19, 0)}}, scene::Ease::smooth);
    p.obstacles[0].radius = 5.5F;
    p.obstacles[1].shape = sim::FluidObstacle::Shape::image;
    p.obstacles[1].image = file;
    p.obstacles[1].scale = 1.3F;
    p.obstacles[1].center = glm::vec3(20, 34, 0);
    p.obstacles[1].turn = scene::Animated<float>({{0.0, 0.0F}, {1.0, 200.0F}}, scene::Ease::linear);
    // This obstacle encloses a pocket at the right end and moves towards it.
    p.obstacles[2].shape = sim::FluidObstacle::Shape::box;
    p.obstacles[2].center = scene::Animated<glm::vec3>(
        {{0.0, glm::vec3(45, 21, 0)}, {1.0, glm::vec3(60, 21, 0)}}, scene::Ease::linear);
    p.obstacles[2].extent = {5, 60, 0};
    p.obstacles[3].center = glm::vec3(60, 10, 0);
    p.obstacles[3].radius = 3;
    p.cycles = 60;
    compareFluid(p, 4);
  }
  std::filesystem::remove(file);
}

TEST_CASE("fluid: a diverging flow reports the first step and the lowest cell") {
  testContext();
  auto p = jets(75, 59);
  p.speed = 0.01F;  // The parameter "speed" is far below the jets' speed of 60.
  p.substeps = 1;
  for (sim::FluidStroke& stroke : p.strokes) stroke.at = 0.05;  // The strokes act in the second step.
  scene::Object object;
  object.name = "bath";
  object.kind = "fluid";
  object.parameters = std::make_unique<sim::FluidParameters>(p);
  const std::vector<sim::ColliderShape> none;
  const auto gpu = sim::fluidKind().make(object, {false, 5, fluidFrame, &none});
  FluidTwin twin(sim::FluidPlan(p, "bath", 5, fluidFrame));
  gpu->step(0, {});
  twin.step(0);
  CHECK(gpu->status()->readAll<unsigned>()[0] == 0xffffffffU);
  gpu->step(fluidFrame, {});
  twin.step(fluidFrame);
  const auto speedOf = [&](int cell) {
    const glm::vec4& here = twin.flow[twin.index(cell % p.size.x, cell / p.size.x)];
    return std::max(std::abs(here.x), std::abs(here.y));
  };
  int lowest = 0;
  while (lowest < p.size.x * p.size.y && speedOf(lowest) <= sim::lostFluidSpeed * p.speed) ++lowest;
  const auto status = gpu->status()->readAll<unsigned>();
  CHECK(status[0] == 2);
  CHECK(status[1] == static_cast<unsigned>(lowest));
}

TEST_CASE("flow lines equal their CPU twin, around obstacles and across a seam") {
  for (const bool torus : {false, true}) {
    auto p = jets(31, 22);
    if (torus) setSides(p, Side::periodic, Side::periodic, Side::wall, Side::open);
    p.show = sim::FluidParameters::Show::lines;
    p.lineDetail = torus ? 2 : 3;
    p.obstacles.resize(1);
    p.obstacles[0].center = glm::vec3(15, 12, 0);
    p.obstacles[0].radius = 4;
    testContext();
    const sim::FluidPlan plan(p, "bath", 5, fluidFrame);
    sim::FluidKernels kernels("bath", plan, false);
    FluidTwin twin(plan);
    kernels.start(0);
    kernels.beginFrame(0);
    for (int i = 1; i <= plan.substeps(); ++i) kernels.advance(0, i, 1);
    kernels.prepareDrawing(0.7);
    twin.step(0);
    const std::vector<float> want = twin.lines(0.7);
    GLint buffer = 0;
    glGetTextureLevelParameteriv(kernels.shownWords().name(), 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING,
                                 &buffer);
    std::vector<glm::vec4> got(want.size());
    glGetNamedBufferSubData(static_cast<GLuint>(buffer),
                            static_cast<GLintptr>(kernels.shownWords().offset()),
                            static_cast<GLsizeiptr>(got.size() * 16), got.data());
    int different = 0;
    for (std::size_t i = 0; i < want.size(); ++i) different += got[i].w != want[i] ? 1 : 0;
    CHECK(different == 0);
  }
}

TEST_CASE("displayed values of a fluid equal their CPU twin") {
  for (const auto show : {sim::FluidParameters::Show::dye, sim::FluidParameters::Show::speed,
                          sim::FluidParameters::Show::vorticity, sim::FluidParameters::Show::pressure}) {
    auto p = jets(39, 27);
    p.show = show;
    p.look = show == sim::FluidParameters::Show::dye ? sim::FluidParameters::Look::ink
                                                     : sim::FluidParameters::Look::light;
    p.paper = {0.9F, 0.8F, 0.7F};
    p.obstacles.resize(1);
    p.obstacles[0].center = glm::vec3(20, 12, 0);
    p.obstacles[0].radius = 4;
    testContext();
    const sim::FluidPlan plan(p, "bath", 5, fluidFrame);
    sim::FluidKernels kernels("bath", plan, false);
    FluidTwin twin(plan);
    kernels.start(0);
    kernels.beginFrame(0);
    for (int i = 1; i <= plan.substeps(); ++i) kernels.advance(0, i, 1);
    kernels.prepareDrawing(0);
    twin.step(0);
    const auto want = twin.shown();
    GLint buffer = 0;
    glGetTextureLevelParameteriv(kernels.shownWords().name(), 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING,
                                 &buffer);
    std::vector<glm::vec4> got(static_cast<std::size_t>(plan.elements()));
    glGetNamedBufferSubData(static_cast<GLuint>(buffer),
                            static_cast<GLintptr>(kernels.shownWords().offset()),
                            static_cast<GLsizeiptr>(got.size() * 16), got.data());
    int different = 0;
    for (int y = 0; y < p.size.y; ++y)
      for (int x = 0; x < p.size.x; ++x) {
        const glm::vec4 a = got[twin.index(x, y)];
        const glm::vec4 b = want[static_cast<std::size_t>(y * p.size.x + x)];
        const bool coloured = show == sim::FluidParameters::Show::dye;
        different += a.w != b.w || (coloured && glm::vec3(a) != glm::vec3(b)) ? 1 : 0;
      }
    CHECK(different == 0);
  }
}
