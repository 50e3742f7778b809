// Compares water with a plain loop. The file is separate from fluids.cpp, because both models define names
// such as `wallSide`.
#include "beside/memory.hpp"
#include "beside/subject.hpp"
#include "plain/plain.hpp"
#include "reference/water_twin.hpp"

#include <fmt/format.h>

namespace simreel::bench {

namespace {

constexpr int basinSide = 512, basinSteps = 16;
constexpr double basinBytes = 32;  // bytes per cell and step; level, two discharges and bed are read, and
                                   // as many bytes are written
constexpr double basinCells = double(basinSide) * basinSide;

/// Returns a basin with the given number of cells per side. The hills scale with the size.
sim::WaterParameters basin(int side) {
  sim::WaterParameters p;
  p.size = {side, side};
  p.cell = 0.1F;
  p.level = 0;
  p.bed = -1;
  p.hills.resize(2);
  p.hills[0].center = {6, 0, 4};
  p.hills[0].radii = {9, 0, 7};
  p.hills[0].height = 1.6F;
  p.hills[1].center = {-14, 0, -9};
  p.hills[1].radii = {6, 0, 8};
  p.hills[1].height = 0.9F;
  p.pools.resize(1);
  p.pools[0].from = {-26, 0, -26};
  p.pools[0].to = {-12, 0, 26};
  p.pools[0].level = 0.6F;
  p.drops.clear();
  p.rain.reset();
  p.strokes.clear();
  p.substeps = basinSteps;
  p.greatestSpeed = 4;
  const float wider = static_cast<float>(side) / basinSide;
  for (auto& hill : p.hills) {
    hill.center *= wider;
    hill.radii *= wider;
  }
  p.pools[0].from *= wider;
  p.pools[0].to *= wider;
  return p;
}

}  // namespace

Subject waterBasin() {
  const sim::WaterParameters p = basin(basinSide);
  const sim::WaterPlan plan(p, "basin", 1, frameSeconds);
  const shader::WaterStep uniforms = plan.stepAt(0);
  const auto own = std::make_shared<plain::Water>(
      basinSide, basinSide,
      plain::Water::Numbers{uniforms.ratio, uniforms.gravity, uniforms.thin, uniforms.dry, uniforms.kept});
  for (std::size_t i = 0; i < own->level.size(); ++i) {
    own->level[i] = plan.firstCells()[i].x;
    own->bed[i] = plan.firstCells()[i].w;
  }
  const GLuint first = nextBuffer();
  const auto steps = frames(onDevice("water", p), sim::StepWatch{});
  Subject subject{"water 512x512",
                  "1e6 cell-steps/s",
                  basinSteps * basinCells,
                  [=] {
                    for (int i = 0; i < basinSteps; ++i) own->step();
                  },
                  [=, twin = std::make_shared<WaterTwin>(plan)] {
                    for (int i = 0; i < basinSteps; ++i) twin->advance(uniforms);
                  },
                  steps};
  subject.after = [=] {
    const Taken taken = minimumOf(steps);
    fmt::print("  {:.1f} steps a second, {:.1f} a processor second, drawing of one in {} counted in\n",
               basinSteps / taken.wall, basinSteps / taken.processor, basinSteps);
    printBytes(basinBytes, basinSteps * basinCells / taken.processor);
    listBuffers("water", first, basinCells);
  };
  return subject;
}

void printWaterSpeed(int side) {
  const GLuint first = nextBuffer();
  const auto water = onDevice("water", basin(side));
  const double cells = double(side) * side;
  int frame = 0;
  const auto turn = [&] { water->pass(frame++ * frameSeconds); };
  turn();
  printSpeed(fmt::format("water {}x{}", side, side).c_str(), cells, basinSteps, turn,
             [] { return basinBytes; });
  listBuffers("water", first, cells);
}

}  // namespace simreel::bench
