#include "reference/spread_twin.hpp"

#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace {

using namespace simreel::shader;
using simreel::sim::SpreadParameters;

#define FUNCTION inline
#define precise
struct EpidemicModel {
  const EpidemicStep& stepData;
#include "glsl/spread/epidemic/model.glsl"
};
struct GaleModel {
  const WindTwin& wind;
  const WindGrid& windGrid;

  [[nodiscard]] vec4 loadWindCell(int x, int y) const { return wind.cell(x, y); }
#include "glsl/fluid/wind_model.glsl"
#include "glsl/spread/wildfire/gale.glsl"
};
struct WildfireModel {
  const WildfireStep& stepData;
  const std::vector<vec4>& climbs;

  [[nodiscard]] float climbFactor(int i) const { return climbs[static_cast<std::size_t>(i / 4)][i % 4]; }
#include "glsl/spread/wildfire/gale.glsl"
#include "glsl/spread/wildfire/model.glsl"
};
#undef precise
#undef FUNCTION

/// Runs `body` for each row, in bands of 16 rows that count separately. Returns the total counts.
template <class Body>
glm::uvec4 forRows(int rows, int threads, const Body& body) {
  const int bands = (rows + 15) / 16;
  std::vector<glm::uvec4> counts(static_cast<std::size_t>(bands), glm::uvec4(0));
  const auto band = [&](int b) {
    for (int y = 16 * b; y < std::min(rows, 16 * (b + 1)); ++y)
      body(y, counts[static_cast<std::size_t>(b)]);
  };
  if (threads == 1) {
    for (int b = 0; b < bands; ++b) band(b);
  } else {
    tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : threads);
    arena.execute([&] { tbb::parallel_for(0, bands, band); });
  }
  glm::uvec4 total(0);
  for (const glm::uvec4& c : counts) total += c;
  return total;
}

void countCell(glm::uvec4& counts, std::uint32_t cell) {
  ++counts[static_cast<int>((cell / 64 + 3) % 4)];
}

glm::uvec4 countAll(const std::vector<std::uint8_t>& cells) {
  glm::uvec4 counts(0);
  for (const std::uint8_t cell : cells) countCell(counts, cell);
  return counts;
}

/// A grid of cells with access to the neighbours of a cell.
struct Grid {
  const std::vector<std::uint8_t>& cells;
  glm::ivec2 size;
  bool torus;

  Grid(const std::vector<std::uint8_t>& all, const SpreadParameters& p)
      : cells(all), size(p.size), torus(p.border == SpreadParameters::Border::torus) {}
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] bool isActive(int x, int y) const {
    if (torus) {
      x = (x + 1024 * size.x) % size.x;
      y = (y + 1024 * size.y) % size.y;
    }
    if (x < 0 || y < 0 || x >= size.x || y >= size.y) return false;
    return (cells[index(x, y)] & classMask) == classActive;
  }
  /// Returns one bit per neighbour, row by row. The bit is set if the neighbour is active.
  [[nodiscard]] std::uint32_t neighbours(int x, int y) const {
    std::uint32_t bits = 0;
    int d = 0;
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        if (i == 0 && j == 0) continue;
        if (isActive(x + i, y + j)) bits |= 1U << d;
        ++d;
      }
    return bits;
  }
};

}  // namespace

EpidemicTwin::EpidemicTwin(simreel::sim::EpidemicPlan plan, double start)
    : cells(plan.firstCells()), counts{countAll(cells)}, plan_(std::move(plan)), next_(cells) {
  plan_.setPeople(counts[0].x + counts[0].y + counts[0].z);
  paint({{}, plan_.firstStrokes(start)});
}

void EpidemicTwin::paint(const simreel::sim::EpidemicPlan::Step& step) {
  EpidemicModel model{step.data};
  const auto width = static_cast<std::size_t>(plan_.parameters().size.x);
  for (const Stroke& stroke : step.strokes)
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (plan_.strokes().paints(stroke, {static_cast<int>(i % width), static_cast<int>(i / width)}))
        cells[i] = static_cast<std::uint8_t>(model.paintedPerson(cells[i], strokeNumber(stroke)));
  if (!step.strokes.empty()) counts.back() = countAll(cells);
}

void EpidemicTwin::step(double time, int threads) {
  for (const auto& one : plan_.frame(time)) oneStep(one, threads);
}

