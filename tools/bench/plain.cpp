// Compares every simulation with a simple loop (tools/bench/plain/, one thread, -O3, not exact) and with
// its CPU twin on one thread. Prints rates by wall-clock time and per processor second, and their ratios to
// the simple loop. The three implementations run alternately, so that other load affects all equally. Rates
// are medians over the rounds. This benchmark is meant for software drivers; other benchmarks measure GPUs.
// If the minimum work per item is known, the last columns show the maximum rate of one processor for that
// work, and the percentage of it that the kernel reaches.
//
//     bench_plain [NAME [SECONDS]]     only cases whose name contains NAME; with SECONDS, runs only
//                                      the kernel, for profilers
#include "plain/plain.hpp"

#include "base/processor.hpp"
#include "beside/subject.hpp"
#include "gl/context.hpp"
#include "reference/cloth_twin.hpp"
#include "reference/gravity_tree_twin.hpp"
#include "reference/gray_scott_twin.hpp"
#include "reference/life_twin.hpp"
#include "reference/particles_twin.hpp"
#include "reference/spread_twin.hpp"
#include "sim/cave/growth.hpp"
#include "sim/contour/solid.hpp"
#include "sim/gray_scott/kernels.hpp"
#include "sim/life/stepper.hpp"
#include "sim/mesh/parameters.hpp"
#include "sim/particles/gravity_tree.hpp"
#include "sim/particles/pairs.hpp"

#include <cstdlib>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include <fmt/format.h>

using namespace simreel;
using namespace simreel::bench;

namespace {

Subject grayScott(int side) {
  sim::GrayScottParameters p;
  p.size = {side, side};
  p.seedCount = side;
  const sim::GrayScottPlan plan(p, "dish", 1, frameSeconds);
  const auto rates = plan.ratesAt(0);
  constexpr int steps = 16;
  auto own = std::make_shared<plain::GrayScott>(side, side);
  const auto first = plan.firstCells();
  for (std::size_t i = 0; i < own->v.size(); ++i) {
    own->u[i] = first[i / 2][i % 2 == 0 ? 0 : 2];
    own->v[i] = first[i / 2][i % 2 == 0 ? 1 : 3];
  }
  auto twin = std::make_shared<GrayScottTwin>(plan);
  auto kernels = std::make_shared<sim::GrayScottKernels>("dish", plan, false);
  kernels->setRates(rates);
  return {side == 512 ? "Gray-Scott 512x512" : "Gray-Scott 1024x1024",
          "1e6 cell-steps/s",
          double(steps) * side * side,
          [=] {
            for (int i = 0; i < steps; ++i)
              own->step(rates.diffuseU * 20 / rates.dt, rates.diffuseV * 20 / rates.dt,
                        rates.feed / rates.dt, rates.kill / rates.dt, rates.dt);
          },
          [=] { twin->advance(rates, steps); },
          [=] { kernels->advance(steps); }};
}

Subject cloth(bool constraints) {
  constexpr int side = 256;
  sim::ClothParameters p;
  p.size = {side, side};
  p.spacing = 3.2F / side;
  p.substeps = 8;
  if (constraints) p.solver = sim::ClothSolver::constraints;
  const sim::ClothPlan plan(p, 1, frameSeconds, {});
  const auto dt = static_cast<float>(frameSeconds / 8);
  auto own = std::make_shared<plain::Cloth>(
      side, side,
      plain::Cloth::Numbers{p.spacing, p.stiffness, p.shear, p.bend, 1 / p.mass, 9.81F, 1 - p.damping * dt,
                            dt, p.compliance, p.shearCompliance, p.bendCompliance});
  return {constraints ? "cloth, constraints" : "cloth, springs",
          "1e6 particle-steps/s",
          8.0 * side * side,
          [=] {
            for (int i = 0; i < 8; ++i)
              if (constraints)
                own->constraintStep();
              else
                own->springStep();
          },
          frames(std::make_shared<ClothTwin>(plan), 1),
          frames(onDevice("cloth", p), sim::StepWatch{})};
}

constexpr int spreadSteps = 16;

template <class Parameters>
Parameters field(int side) {
  Parameters p;
  p.size = {side, side};
  p.border = sim::SpreadParameters::Border::torus;
  p.stepsPerSecond = 60 * spreadSteps;
  return p;
}

/// Returns the epidemic case. A tenth of the cells is infected in the steady state.
Subject epidemic() {
  constexpr int side = 1024;
  auto p = field<sim::EpidemicParameters>(side);
  p.infected = 0.1;
  p.immune = 0.5;
  p.beta = 0.05F;
  p.gamma = 0.1F;
  p.waning = 0.02F;
  auto twin = std::make_shared<EpidemicTwin>(sim::EpidemicPlan(p, "city", 1, frameSeconds));
  std::vector<std::uint8_t> cells;
  for (const std::uint8_t cell : twin->cells) cells.push_back(cell >> 6);
  auto own = std::make_shared<plain::Epidemic>(side, cells);
  return {"epidemic 1024x1024",
          "1e6 cells/s",
          double(spreadSteps) * side * side,
          [=, frame = 0]() mutable {
            for (const auto& step : twin->plan().frame(frame++ * frameSeconds))
              own->step(&step.data.infection[0].x, step.data.recovery, step.data.waning, step.data.step);
          },
          frames(twin, 1),
          frames(onDevice("epidemic", p), sim::StepWatch{})};
}

/// Returns the wildfire case with `across` x `across` growing fires.
Subject wildfire(int across) {
  constexpr int side = 1024;
  auto p = field<sim::WildfireParameters>(side);
  p.windStrength = 0.5F;
  std::vector<std::uint8_t> cells(std::size_t(side) * side, 1);
  for (int i = 0; i < across * across; ++i) {
    sim::StrokeParameters spot;
    const int x = (2 * (i % across) + 1) * side / (2 * across);
    const int y = (2 * (i / across) + 1) * side / (2 * across);
    spot.from = spot.to = glm::vec3(x, y, 0);
    p.strokes.push_back(spot);
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) cells[std::size_t((y + dy) * side + x + dx)] = 20;
  }
  auto twin = std::make_shared<WildfireTwin>(sim::WildfirePlan(p, "forest", 1, frameSeconds));
  const auto data = twin->plan().frame(0)[0].data;
  float chances[8];
  for (int i = 0; i < 8; ++i) chances[i] = static_cast<float>(data.spread[i / 4][i % 4]) / 65536.0F;
  auto own = std::make_shared<plain::Wildfire>(side, cells, chances, p.burnSteps);
  return {across == 2 ? "wildfire, 4 fires" : "wildfire, 100 fires",
          "1e6 cells/s",
          double(spreadSteps) * side * side,
          [=, step = 0U]() mutable {
            for (int i = 0; i < spreadSteps; ++i) own->step(step++);
          },
          frames(twin, 1),
          frames(onDevice("wildfire", p), sim::StepWatch{})};
}

