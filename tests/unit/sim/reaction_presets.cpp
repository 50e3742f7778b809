// Tests presets by comparison with theory. Expected values are computed in double precision from the
// equations of the papers. They use Jacobians of homogeneous states, the symbol of the nine-point stencil,
// and exact solutions.
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/reaction/plan.hpp"
#include "sim/reaction/presets.hpp"
#include "sim/world/list.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

constexpr double second = 1.0;

sim::ReactionParameters equations(const std::string& members) {
  const std::string text = "{\"version\": 1, \"objects\": {\"r\": {\"reaction\": {" + members + "}}}}";
  const auto scene = scene::parseScene(text, "s.json", {}, sim::kinds());
  return dynamic_cast<const sim::ReactionParameters&>(*scene.objects.at(0).parameters);
}

/// Returns the state after `steps` steps.
sim::RuleField after(const sim::ReactionParameters& parameters, int steps) {
  const sim::ReactionPlan plan(parameters, "r", 1, second);
  sim::RuleField field = plan.firstField();
  for (int i = 0; i < steps; ++i) sim::evaluateStep(plan, plan.valuesAt(0), i, 0, field);
  return field;
}

double meanOf(const std::vector<float>& cells) {
  return std::accumulate(cells.begin(), cells.end(), 0.0) / static_cast<double>(cells.size());
}

using Matrix = std::array<std::array<double, 2>, 2>;
using Amplitudes = std::array<double, 2>;

/// A preset in a homogeneous state. It has the state and the growth rates of a small wave. The rates are
/// functions of the factor L by which the Laplacian multiplies the wave.
struct Homogeneous {
  const char* preset;
  Amplitudes state;
  std::function<Matrix(double L)> rates;
  double wave = 1e-3;  ///< amplitude of the wave, small enough for linear behaviour
};

std::vector<Homogeneous> homogeneousStates() {
  const double e = 0.05, a1 = 2, a0 = -0.1;  // FitzHugh-Nagumo; in equilibrium, u = a1 v + a0 and v = u -
                                             // u^3
  double v = 0;
  for (int i = 0; i < 100; ++i) {
    const double u = a1 * v + a0;
    v -= (u - u * u * u - v) / (a1 - 3 * u * u * a1 - 1);
  }
  const double u = a1 * v + a0;
  const double ga = 1.52, gh = ga * ga / 1.5;  // Gierer-Meinhardt with mu = 1, nu = 1.5 and s = 0.02
  // Oregonator; in equilibrium, u = v and u (1 - u) (u + q) = f u (u - q)
  const double q = 0.002, f = 3, half = (1 - f - q) / 2, o = half + std::sqrt(half * half + q * (1 + f));
  const double d = (o + q) * (o + q);
  return {
      {"heat",
       {0.4, 0},
       [](double L) {
         return Matrix{{{L, 0}, {0, 0}}};
       }},
      {"wave",
       {0, 0},
       [](double L) {
         return Matrix{{{0, 1}, {L, -0.001}}};
       }},
      {"fitzHughNagumo",
       {u, v},
       [=](double L) {
         return Matrix{{{1 - 3 * u * u + L, -1}, {e, -e * a1 + 4 * L}}};
       }},
      {"brusselator",
       {4.5, 7.5 / 4.5},
       [](double L) {
         return Matrix{{{7.5 - 1 + 2 * L, 4.5 * 4.5}, {-7.5, -4.5 * 4.5 + 16 * L}}};
       }},
      {"schnakenberg",
       {1, 0.9},
       [](double L) {
         return Matrix{{{-1 + 2 * 0.9 + L, 1}, {-2 * 0.9, -1 + 40 * L}}};
       }},
      {"giererMeinhardt",
       {ga, gh},
       [=](double L) {
         return Matrix{{{2 * ga / gh - 1 + L, -ga * ga / (gh * gh)}, {2 * ga, -1.5 + 30 * L}}};
       }},
      {"barkley",
       {0, 0},
       [](double L) {
         return Matrix{{{-0.02 / 0.75 / 0.02 + L, 0}, {1, -1}}};
       }},
      {"ginzburgLandau",
       {0, 0},
       [](double L) {
         return Matrix{{{1 + L, 0}, {0, 1 + L}}};
       }},
      {"swiftHohenberg",
       {0, 0},
       [](double L) {
         return Matrix{{{0.3 - (1 + L) * (1 + L), 0}, {0, 0}}};
       }},
      {"cahnHilliard",
       {0.2, 0},
       [](double L) {
         return Matrix{{{L * (3 * 0.2 * 0.2 - 1 - 0.5 * L), 0}, {0, 0}}};
       }},
      {"kuramotoSivashinsky",
       {0, 0},
       [](double L) {
         return Matrix{{{-L - L * L, 0}, {0, 0}}};
       }},
      {"oregonator",
       {o, o},
       [=](double L) {
         return Matrix{
             {{(1 - 2 * o - f * o * 2 * q / d) / 0.03 + L, -f * (o - q) / (o + q) / 0.03}, {1, -1}}};
       },
       1e-5},
  };
}

