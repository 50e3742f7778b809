#include "reference/fluid_twin.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simreel::shader {

namespace {

/// Provides the variables and functions that glsl/fluid/grid.glsl declares, with the same names.
struct FluidModel {
  ivec2 size;
  FluidStep stepData;
  int leftKind, rightKind, topKind, bottomKind;
  bool heats, viscous, confines, sinks, secondOrder, cubic, obstacles, obstaclesSlip, obstaclesMove,
      pocketsGrow;
  const std::vector<vec4>& flow;
  const std::vector<vec4>& carried;
  const std::vector<vec4>& dye;
  const sim::FluidSolids& solids;
  const FluidSolidSet& solidSet;
  const std::vector<vec2>& sum;
  const sim::FluidPlan::Brushes* painting = nullptr;
  const sim::Strokes* strokes = nullptr;
  std::vector<FluidBrush> brushes = {};
  int firstBrush = 0, endBrush = 0;

  [[nodiscard]] std::size_t element(int x, int y) const {
    return static_cast<std::size_t>((y + 1) * (size.x + 2) + x + 1);
  }
  [[nodiscard]] vec4 flowAt(int x, int y) const { return flow.at(element(x, y)); }
  [[nodiscard]] vec4 carriedAt(int x, int y) const { return carried.at(element(x, y)); }
  [[nodiscard]] static int wrapped(int i, int count, bool wraps) {
    return wraps ? (i + count) % count : std::clamp(i, -1, count);
  }
  [[nodiscard]] vec4 dyeAt(int x, int y) const {
    return dye.at(
        element(wrapped(x, size.x, leftKind == periodicSide), wrapped(y, size.y, topKind == periodicSide)));
  }
  [[nodiscard]] vec2 faceAt(int x, int y) const {
    const uvec4& block = solids.words().at(static_cast<std::size_t>(y / 2 * (size.x / 2 + 1) + x / 2));
    return faceWeights(block[y % 2 * 2 + x % 2]);
  }
  [[nodiscard]] uint solidWord(int x, int y) const { return obstacles ? solids.wordAt(x, y) : 0xffffU; }
  [[nodiscard]] vec2 sumAt(int x, int y) const {
    if (leftKind == periodicSide) x = (x + size.x) % size.x;
    if (topKind == periodicSide) y = (y + size.y) % size.y;
    if (x < 0 || y < 0 || x >= size.x || y >= size.y) return {0, 0};
    return sum.at(static_cast<std::size_t>(y * size.x + x));
  }
  [[nodiscard]] bool brushPaints(int i, ivec2 cell) const {
    return strokes->paints(painting->strokes.at(static_cast<std::size_t>(i)), cell);
  }

#define FUNCTION [[nodiscard]] inline
#define precise
#include "glsl/fluid/transport.glsl"
// This file needs transport.glsl, which defines the types of cells.
#include "glsl/fluid/projected.glsl"
// The following files are kernels that change cells.
#include "glsl/fluid/brush.glsl"
#include "glsl/fluid/look/look.glsl"
  int lineDetail = 1;
  float linePerDetail = 1, linePhase = 0;
// This file, line integral convolution, needs the variables above.
#include "glsl/fluid/look/lines.glsl"
#undef precise
#undef FUNCTION
};

FluidModel modelOf(const sim::FluidPlan& plan, const sim::FluidSolids& solids, const FluidStep& step,
                   const std::vector<vec4>& flow, const std::vector<vec4>& carried,
                   const std::vector<vec4>& dye, const std::vector<vec2>& sum) {
  const sim::FluidParameters& p = plan.parameters();
  return {p.size,
          step,
          static_cast<int>(p.left.kind),
          static_cast<int>(p.right.kind),
          static_cast<int>(p.top.kind),
          static_cast<int>(p.bottom.kind),
          p.heats(),
          p.viscous(),
          p.confines(),
          p.sinks(),
          p.advection == sim::FluidParameters::Advection::macCormack,
          p.advection == sim::FluidParameters::Advection::cubic,
          !p.obstacles.empty(),
          p.obstaclesSlip,
          p.obstaclesMove(),
          p.pocketsGrow(),
          flow,
          carried,
          dye,
          solids,
          solids.set(),
          sum};
}

}  // namespace

}  // namespace simreel::shader

