#include "sim/spread/epidemic_plan.hpp"

#include "base/error.hpp"
#include "sim/ports/field_source.hpp"

#include <algorithm>
#include <cmath>

namespace simreel::sim {

namespace {

constexpr unsigned inhabitedSeed = 0x51ed270bU;
constexpr unsigned startSeed = 0xa3c59ac3U;

}  // namespace

void EpidemicParameters::describe(scene::Fields& f) {
  describeGrid(f);
  f.number("beta", beta, {0, 1}, "per step", "Probability that one infected neighbour infects.");
  f.number("gamma", gamma, {0, 1}, "per step", "Probability that an infected person recovers.");
  f.number("waning", waning, {0, 1}, "per step",
           "Probability that a recovered person can be infected again.");
  f.choice("mixing", mixing, {"local", "global"},
           "The eight neighbours infect, or eight cells drawn from the whole grid.");
  f.number("infected", infected, {0, 1}, "", "Fraction of the people that is infected at the start.");
  f.leftOut("infected", "0; in version 2 without strokes 0.0005");
  f.number("immune", immune, {0, 1}, "", "Fraction of the people that is immune at the start.");
  f.asset("population", population, "Picture: the lighter, the more of the cells are inhabited.");
  f.integer("trail", trail, {1, 100000}, "steps",
            "Steps over which the colour changes after an infection, and after a recovery.");
  f.list("strokes", strokes, "Timed brush strokes.", [](scene::Fields& s, StrokeParameters& stroke) {
    stroke.describe(s, 1, "1 infects susceptible people; 0 makes people immune.");
  });
  f.group("colors", "Linear RGB of the states.", [&](scene::Fields& c) {
    c.vector("susceptible", susceptible, {0, 1}, "", "People who can be infected.");
    c.vector("infection", infection, {0, 1}, "", "People infected just now.");
    c.vector("infectious", infectious, {0, 1}, "", "People infected for a long time.");
    c.vector("recovering", recovering, {0, 1}, "", "People recovered just now.");
    c.vector("recovered", recovered, {0, 1}, "", "People recovered a long time ago.");
    c.vector("nobody", nobody, {0, 1}, "", "Uninhabited cells.");
  });
  describeLook(f);
  if (infected + immune > 1)
    f.error(f.given("immune") ? "immune" : "infected",
            "\"infected\" and \"immune\" are more than all people");
  const bool painted =
      std::any_of(strokes.begin(), strokes.end(), [](const StrokeParameters& s) { return s.value > 0.5; });
  if (f.version() > 1 && !f.given("infected") && strokes.empty()) infected = 0.0005;
  if (infected == 0 && !painted)
    f.error(f.given("strokes") ? "strokes" : "infected",
            "nobody is ever infected: give \"infected\" above 0, or a stroke of value 1");
}

EpidemicPlan::EpidemicPlan(const EpidemicParameters& parameters, const std::string& object, int seed,
                           double frameSeconds)
    : parameters_(parameters),
      seed_(static_cast<unsigned>(seed)),
      pace_{parameters.stepsPerSecond, frameSeconds},
      strokes_(parameters.strokes, seed,
               {parameters.size, parameters.border == SpreadParameters::Border::torus,
                "epidemic \"" + object + "\""}) {}

std::vector<std::uint8_t> EpidemicPlan::firstCells() const {
  const EpidemicParameters& p = parameters_;
  const auto count = static_cast<std::size_t>(p.size.x) * static_cast<std::size_t>(p.size.y);
  std::vector<double> levels(p.population.empty() ? 0 : count);
  if (!p.population.empty()) levels = smoothLevels(p.population, "population map", p.size);
  std::vector<std::uint8_t> cells(count);
  bool anybody = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (!levels.empty() && cellFraction(i, seed_ ^ inhabitedSeed) >= levels[i]) {
      cells[i] = static_cast<std::uint8_t>(shader::classNobody + static_cast<unsigned>(levels[i] * 63.0));
      continue;
    }
    const double fraction = cellFraction(i, seed_ ^ startSeed);
    cells[i] = static_cast<std::uint8_t>(fraction < p.infected              ? shader::classActive
                                         : fraction < p.infected + p.immune ? shader::classSpent + 63
                                                                            : shader::classReady);
    anybody = true;
  }
  if (!anybody)
    fail(ExitCode::usage, "the population map {} is dark all over: nobody lives there; use a lighter one",
         p.population.string());
  return cells;
}

std::vector<shader::Stroke> EpidemicPlan::firstStrokes(double time) const {
  return strokes_.into(pace_.during(time).time, 1.0 / parameters_.stepsPerSecond, 0);
}

std::vector<EpidemicPlan::Step> EpidemicPlan::frame(double time) {
  const Pace::Steps pace = pace_.during(time);
  const EpidemicParameters& p = parameters_;
  // The cell format has 63 ages. If the trail is longer, ages increase only in some of the steps.
  const unsigned period = static_cast<unsigned>(std::max(1L, std::lround(p.trail / 63.0)));
  const double seconds = 1.0 / p.stepsPerSecond;
  std::vector<Step> steps;
  for (int i = 0; i < pace.count; ++i, ++done_) {
    const double t = pace.time + i * seconds;
    const double beta = static_cast<double>(p.beta.at(t));
    Step step{};
    // A susceptible person with n infected neighbours stays uninfected with the probability (1 - beta)^n.
    double well = 1;
    for (int n = 0; n <= 8; ++n, well *= 1 - beta)
      step.data.infection[n / 4][n % 4] = thresholdOf(1 - well);
    step.data.recovery = thresholdOf(static_cast<double>(p.gamma.at(t)));
    step.data.waning = thresholdOf(static_cast<double>(p.waning.at(t)));
    step.data.step = done_;
    step.data.seed = seed_;
    step.data.ageing = done_ % period == 0 ? 1 : 0;
    const double each = beta / people_;
    step.data.perInfected = static_cast<float>(each);
    step.data.per4096 = static_cast<float>(each * 4096);
    step.strokes = strokes_.into(t + seconds, seconds, static_cast<long>(done_) + 1);
    steps.push_back(std::move(step));
  }
  return steps;
}

std::vector<glm::vec3> EpidemicPlan::palette() const {
  const EpidemicParameters& p = parameters_;
  std::vector<glm::vec3> colors;
  appendGradient(colors, {p.nobody, 0.5F * p.nobody + 0.5F * p.susceptible}, 64);
  appendGradient(colors, {p.susceptible}, 64);
  appendGradient(colors,
                 {p.infection, 0.5F * p.infection + 0.5F * p.infectious, p.infectious, p.infectious}, 64);
  appendGradient(colors, {p.recovering, 0.4F * p.recovering + 0.6F * p.recovered, p.recovered}, 64);
  return colors;
}

void EpidemicParameters::ports(Ports& ports) const {
  ports.provide<FieldSource>();
}

std::span<const scene::Quantity> EpidemicParameters::quantities() const {
  static const scene::Quantity table[] = {{"susceptible", "", "People who can be infected."},
                                          {"infected", "", "People who infect others."},
                                          {"recovered", "", "People who are immune."},
                                          {"people", "", "All people; stays the same."}};
  return table;
}

}  // namespace simreel::sim