/// Returns the amplitudes after one step of a' = M a by the method, in double precision. `m` is the matrix
/// M.
Amplitudes stepped(const Matrix& m, const Amplitudes& a, double dt, sim::RuleMethod method) {
  const auto times = [&](const Amplitudes& b) {
    return Amplitudes{m[0][0] * b[0] + m[0][1] * b[1], m[1][0] * b[0] + m[1][1] * b[1]};
  };
  // For a linear equation, every method is a truncated Taylor series of exp(dt M).
  const int order = method == sim::RuleMethod::euler ? 1 : method == sim::RuleMethod::heun ? 2 : 4;
  Amplitudes term = a, sum = a;
  for (int i = 1; i <= order; ++i) {
    term = times(term);
    for (int c = 0; c < 2; ++c) sum[c] += term[c] = term[c] * dt / i;
  }
  return sum;
}

/// Returns twice the mean over the plane of (cell - mean) times the wave.
double amplitude(const std::vector<float>& cells, double mean, glm::ivec2 size, const glm::dvec2& k) {
  double sum = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      sum += (static_cast<double>(cells[static_cast<std::size_t>(y * size.x + x)]) - mean) *
             std::cos(k.x * (x + 0.5) + k.y * (y + 0.5));
  return 2 * sum / size.x / size.y;
}

}  // namespace

TEST_CASE("reaction: a small wave on each preset's uniform state grows at the analytic rate") {
  REQUIRE(homogeneousStates().size() == sim::reactionPresets().size());
  for (const Homogeneous& at : homogeneousStates())
    for (const glm::ivec2 waves : {glm::ivec2(2, 1), glm::ivec2(5, 3), glm::ivec2(0, 7)}) {
      CAPTURE(std::string(at.preset));
      CAPTURE(waves.x);
      auto p = equations(fmt::format("\"preset\": \"{}\"", at.preset));
      p.size = {37, 29};
      const glm::dvec2 k(2 * std::numbers::pi * waves.x / p.size.x,
                         2 * std::numbers::pi * waves.y / p.size.y);
      const double L = (8 * (std::cos(k.x) + std::cos(k.y)) + 4 * std::cos(k.x) * std::cos(k.y) - 20) /
                       (6 * p.spacing * p.spacing);
      const Matrix rates = at.rates(L);
      const Amplitudes start = {at.wave, -0.4 * at.wave};
      std::erase_if(p.parameters,
                    // The parameter "mean" is removed, because only the start uses it.
                    [](const auto& parameter) { return parameter.name == "mean"; });
      for (std::size_t i = 0; i < p.species.size(); ++i)
        p.species[i].start = fmt::format("{:.9g} + {:.9g}*cos({:.9g}*x + {:.9g}*y)", at.state[i], start[i],
                                         k.x / p.spacing, k.y / p.spacing);
      const bool two = p.species.size() == 2;
      Amplitudes want = start;
      if (!two) want[1] = 0;
      const Amplitudes begun = want;
      // The simulation runs until the wave has changed by a factor of about e.
      double fastest = 0;
      for (const auto& row : rates) fastest = std::max(fastest, std::abs(row[0]) + std::abs(row[1]));
      const int steps = std::clamp(static_cast<int>(1 / (fastest * p.dt)), 4, 400);
      for (int i = 0; i < steps; ++i) want = stepped(rates, want, p.dt, p.method);
      const sim::RuleField field = after(p, steps);
      double off = 0, way = 0;
      for (std::size_t i = 0; i < p.species.size(); ++i) {
        const double got = amplitude(field.stage[i], at.state[i], p.size, k);
        off = std::hypot(off, got - want[i]);
        way = std::hypot(way, want[i] - begun[i]);
      }
      CHECK_MESSAGE(off < 0.02 * way, (off / way));
    }
}

TEST_CASE("reaction: Euler, Heun and Runge-Kutta converge with order 1, 2 and 4 in time") {
  // The complex Ginzburg-Landau equation has the solution A = e^(-i beta t).
  for (const auto& one : {std::pair(std::string("euler"), 1), std::pair(std::string("heun"), 2),
                          std::pair(std::string("rk4"), 4)}) {
    const std::string& method = one.first;
    const int order = one.second;
    double errors[2];
    for (int half = 0; half < 2; ++half) {
      auto p =
          equations(fmt::format(R"X("preset": "ginzburgLandau", "method": "{}", "parameters": {{"beta": 3}},
                                        "species": {{"u": {{"start": "1"}}, "v": {{"start": "0"}}}})X",
                                method));
      p.size = {5, 4};
      const int steps = (half == 0 ? 8 : 16) * 16 / (order * order);
      p.dt = 1.0 / steps;
      const sim::RuleField field = after(p, steps);
      errors[half] = std::hypot(static_cast<double>(field.stage[0][7]) - std::cos(3),
                                static_cast<double>(field.stage[1][7]) + std::sin(3));
    }
    const double found = std::log2(errors[0] / errors[1]);
    CHECK_MESSAGE(std::abs(found - order) < 0.35, method, " ", found, " ", errors[0], " ", errors[1]);
  }
}