using namespace simreel;

FluidTwin::FluidTwin(sim::FluidPlan plan, double start) : plan_(std::move(plan)) {
  const glm::ivec2 size = plan_.size();
  flow = plan_.firstFlow(start);
  flow.resize(static_cast<std::size_t>(plan_.elements()));
  dye.resize(flow.size());
  carried_.resize(flow.size());
  sum_.resize(static_cast<std::size_t>(size.x * size.y));
  for (const sim::FluidLevel& level : plan_.levels().levels()) {
    Level l{level.cells, plan_.parameters().wrapsX(), plan_.parameters().wrapsY(), {}, {}, {}};
    l.rhs.resize(static_cast<std::size_t>(level.cells.x * level.cells.y));
    l.value.resize(l.rhs.size());
    levels_.push_back(std::move(l));
  }
  place(start, 0);
  step_ = plan_.stepAt(start, 0);
  paint(start, 0);
  project();
}

void FluidTwin::place(double time, int step) {
  auto solids = plan_.solidsAt(time, step);
  if (solids == solids_) return;
  solids_ = std::move(solids);
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    const sim::FluidLevel& level = solids_->levels().levels()[i];
    levels_[i].faces.clear();
    for (int y = 0; y <= level.cells.y; ++y)
      for (int x = 0; x <= level.cells.x; ++x) {
        const auto block = static_cast<std::size_t>(level.start + y / 2 * level.blocks().x + x / 2);
        levels_[i].faces.push_back(shader::faceWeights(solids_->words()[block][y % 2 * 2 + x % 2]));
      }
  }
}

void FluidTwin::step(double time) {
  for (int i = 1; i <= plan_.substeps(); ++i) {
    place(time, i);
    step_ = plan_.stepAt(time, i);
    advect();
    paint(time, i);
    project();
    moveDye();
  }
}

namespace {

template <class Cell>
std::vector<glm::vec4> eachCell(glm::ivec2 size, const Cell& cell) {
  std::vector<glm::vec4> cells;
  cells.reserve(static_cast<std::size_t>((size.x + 2) * (size.y + 2)));
  for (int y = -1; y <= size.y; ++y)
    for (int x = -1; x <= size.x; ++x) cells.push_back(cell(x, y));
  return cells;
}

}  // namespace

void FluidTwin::advect() {
  auto model = shader::modelOf(plan_, *solids_, step_, flow, carried_, dye, sum_);
  float fastest = 0;
  for (int y = 0; y < plan_.size().y; ++y)
    for (int x = 0; x < plan_.size().x; ++x) {
      const glm::vec4 cell = model.flowAt(x, y);
      fastest = std::max({fastest, std::abs(cell.x), std::abs(cell.y)});
    }
  const float kept = model.keptPressure(fastest);
  flow = eachCell(plan_.size(), [&](int x, int y) { return model.pushedCell(kept, x, y); });
  carried_ = eachCell(plan_.size(), [&](int x, int y) { return model.carriedCell(x, y); });
  flow = eachCell(plan_.size(), [&](int x, int y) { return model.steppedCell(x, y); });
}

void FluidTwin::paint(double time, int step) {
  const sim::FluidPlan::Brushes brushes = plan_.brushesAt(time, step);
  if (brushes.brushes.empty()) return;
  auto model = shader::modelOf(plan_, *solids_, step_, flow, carried_, dye, sum_);
  model.painting = &brushes;
  model.strokes = &plan_.strokes();
  model.brushes = brushes.brushes;
  model.endBrush = static_cast<int>(brushes.brushes.size());
  auto nextFlow = eachCell(plan_.size(), [&](int x, int y) { return model.paintedCell(x, y); });
  dye = eachCell(plan_.size(), [&](int x, int y) { return model.paintedDye(x, y); });
  flow = std::move(nextFlow);
}