Subject life() {
  constexpr int side = 2048, generations = 16;
  auto own = std::make_shared<plain::Life>(side, side);
  for (std::size_t i = 0; i < own->cells.size(); ++i) own->cells[i] = i * 2654435761U % 97 < 29 ? 1 : 0;
  sim::LifeParameters p;
  p.size = {side, side};
  auto twin = std::make_shared<LifeTwin>(sim::LifePlan(p, "cells", 1, frameSeconds));
  p.stepsPerSecond = 60 * generations;
  return {"life 2048x2048",
          "1e6 cells/s",
          double(generations) * side * side,
          [=] {
            for (int i = 0; i < generations; ++i) own->step();
          },
          [=] {
            for (int i = 0; i < generations; ++i) twin->generation(1);
          },
          frames(onDevice("life", p), sim::StepWatch{})};
}

std::vector<plain::Body> bodiesOf(const std::vector<glm::vec4>& from) {
  std::vector<plain::Body> bodies;
  for (const glm::vec4& b : from) bodies.push_back({b.x, b.y, b.z, b.w});
  return bodies;
}

Subject pairs() {
  constexpr int count = 8192;
  const auto cloud = bodiesOf(Cloud::plummer, count);
  auto out = std::make_shared<std::vector<plain::Vec3>>(count);
  auto positions = std::make_shared<gl::Vec4Array>("bodies", cloud);
  auto accelerations = std::make_shared<gl::Vec4Array>("accelerations", count);
  auto gravity = std::make_shared<sim::PairGravity>(false);
  return {"all pairs, 8192",
          "1e6 pairs/s",
          double(count) * count,
          [=, own = bodiesOf(cloud)] { plain::pairs(own, *out, 1, 0.01F); },
          [=] {
            for (int i = 0; i < count; ++i) {
              const glm::vec3 a = pairAcceleration(cloud, glm::vec3(cloud[std::size_t(i)]), 1, 0.01F);
              (*out)[std::size_t(i)].x = a.x;
            }
          },
          [=] { gravity->accelerate(*positions, *accelerations, count, 1, 0.01F); }};
}

