#include "sim/reaction/stability.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace simreel::sim {

namespace {

constexpr int probeSide = 4;
/// Number of iterations until the fastest-growing wave dominates, and number of further iterations over
/// which its growth is measured.
constexpr int probeTurns = 24, probeMeasured = 24;
/// Height of the waves as a fraction of the state's values.
constexpr double probeHeight = 1e-4;
/// Tolerated logarithm of the growth. With Euler's method, oscillations grow slightly until nonlinear terms
/// limit them.
constexpr double probeAllowed = 0.08;

/// Computes steps of small perturbations around a state that is equal in all cells.
class StepProbe {
 public:
  StepProbe(const ReactionPlan& plan, const RulePlanes& first, std::size_t cell)
      : plan_(plan), values_(plan.valuesAt(0)) {
    const ReactionParameters& p = plan.parameters();
    field_.size = {probeSide, probeSide};
    field_.depth = p.depth > 1 ? probeSide : 1;
    field_.seed = plan.noiseSeed();
    const std::size_t cells = probeSide * static_cast<std::size_t>(field_.rows());
    double greatest = 0;
    for (const std::vector<float>& plane : first) {
      field_.stage.emplace_back(cells, plane[cell]);
      greatest = std::max(greatest, std::abs(static_cast<double>(plane[cell])));
    }
    field_.next = field_.base = field_.stage;
    if (plan.program().sums) field_.sum = field_.stage;
    field_.lets.assign(static_cast<std::size_t>(plan.program().lets), std::vector<float>(cells));
    field_.weights.assign(p.parameters.size(), std::vector<float>(cells));
    height_ = probeHeight * (greatest > 0 ? greatest : 1);
  }

  /// Returns the logarithm of the growth per step of the fastest-growing wave, by power iteration.
  [[nodiscard]] double growth(double dt) const {
    const RulePlanes end = stepped(field_.stage, dt);
    RulePlanes wave = field_.stage;
    std::uint32_t hash = 1;
    for (std::vector<float>& plane : wave)
      for (float& cell : plane)
        cell = static_cast<float>((hash = hash * 747796405U + 2891336453U) >> 8U) - 0x1p23F;
    double sum = 0;
    double length = lengthOf(wave);
    for (int turn = 0; turn < probeTurns + probeMeasured; ++turn) {
      RulePlanes state = field_.stage;
      for (std::size_t s = 0; s < state.size(); ++s)
        for (std::size_t i = 0; i < state[s].size(); ++i)
          state[s][i] += static_cast<float>(wave[s][i] * (height_ / length));
      wave = stepped(std::move(state), dt);
      for (std::size_t s = 0; s < wave.size(); ++s)
        for (std::size_t i = 0; i < wave[s].size(); ++i) wave[s][i] -= end[s][i];
      length = lengthOf(wave);
      if (!std::isfinite(length) || length == 0) return std::isfinite(length) ? -HUGE_VAL : std::nan("");
      if (turn >= probeTurns) sum += std::log(length / height_);
    }
    return sum / probeMeasured;
  }

 private:
  [[nodiscard]] static double lengthOf(const RulePlanes& wave) {
    double squares = 0, count = 0;
    for (const std::vector<float>& plane : wave)
      for (const float cell : plane) {
        squares += static_cast<double>(cell) * static_cast<double>(cell);
        ++count;
      }
    return std::sqrt(squares / count);
  }
  [[nodiscard]] RulePlanes stepped(RulePlanes state, double dt) const {
    RuleField field = field_;
    field.stage = std::move(state);
    std::vector<float> values = values_;
    values[UniformIndex::dt] = static_cast<float>(dt);
    values[UniformIndex::halfDt] = static_cast<float>(dt / 2);
    values[UniformIndex::sixthDt] = static_cast<float>(dt / 6);
    evaluateStep(plan_, std::move(values), 0, 0, field);
    return std::move(field.stage);
  }

  const ReactionPlan& plan_;
  std::vector<float> values_;
  RuleField field_;
  double height_ = probeHeight;
};

/// Halves the step at least three times, and then until the growth per step is small. Growth that remains
/// at the smallest step is considered to be growth of the equations.
std::optional<StepGrowth> unstableNear(const StepProbe& probe, double dt) {
  constexpr double little = 0.3;
  std::vector<double> growths = {probe.growth(dt)};
  if (std::isnan(growths[0]) || growths[0] < probeAllowed) return {};
  while (growths.size() < 4 || (std::abs(growths.back()) > little && growths.size() < 24)) {
    growths.push_back(probe.growth(std::ldexp(dt, -static_cast<int>(growths.size()))));
    if (std::isnan(growths.back())) return {};
  }
  const double rate = std::max(0.0, std::ldexp(growths.back(), static_cast<int>(growths.size()) - 1));
  for (std::size_t halved = 0; halved < growths.size(); ++halved)
    if (growths[halved] <= std::ldexp(rate, -static_cast<int>(halved)) + probeAllowed) {
      if (halved == 0) return {};
      return StepGrowth{std::exp(growths[0]), std::exp(rate), std::ldexp(dt, -static_cast<int>(halved))};
    }
  return {};
}

}  // namespace

std::optional<StepGrowth> unstableSteps(const ReactionPlan& plan, const RulePlanes& first) {
  const std::vector<int>& nexts = plan.rule().nexts;
  if (plan.links() != nullptr || first.empty() ||
      std::any_of(nexts.begin(), nexts.end(), [](int next) { return next >= 0; }))
    return {};
  const auto [minimum, maximum] = std::minmax_element(first[0].begin(), first[0].end());
  std::vector<std::size_t> cells = {static_cast<std::size_t>(minimum - first[0].begin()),
                                    static_cast<std::size_t>(maximum - first[0].begin()),
                                    first[0].size() / 2};
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::optional<StepGrowth> worst;
  for (const std::size_t cell : cells) {
    const auto found = unstableNear(StepProbe(plan, first, cell), plan.parameters().dt);
    if (found && (!worst || found->dt < worst->dt)) worst = found;
  }
  return worst;
}

}  // namespace simreel::sim