void FluidTwin::moveDye() {
  auto model = shader::modelOf(plan_, *solids_, step_, flow, carried_, dye, sum_);
  for (int i = 0; i < plan_.dyePasses(); ++i)
    dye = eachCell(plan_.size(), [&](int x, int y) { return model.dyedCell(x, y); });
}

void FluidTwin::descend(std::size_t number) {
  Level& l = levels_[number];
  Level& coarse = levels_[number + 1];
  std::fill(l.value.begin(), l.value.end(), 0.0F);
  l.begin();
  const auto leftIn = [&](int x, int y) {
    if (x >= l.cells.x || y >= l.cells.y) return 0.0F;
    return l.leftIn(x, y);
  };
  for (int y = 0; y < coarse.cells.y; ++y)
    for (int x = 0; x < coarse.cells.x; ++x)
      coarse.rhs[coarse.index(x, y)] =
          shader::restricted(leftIn(2 * x, 2 * y), leftIn(2 * x + 1, 2 * y + 1));
}

void FluidTwin::bottom() {
  Level& l = levels_.back();
  std::fill(l.value.begin(), l.value.end(), 0.0F);
  for (int half = 0; half < 2 * shader::bottomSweeps; ++half)
    l.eachOf(half % 2, [&](int x, int y, const std::vector<float>& before) {
      const float aim = shader::relaxed(l.rhs[l.index(x, y)], l.sumAround(before, x, y),
                                        shader::diagonal(l.weights(x, y)));
      l.value[l.index(x, y)] = shader::overrelaxed(before[l.index(x, y)], aim);
    });
}

void FluidTwin::ascend(std::size_t number) {
  Level& l = levels_[number];
  const Level& coarse = levels_[number + 1];
  const auto coarseAt = [&](int x, int y) {
    if (l.wrapsX) x = (x + coarse.cells.x) % coarse.cells.x;
    if (l.wrapsY) y = (y + coarse.cells.y) % coarse.cells.y;
    const auto open = [](const sim::FluidSide& side) { return side.kind == sim::FluidSide::Kind::open; };
    const sim::FluidParameters& p = plan_.parameters();
    const glm::ivec2 maximum = coarse.cells - 1;
    if ((x < 0 && !open(p.left)) || (x > maximum.x && !open(p.right)) || (y < 0 && !open(p.top)) ||
        (y > maximum.y && !open(p.bottom)))
      return shader::noCell;
    const float value =
        coarse.value[coarse.index(std::clamp(x, 0, maximum.x), std::clamp(y, 0, maximum.y))];
    const bool beyond = x < 0 || y < 0 || x > maximum.x || y > maximum.y;
    return beyond && value < shader::noCell ? -value : value;
  };
  for (int y = 0; y < l.cells.y; ++y)
    for (int x = 0; x < l.cells.x; ++x) {
      const int i = x / 2, j = y / 2, toX = x % 2 == 0 ? i - 1 : i + 1, toY = y % 2 == 0 ? j - 1 : j + 1;
      float& value = l.value[l.index(x, y)];
      value = shader::raised(
          value, shader::prolonged(coarseAt(i, j), coarseAt(toX, j), coarseAt(i, toY), coarseAt(toX, toY)));
    }
  l.sweep();
}

void FluidTwin::cycle() {
  for (std::size_t i = 0; i + 1 < levels_.size(); ++i) descend(i);
  bottom();
  for (std::size_t i = levels_.size() - 1; i-- > 0;) ascend(i);
}

