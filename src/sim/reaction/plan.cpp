#include "sim/reaction/plan.hpp"

#include "base/log.hpp"
#include "sim/grid/picture_file.hpp"
#include "sim/reaction/model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simreel::sim {

namespace {

constexpr int maxRuleMapSide = 32768;

std::vector<StrokeParameters> plainStrokes(const std::vector<ReactionStroke>& strokes) {
  return {strokes.begin(), strokes.end()};
}

float stored(double value) {
  return shader::reaction::grained(static_cast<float>(value), storedGrain);
}

}  // namespace

ReactionPlan::ReactionPlan(ReactionParameters parameters, const std::string& object, int seed,
                           double frameSeconds)
    : parameters_(std::move(parameters)),
      seed_(seed),
      frameSeconds_(frameSeconds),
      rule_(understandRule(parameters_.ruleText())),
      program_(programOf(rule_, parameters_.method)),
      strokes_(
          plainStrokes(parameters_.strokes), seed,
          {parameters_.size, parameters_.boundary == RuleBoundary::torus, "reaction \"" + object + "\""}) {
  warnOfSteps(object);
}

// The fastest mode of the nine points, the checkerboard, has the eigenvalue -(16/3) / h^2; explicit methods
// of order 1 and 2 are stable for -2 <= dt lambda, that of order 4 for -2.785.
void ReactionPlan::warnOfSteps(const std::string& object) const {
  const ReactionParameters& p = parameters_;
  const double limit = p.method == RuleMethod::rk4 ? 2.785 : 2;
  for (const ReactionSpecies& species : p.species) {
    double most = 0;
    for (const auto& key : species.diffusion.keys()) most = std::max(most, static_cast<double>(key.value));
    const double number = p.dt * most / (p.spacing * p.spacing);
    const double greatest = limit * 3 / 16;
    if (number > greatest)
      warn(
          "reaction \"{}\": dt diffusion / spacing^2 of \"{}\" is {:.3g}, and a step is stable up to "
          "{:.3g}; "
          "lower dt to {:.3g}",
          object, species.name, number, greatest, p.dt * greatest / number);
  }
}

void ReactionPlan::checkPictures() const {
  for (const ReactionParameter& parameter : parameters_.parameters)
    if (!parameter.image.empty())
      static_cast<void>(loadPicture(parameter.image, "map of a parameter", maxRuleMapSide));
}

std::vector<float> ReactionPlan::edges() const {
  std::vector<float> all(maxSpecies);
  for (std::size_t i = 0; i < parameters_.species.size(); ++i) all[i] = stored(parameters_.species[i].edge);
  return all;
}

std::vector<float> ReactionPlan::weightsOf(const ReactionParameter& parameter) const {
  const glm::ivec2 size = parameters_.size;
  std::vector<float> weights;
  weights.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  if (!parameter.image.empty()) {
    const Picture picture = loadPicture(parameter.image, "map of a parameter", maxRuleMapSide);
    for (const std::uint8_t level : levelsOnGrid(picture, size))
      weights.push_back(static_cast<float>(level) / 255.0F);
    return weights;
  }
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      weights.push_back(parameter.across ? static_cast<float>(x) / static_cast<float>(size.x - 1)
                        : parameter.down ? static_cast<float>(y) / static_cast<float>(size.y - 1)
                                         : 0.0F);
  return weights;
}

RuleField ReactionPlan::firstField() const {
  const ReactionParameters& p = parameters_;
  RuleField field;
  field.size = p.size;
  field.boundary = p.boundary;
  field.edges = edges();
  field.seed = noiseSeed();
  const auto cells = static_cast<std::size_t>(p.size.x) * static_cast<std::size_t>(p.size.y);
  const bool mapped = std::any_of(p.parameters.begin(), p.parameters.end(),
                                  [](const ReactionParameter& parameter) { return parameter.isMapped(); });
  if (mapped)
    for (const ReactionParameter& parameter : p.parameters) field.weights.push_back(weightsOf(parameter));
  field.stage = evaluateStarts(rule_, valuesAt(0), field);
  field.next = field.base = field.stage;
  if (program_.sums) field.sum = field.stage;
  field.lets.assign(static_cast<std::size_t>(program_.lets), std::vector<float>(cells));
  return field;
}

