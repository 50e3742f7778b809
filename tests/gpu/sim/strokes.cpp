// Tests strokes in every simulation that supports them. A stroke at the start time must be in the first
// state, and strokes must wrap around a torus.
#include "base/file.hpp"
#include "frame/image.hpp"
#include "gpu/sim/spread.hpp"
#include "sim/gray_scott/gray_scott.hpp"
#include "sim/gray_scott/parameters.hpp"
#include "sim/life/life.hpp"
#include "sim/life/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr glm::ivec2 size(61, 47);
constexpr double frameTime = 1.0 / 30;

template <class Parameters>
std::unique_ptr<sim::Simulation> make(const sim::SimulationKind& kind, const Parameters& parameters,
                                      double start) {
  testContext();
  scene::Object object;
  object.name = "field";
  object.kind = kind.kind.name;
  object.parameters = std::make_unique<Parameters>(parameters);
  static const std::vector<sim::ColliderShape> colliders;
  sim::Setting setting{false, 5, frameTime, &colliders};
  setting.startTime = start;
  return kind.make(object, setting);
}

/// Returns the cells within `radius` of a point. On a torus, uses the nearest of the point's nine periodic
/// images.
std::vector<bool> disk(glm::dvec2 middle, double radius, bool torus) {
  std::vector<bool> cells;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      double nearest = 1e9;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
          if (torus || (i == 0 && j == 0))
            nearest = std::min(
                nearest, std::hypot(x + 0.5 + i * size.x - middle.x, y + 0.5 + j * size.y - middle.y));
      cells.push_back(nearest <= radius);
    }
  return cells;
}

const sim::StrokeParameters brush(double at) {
  return spread::dot({0.3F, 46.2F, 0}, 5.2F, 1, at);
}

std::vector<bool> lifeCellsOf(const sim::StrokeParameters& stroke, bool torus, double start, int frames) {
  sim::LifeParameters p;
  p.size = size;
  p.fill = 0;
  p.rule = "B/S012345678";  // With this rule, no cell changes by itself.
  p.stepsPerSecond = 30;
  p.border = torus ? sim::LifeBorder::torus : sim::LifeBorder::dead;
  p.strokes = {stroke};
  const auto gpu = make(sim::lifeKind(), p, start);
  for (int i = 0; i < frames; ++i) gpu->step(start + i * frameTime, {});
  const auto words = gpu->state()[0].buffer->readAll<std::uint32_t>();
  std::vector<bool> cells;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      cells.push_back((words[static_cast<std::size_t>(4 * y + x / 32)] >> (x % 32) & 1U) != 0);
  return cells;
}

std::vector<bool> lifeCells(bool torus, double at, double start, int frames) {
  return lifeCellsOf(brush(at), torus, start, frames);
}

std::vector<bool> grayScottCells(bool /*torus*/, double at, double start, int frames) {
  sim::GrayScottParameters p;
  p.size = size;
  p.seedCount = 0;
  p.diffuseU = p.diffuseV = 0;
  p.feed = scene::Animated<float>(0.0F);
  p.kill = scene::Animated<float>(0.0F);
  p.steps = 1;
  p.strokes = {brush(at)};
  const auto gpu = make(sim::grayScottKind(), p, start);
  for (int i = 0; i < frames; ++i) gpu->step(start + i * frameTime, {});
  const auto pairs = gpu->state()[0].buffer->readAll<glm::vec4>();
  std::vector<bool> cells;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::vec4& pair = pairs[static_cast<std::size_t>(y * ((size.x + 1) / 2) + x / 2)];
      cells.push_back((x % 2 == 0 ? pair.y : pair.w) > 0.5F);
    }
  return cells;
}

template <class Parameters>
std::vector<bool> spreadCells(const sim::SimulationKind& kind, Parameters p, double at, double start,
                              int frames) {
  p.stepsPerSecond = 30;
  p.size = size;
  p.strokes = {brush(at)};
  const auto gpu = make(kind, p, start);
  for (int i = 0; i < frames; ++i) gpu->step(start + i * frameTime, {});
  const auto state = spread::cellsOf(*gpu, size);
  std::vector<bool> cells;
  glm::uvec4 counts(0);
  for (const std::uint8_t cell : state) {
    cells.push_back(cell >> 6 == 2);
    ++counts[(cell / 64 + 3) % 4];
  }
  CHECK(spread::rowsOf(*gpu).back() == counts);  // The counts must include painted cells.
  return cells;
}