Subject tree() {
  constexpr int count = 16384;
  constexpr float opening = 0.7F;
  const auto cloud = bodiesOf(Cloud::plummer, count);
  auto out = std::make_shared<std::vector<plain::Vec3>>(count);
  auto positions = std::make_shared<gl::Vec4Array>("bodies", cloud);
  auto accelerations = std::make_shared<gl::Vec4Array>("accelerations", count);
  auto gravity = std::make_shared<sim::GravityTree>("tree", count, false);
  return {"tree, 16384",
          "1e6 bodies/s",
          count,
          [=, own = bodiesOf(cloud)] { plain::tree(own, *out, 1, 0.01F, opening); },
          [=] { static_cast<void>(GravityTreeTwin(cloud, opening).accelerations(1, 0.01F)); },
          [=] { gravity->accelerate(*positions, *accelerations, count, 1, 0.01F, opening); }};
}

Subject deform() {
  constexpr int side = 401;
  sim::MeshParameters p;
  p.size = {20, 0, 20};
  p.resolution = {side, side};
  p.deform.list.resize(1);
  p.deform.list[0].ripple.on = true;
  auto own = std::make_shared<plain::Ripple>(side, side, 20.0F);
  const auto device = onDevice("mesh", p);
  p.deform.technique = sim::DeformTechnique::singleThread;
  return {"deform, ripple",
          "1e6 vertices/s",
          double(side) * side,
          [=, frame = 0]() mutable { own->step(0.1F * static_cast<float>(frame++), 0.3F, 3.0F, 0.2F); },
          frames(onDevice("mesh", p), sim::StepWatch{}),
          frames(device, sim::StepWatch{})};
}

/// Returns the case of a cave. Each turn computes its map from noise and then the mesh of its walls.
Subject walls() {
  constexpr int side = 1024;
  sim::CaveParameters p;
  p.size = {side, side};
  p.connect = false;
  auto growth = std::make_shared<sim::CaveGrowth>("cave", p, 1);
  growth->advance(p.lastStage());
  auto own = std::make_shared<plain::Walls>(side, side);
  const auto words = growth->cells().buffer().readAll<unsigned>();
  for (std::size_t i = 0; i < own->rock.size(); ++i) own->rock[i] = words[i / 32] >> (i % 32) & 1U;
  auto solid = std::make_shared<sim::Solid>("cave", p.shape(0));
  sim::Field field;
  field.words = &growth->cells().view();
  field.cells = sim::Field::Cells::bits;
  field.size = p.size;
  field.rowWords = growth->grid().rowWords();
  return {"walls 1024x1024",
          "1e6 cells/s",
          double(side) * side,
          [=] { own->make(); },
          {},
          [=] {
            static_cast<void>(growth);
            solid->make(field, {0.0F, 0.2F});
            static_cast<void>(solid->settle());
          }};
}

}  // namespace

int main(int argc, char** argv) {
  const gl::Context context;
  fmt::print("device: {}, {} processors\n", context.device().name, processorCount());
  printHeads();
  using Make = std::function<Subject()>;
  const std::pair<std::string_view, Make> subjects[] = {{"gray-scott", [] { return grayScott(512); }},
                                                        {"gray-scott-1024", [] { return grayScott(1024); }},
                                                        {"springs", [] { return cloth(false); }},
                                                        {"constraints", [] { return cloth(true); }},
                                                        {"fabric", fabricSheet},
                                                        {"mesh-cloth", meshCloth},
                                                        {"contact", clothsInContact},
                                                        {"epidemic", epidemic},
                                                        {"wildfire", [] { return wildfire(10); }},
                                                        {"wildfire-4", [] { return wildfire(2); }},
                                                        {"life", life},
                                                        {"pairs", pairs},
                                                        {"tree", tree},
                                                        {"deform", deform},
                                                        {"walls", walls},
                                                        {"fluid", fluidTank},
                                                        {"water", waterBasin}};
  const std::string_view wanted = argc > 1 ? argv[1] : "";
  for (const auto& [name, make] : subjects)
    if (name.find(wanted) == std::string_view::npos)
      continue;
    else if (argc > 2)
      keepBusy(make(), std::atof(argv[2]));
    else
      print(make());
}