std::vector<float> ReactionPlan::valuesAt(double time) const {
  const ReactionParameters& p = parameters_;
  std::vector<float> values(static_cast<std::size_t>(rule_.told.count()));
  const auto set = [&](int place, double value) {
    values[static_cast<std::size_t>(place)] = stored(value);
  };
  set(ToldPlaces::dt, p.dt);
  set(ToldPlaces::halfDt, p.dt / 2);
  set(ToldPlaces::sixthDt, p.dt / 6);
  set(ToldPlaces::perLaplacian, 1 / (6 * p.spacing * p.spacing));
  set(ToldPlaces::perGradient, 1 / (2 * p.spacing));
  set(ToldPlaces::spacing, p.spacing);
  set(ToldPlaces::width, p.spacing * p.size.x);
  set(ToldPlaces::height, p.spacing * p.size.y);
  for (std::size_t i = 0; i < p.parameters.size(); ++i) {
    const ReactionParameter& parameter = p.parameters[i];
    const auto now = static_cast<double>(parameter.value.at(time));
    const double end = parameter.across          ? *parameter.across
                       : parameter.down          ? *parameter.down
                       : parameter.image.empty() ? now
                                                 : parameter.white;
    set(ToldPlaces::value(static_cast<int>(i)), now);
    set(rule_.told.span(static_cast<int>(i)), end - now);
  }
  for (std::size_t i = 0; i < p.species.size(); ++i) {
    const auto d = static_cast<double>(p.species[i].diffusion.at(time));
    set(rule_.told.diffusion(static_cast<int>(i)), d / (6 * p.spacing * p.spacing));
    set(rule_.told.edge(static_cast<int>(i)), p.species[i].edge);
  }
  return values;
}

long ReactionPlan::stepAt(double time) const {
  return std::lround(time / frameSeconds_ * parameters_.steps);
}

float ReactionPlan::modelTime(long step, long first, double later) const {
  return stored((static_cast<double>(step - first) + later) * parameters_.dt);
}

std::vector<ReactionPlan::Painted> ReactionPlan::strokesAt(double time, int step) const {
  if (strokes_.empty()) return {};
  const double seconds = frameSeconds_ / std::max(parameters_.steps, 1);
  const double now = time + step * seconds;
  std::vector<int> numbers;
  const std::vector<shader::Stroke> active =
      strokes_.into(now, seconds, std::lround(now / seconds), &numbers);
  std::vector<Painted> painted;
  for (std::size_t i = 0; i < active.size(); ++i)
    painted.push_back(
        {active[i], parameters_.painted(parameters_.strokes[static_cast<std::size_t>(numbers[i])])});
  return painted;
}

void evaluateStep(const ReactionPlan& plan, std::vector<float> values, long number, long first,
                  RuleField& field) {
  const RuleProgram& program = plan.program();
  field.base = field.stage;
  for (const RuleProgram::Stage& stage : program.stages) {
    values[ToldPlaces::time] = plan.modelTime(number, first, stage.time);
    for (const int i : stage.passes) {
      const RulePass& pass = program.passes[static_cast<std::size_t>(i)];
      evaluatePass(plan.rule().graph, pass, toldOf(plan.rule().graph, pass, values),
                   static_cast<unsigned>(number), field);
    }
    std::swap(field.stage, field.next);
  }
}

std::vector<float> evaluateShown(const ReactionPlan& plan, std::vector<float> values, long number,
                                 long first, RuleField& field) {
  const RuleProgram& program = plan.program();
  if (program.showing.empty()) return field.stage[static_cast<std::size_t>(program.shown)];
  values[ToldPlaces::time] = plan.modelTime(number, first, 0);
  for (const int i : program.showing) {
    const RulePass& pass = program.passes[static_cast<std::size_t>(i)];
    evaluatePass(plan.rule().graph, pass, toldOf(plan.rule().graph, pass, values), 0, field);
  }
  return field.lets[static_cast<std::size_t>(program.shown)];
}

}  // namespace simreel::sim