std::vector<bool> epidemicCells(bool torus, double at, double start, int frames) {
  sim::EpidemicParameters p;
  p.border = torus ? sim::SpreadParameters::Border::torus : sim::SpreadParameters::Border::closed;
  p.infected = 0;
  p.beta = 0.0F;
  p.gamma = 0.0F;
  return spreadCells(sim::epidemicKind(), p, at, start, frames);
}

std::vector<bool> wildfireCells(bool torus, double at, double start, int frames) {
  sim::WildfireParameters p;
  p.border = torus ? sim::SpreadParameters::Border::torus : sim::SpreadParameters::Border::closed;
  p.spread = 0.0F;
  p.patchiness = 0;
  return spreadCells(sim::wildfireKind(), p, at, start, frames);
}

struct Painted {
  const char* name;
  std::vector<bool> (*cells)(bool torus, double at, double start, int frames);
  bool bounded;
};
constexpr Painted paintedKinds[] = {{"life", lifeCells, true},
                                    {"grayScott", grayScottCells, false},
                                    {"epidemic", epidemicCells, true},
                                    {"wildfire", wildfireCells, true}};

}  // namespace

TEST_CASE("strokes: a stroke at time 0 is in frame 0, wrapped on a torus or clipped at a border") {
  for (const Painted& kind : paintedKinds)
    for (const bool torus : {true, false}) {
      if (!torus && !kind.bounded) continue;
      INFO(kind.name, torus ? ", torus" : ", bounded");
      const auto expected = disk({0.3, 46.2}, 5.2, torus);
      CHECK(std::count(expected.begin(), expected.end(), true) > 20);
      CHECK(kind.cells(torus, 0, 0, 0) == expected);
    }
}

TEST_CASE("strokes: a stroke appears in the first frame at or after its time, with any pre-roll") {
  const auto painted = disk({0.3, 46.2}, 5.2, true);
  const std::vector<bool> none(painted.size());
  for (const Painted& kind : paintedKinds) {
    INFO(kind.name);
    CHECK(kind.cells(true, 0, -3 * frameTime, 2) == none);
    CHECK(kind.cells(true, 0, -3 * frameTime, 3) == painted);
    CHECK(kind.cells(true, -3 * frameTime, -3 * frameTime, 0) == painted);
    CHECK(kind.cells(true, 1.5 * frameTime, 0, 1) == none);
    CHECK(kind.cells(true, 1.5 * frameTime, 0, 2) == painted);
  }
}

TEST_CASE("strokes: an image stroke paints exactly its own pixels") {
  // The image's first column and row are white. A read beyond a row's end returns the first pixel of the
  // next row, which is white, so the test detects it.
  constexpr glm::ivec2 stamp(9, 5), at(20, 11);
  frame::Image picture{stamp.x, stamp.y, {}};
  std::vector<bool> expected(static_cast<std::size_t>(size.x) * size.y);
  for (int y = 0; y < stamp.y; ++y)
    for (int x = 0; x < stamp.x; ++x) {
      const bool light = x == 0 || y == 0 || (x + y) % 3 == 0;
      const auto level = static_cast<std::uint8_t>(light ? 255 : 0);
      picture.bytes.insert(picture.bytes.end(), {level, level, level, 255});
      expected[static_cast<std::size_t>((y + at.y) * size.x + x + at.x)] = light;
    }
  const auto file = temporaryFile("stamp.png");
  writeFileAtomically(file, frame::encodePng(picture, {}));
  sim::StrokeParameters stroke = spread::dot({at.x, at.y, 0}, 1, 1, 0);
  stroke.shape = sim::StrokeParameters::Shape::image;
  stroke.image = file;
  CHECK(lifeCellsOf(stroke, false, 0, 0) == expected);
  std::filesystem::remove(file);
}