void EpidemicTwin::oneStep(const simreel::sim::EpidemicPlan::Step& step, int threads) {
  const auto& p = plan_.parameters();
  EpidemicModel model{step.data};
  const bool mixed = p.mixing == simreel::sim::EpidemicParameters::Mixing::global;
  const std::uint32_t everywhere = mixed ? model.mixedThreshold(counts.back().y) : 0;
  const Grid grid(cells, p);
  counts.push_back(forRows(p.size.y, threads, [&](int y, glm::uvec4& sums) {
    for (int x = 0; x < p.size.x; ++x) {
      const std::size_t i = grid.index(x, y);
      std::uint32_t cell = cells[i];
      const std::uint32_t kind = cell & classMask;
      if (step.data.ageing != 0 && kind >= classActive && (cell & 63U) != 63U) ++cell;
      const int n = mixed || kind != classReady ? 0 : std::popcount(grid.neighbours(x, y));
      const std::uint32_t threshold = mixed ? everywhere : step.data.infection[n / 4][n % 4];
      if (kind != classNobody) {
        const auto random = spreadRandom(static_cast<std::uint32_t>(i), step.data.step, step.data.seed);
        cell = model.nextPerson(cell, threshold, random);
      }
      next_[i] = static_cast<std::uint8_t>(cell);
      countCell(sums, cell);
    }
  }));
  std::swap(cells, next_);
  paint(step);
}

WildfireTwin::WildfireTwin(simreel::sim::WildfirePlan plan, double start)
    : cells(plan.firstCells()),
      counts{countAll(cells)},
      plan_(std::move(plan)),
      next_(cells),
      climbs_(plan_.climbFactors()) {
  paint({{}, plan_.firstStrokes(start)});
}

void WildfireTwin::paint(const simreel::sim::WildfirePlan::Step& step) {
  WildfireModel model{step.data, climbs_};
  const auto width = static_cast<std::size_t>(plan_.parameters().size.x);
  for (const Stroke& stroke : step.strokes)
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (plan_.strokes().paints(stroke, {static_cast<int>(i % width), static_cast<int>(i / width)}))
        cells[i] =
            static_cast<std::uint8_t>(model.paintedFuel(cells[i], strokeNumber(stroke), plan_.ground()[i]));
  if (!step.strokes.empty()) counts.back() = countAll(cells);
}

void WildfireTwin::blow(double time, float speed) {
  GaleModel model{*wind, wind->grid};
  const glm::ivec2 size = plan_.parameters().size;
  const glm::vec2 per = glm::vec2(wind->grid.size) / glm::vec2(size);
  const float scale = plan_.galeScale(time, speed);
  gales_.clear();
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const float px =
          std::min((static_cast<float>(x) + 0.5F) * per.x, static_cast<float>(wind->grid.size.x));
      const float py =
          std::min((static_cast<float>(y) + 0.5F) * per.y, static_cast<float>(wind->grid.size.y));
      gales_.push_back(model.galeOf(model.windPart(0, px, py), model.windPart(1, px, py), scale));
    }
}

void WildfireTwin::step(double time, int threads) {
  for (const auto& one : plan_.frame(time)) oneStep(one, threads);
}

void WildfireTwin::oneStep(const simreel::sim::WildfirePlan::Step& step, int threads) {
  const auto& p = plan_.parameters();
  WildfireModel model{step.data, climbs_};
  const Grid grid(cells, p);
  const auto groups = static_cast<std::uint32_t>((p.size.x + 15) / 16);
  counts.push_back(forRows(p.size.y, threads, [&](int y, glm::uvec4& sums) {
    for (int x = 0; x < p.size.x; ++x) {
      const std::size_t i = grid.index(x, y);
      std::uint32_t cell = cells[i];
      const std::uint32_t kind = cell & classMask;
      if (kind == classReady) {
        const auto random = spreadRandom(static_cast<std::uint32_t>(i), step.data.step, step.data.seed);
        const std::uint32_t weight = model.fuelWeight(plan_.fuels()[i]);
        const std::uint32_t incline = plan_.inclines().empty() ? evenGround : plan_.inclines()[i];
        const std::uint32_t gale = gales_.empty() ? 0 : gales_[i];
        bool caught = random >> 15U < model.catchChance(grid.neighbours(x, y), weight, incline, gale);
        if (p.embers && (random & 255U) < weight) {
          const std::uint32_t group =
              static_cast<std::uint32_t>(y) * groups + static_cast<std::uint32_t>(x) / 16;
          const uvec3 flight = hash3(uvec3(group, step.data.step, step.data.seed ^ 0x5bd1e995U));
          const ivec2 from =
              ivec2(x, y) -
              model.emberFlight(flight, gales_.empty() ? step.data.emberFlight : model.galeFlight(gale));
          if (flight.x >> 5U < step.data.emberThreshold && (flight.x & 15U) == (x & 15) &&
              grid.isActive(from.x, from.y))
            caught = true;
        }
        if (caught) cell = classActive;
      } else if (kind == classActive) {
        cell = model.nextBurning(cell, plan_.ground()[i]);
      } else if (kind == classSpent) {
        cell = model.nextBurnt(cell, plan_.ground()[i]);
      }
      next_[i] = static_cast<std::uint8_t>(cell);
      countCell(sums, cell);
    }
  }));
  std::swap(cells, next_);
  paint(step);
}