TEST_CASE("reaction: time, keys and animated rates are evaluated at the right moment") {
  // For du/dt = t^3, a method of order 4 is exact except for rounding. Euler's method with 8 steps of 1/8
  // returns the sum of (i/8)^3 / 8 for i = 0 to 7, which is 28^2 / 4096.
  auto p = equations(R"X("species": {"u": {"rate": "t^3"}}, "method": "rk4")X");
  p.size = {4, 4};
  p.dt = 0.125;
  CHECK(after(p, 8).stage[0][5] == doctest::Approx(0.25).epsilon(1e-6));
  p.method = sim::RuleMethod::euler;
  CHECK(after(p, 8).stage[0][5] == doctest::Approx(28.0 * 28 / 4096).epsilon(1e-6));
}

TEST_CASE("reaction: diffusion conserves heat, Cahn-Hilliard concentration, and heat in a varying plate") {
  const std::string varying = R"X("parameters": {"d": {"value": 0.2, "across": 1}}, "dt": 0.1,
    "species": {"u": {"start": "if(x > 9 and y < 12, 1, 0)", "rate": "diffuse(d, u)"}})X";
  for (const std::string& members :
       {std::string("\"preset\": \"heat\""), std::string("\"preset\": \"cahnHilliard\""), varying})
    for (const char* boundary : {"torus", "no-flux"}) {
      CAPTURE(members);
      CAPTURE(boundary);
      auto p = equations(members + fmt::format(", \"boundary\": \"{}\"", boundary));
      p.size = {37, 29};
      const sim::RuleField begin = after(p, 0), end = after(p, 400);
      CHECK(std::abs(meanOf(end.stage[0]) - meanOf(begin.stage[0])) < 2e-6);
      double changed = 0;
      for (std::size_t i = 0; i < end.stage[0].size(); ++i)
        changed = std::max(changed, static_cast<double>(std::abs(end.stage[0][i] - begin.stage[0][i])));
      CHECK(changed > 0.1);
    }
}

TEST_CASE("reaction: derivatives of a wave converge to the continuous operators at second order") {
  for (const char* expression :
       {"laplacian(u)", "ddx(u)", "ddy(u)", "laplacian(laplacian(u))", "diffuse(1 + 0*u, u)"}) {
    CAPTURE(std::string(expression));
    double errors[2];
    for (int fine = 0; fine < 2; ++fine) {
      const int side = fine == 0 ? 12 : 24;
      auto p = equations(fmt::format(
          R"X("species": {{"u": {{"start": "sin(2*pi*x) * cos(2*pi*y)"}}, "w": {{"rate": "{}"}}}})X",
          expression));
      p.size = {side, side};
      p.spacing = 1.0 / side;
      p.dt = 1;
      const std::vector<float> got = after(p, 1).stage[1];
      const double w = 2 * std::numbers::pi;
      double maximum = 0;
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
          const double px = w * (x + 0.5) / side, py = w * (y + 0.5) / side;
          const double wave = std::sin(px) * std::cos(py);
          const std::string what = expression;
          const double want = what == "ddx(u)"                    ? w * std::cos(px) * std::cos(py)
                              : what == "ddy(u)"                  ? -w * std::sin(px) * std::sin(py)
                              : what == "laplacian(laplacian(u))" ? 4 * w * w * w * w * wave
                                                                  : -2 * w * w * wave;
          maximum = std::max(
              maximum, std::abs(static_cast<double>(got[static_cast<std::size_t>(y * side + x)]) - want));
        }
      errors[fine] = maximum;
    }
    CHECK_MESSAGE(std::abs(std::log2(errors[0] / errors[1]) - 2) < 0.15, errors[0], " ", errors[1]);
  }
}

TEST_CASE("reaction: fixed borders hold a gradient, closed borders do not") {
  auto p = equations(
      R"X("boundary": "fixed", "dt": 0.3, "species": {"u": {"diffusion": 1, "edge": 2, "start": "0"}})X");
  p.size = {9, 7};
  const sim::RuleField field = after(p, 600);
  for (const float cell : field.stage[0]) CHECK(cell == doctest::Approx(2).epsilon(1e-3));
}