void FluidTwin::project() {
  const glm::ivec2 size = plan_.size();
  std::fill(sum_.begin(), sum_.end(), glm::vec2(0));
  auto model = shader::modelOf(plan_, *solids_, step_, flow, carried_, dye, sum_);
  Level& finest = levels_.front();
  float missing = 0;
  float speed = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      float& rhs = finest.rhs[finest.index(x, y)];
      rhs = model.missingFlow(x, y);
      missing = std::max(missing, std::abs(rhs));
    }
  // The kernel reads whole blocks of 2x2 cells, including the border ring.
  for (int y = 0; y < size.y / 2 * 2 + 2; ++y)
    for (int x = 0; x < size.x / 2 * 2 + 2; ++x) {
      const glm::vec4& cell = flow[index(std::min(x, size.x), std::min(y, size.y))];
      speed = std::max({speed, std::abs(cell.x), std::abs(cell.y)});
    }
  const float maximum = sim::aimedFluidDivergence * speed;
  for (int i = 0; i < plan_.parameters().cycles && missing > maximum; ++i) {
    cycle();
    ++cycles;
    missing = 0;
    std::vector<float> left = finest.rhs;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const std::size_t c = finest.index(x, y);
        const float value = finest.value[c];
        left[c] = finest.leftIn(x, y);
        missing = std::max(missing, std::abs(left[c]));
        const float more = value >= shader::noCell ? 0.0F : value;
        sum_[c] = {sum_[c].x + more, sum_[c].y + shader::lostInSum(sum_[c].x, more)};
      }
    finest.rhs = std::move(left);
  }
  flow = eachCell(size, [&](int x, int y) { return model.finishedCell(x, y); });
}

std::vector<glm::vec4> FluidTwin::shown() const {
  auto model = shader::modelOf(plan_, *solids_, step_, flow, carried_, dye, sum_);
  const sim::FluidParameters& p = plan_.parameters();
  std::vector<glm::vec4> cells;
  for (int y = 0; y < p.size.y; ++y)
    for (int x = 0; x < p.size.x; ++x) {
      const float open = model.openPart(x, y);
      const glm::vec3 color(model.shownColor(static_cast<int>(p.look), p.brightness, model.dyeAt(x, y),
                                             model.flowAt(x, y).z, p.paper));
      const float value = open == 0 ? 0.0F : model.shownValue(static_cast<int>(p.show), x, y);
      cells.emplace_back(p.obstacleColor + (color - p.obstacleColor) * open, value);
    }
  return cells;
}

std::vector<float> FluidTwin::lines(double time) const {
  auto model = shader::modelOf(plan_, *solids_, step_, flow, carried_, dye, sum_);
  const sim::FluidParameters& p = plan_.parameters();
  model.lineDetail = p.lineDetail;
  model.linePerDetail = 1.0F / static_cast<float>(p.lineDetail);
  model.linePhase = plan_.linePhase(time);
  std::vector<float> places;
  for (int y = 0; y < p.size.y * p.lineDetail; ++y)
    for (int x = 0; x < p.size.x * p.lineDetail; ++x) {
      const glm::vec2 at((static_cast<float>(x) + 0.5F) * model.linePerDetail,
                         (static_cast<float>(y) + 0.5F) * model.linePerDetail);
      places.push_back(model.isSolid(x / p.lineDetail, y / p.lineDetail) ? 0.0F : model.lineAt(at));
    }
  return places;
}

double FluidTwin::divergence() const {
  auto model = shader::modelOf(plan_, *solids_, step_, flow, carried_, dye, sum_);
  const glm::ivec2 size = plan_.size();
  double maximum = 0;
  double speed = 1e-30;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::dvec4 here(flow[index(x, y)]);
      speed = std::max({speed, std::abs(here.x), std::abs(here.y)});
      maximum = std::max(maximum, std::abs(double{model.missingFlow(x, y)}));
    }
  return maximum / speed;
}
