// Tests equations in volumes by comparison with theory. Small waves must grow by the symbol of the 19-point
// stencil, diffusion must conserve the sum, derivatives must equal the continuous operators, and identical
// layers must behave like a plane.
#include "base/error.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/reaction/plan.hpp"
#include "sim/world/list.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/vec3.hpp>

using namespace simreel;

namespace {

sim::ReactionParameters volumeRule(const std::string& members) {
  const std::string text = "{\"version\": 1, \"objects\": {\"r\": {\"reaction\": {" + members + "}}}}";
  const auto scene = scene::parseScene(text, "s.json", {}, sim::kinds());
  return dynamic_cast<const sim::ReactionParameters&>(*scene.objects.at(0).parameters);
}

sim::RuleField volumeAfter(const sim::ReactionParameters& parameters, int steps) {
  const sim::ReactionPlan plan(parameters, "r", 1, 1.0);
  sim::RuleField field = plan.firstField();
  for (int i = 0; i < steps; ++i) sim::evaluateStep(plan, plan.valuesAt(0), i, 0, field);
  return field;
}

std::string volumeRefusal(const std::string& members) {
  try {
    static_cast<void>(volumeRule(members));
    return "none";
  } catch (const UserError& error) {
    return error.what();
  }
}

double volumeMean(const std::vector<float>& cells) {
  return std::accumulate(cells.begin(), cells.end(), 0.0) / static_cast<double>(cells.size());
}

}  // namespace

TEST_CASE("reaction in a volume: a small wave grows by the symbol of the 19-point stencil") {
  struct State {
    const char* preset;
    double u;
    std::function<double(double L)> rate;  ///< growth rate of a wave of one species, as a function of the
                                           ///< Laplacian's factor L
  };
  for (const State& at :
       {State{"heat", 0.4, [](double L) { return L; }},
        State{"swiftHohenberg", 0, [](double L) { return 0.3 - (1 + L) * (1 + L); }},
        State{"cahnHilliard", 0.2, [](double L) { return L * (3 * 0.2 * 0.2 - 1 - 0.5 * L); }}})
    for (const glm::ivec3 waves : {glm::ivec3(2, 1, 1), glm::ivec3(3, 2, 1), glm::ivec3(0, 1, 3)}) {
      CAPTURE(std::string(at.preset));
      CAPTURE(waves.x);
      auto p = volumeRule(fmt::format("\"preset\": \"{}\", \"depth\": 11", at.preset));
      p.size = {17, 13};
      const glm::dvec3 k = 2 * std::numbers::pi * glm::dvec3(waves) / glm::dvec3(17, 13, 11);
      const glm::dvec3 c(std::cos(k.x), std::cos(k.y), std::cos(k.z));
      const double L = (4 * (c.x + c.y + c.z) + 4 * (c.x * c.y + c.y * c.z + c.z * c.x) - 24) /
                       (6 * p.spacing * p.spacing);
      const double rate = at.rate(L), height = 1e-3;
      std::erase_if(p.parameters, [](const auto& parameter) { return parameter.name == "mean"; });
      p.species[0].start = fmt::format("{:.9g} + {:.9g}*cos({:.9g}*x + {:.9g}*y + {:.9g}*z)", at.u, height,
                                       k.x / p.spacing, k.y / p.spacing, k.z / p.spacing);
      const int steps = std::clamp(static_cast<int>(1 / (std::abs(rate) * p.dt)), 4, 200);
      const sim::RuleField field = volumeAfter(p, steps);
      double sum = 0;
      for (int z = 0; z < 11; ++z)
        for (int y = 0; y < 13; ++y)
          for (int x = 0; x < 17; ++x)
            sum += (static_cast<double>(field.stage[0][static_cast<std::size_t>((z * 13 + y) * 17 + x)]) -
                    at.u) *
                   std::cos(k.x * (x + 0.5) + k.y * (y + 0.5) + k.z * (z + 0.5));
      const double got = 2 * sum / (17 * 13 * 11), want = height * std::pow(1 + rate * p.dt, steps);
      CHECK_MESSAGE(std::abs(got - want) < 0.02 * std::abs(want - height), (got / want));
    }
}

TEST_CASE("reaction in a volume: diffusion conserves the sum") {
  const std::string varying = R"X("parameters": {"d": {"value": 0.2, "across": 1}}, "dt": 0.1,
    "species": {"u": {"start": "if(x > 4 and y < 9 and z > 2, 1, 0)", "rate": "diffuse(d + 0.02*z, u)"}})X";
  for (const std::string& members :
       {std::string("\"preset\": \"heat\""), std::string("\"preset\": \"cahnHilliard\""), varying})
    for (const char* boundary : {"torus", "no-flux"}) {
      CAPTURE(members);
      CAPTURE(boundary);
      auto p = volumeRule(members + fmt::format(", \"depth\": 7, \"boundary\": \"{}\"", boundary));
      p.size = {15, 13};
      const sim::RuleField begin = volumeAfter(p, 0), end = volumeAfter(p, 150);
      CHECK(std::abs(volumeMean(end.stage[0]) - volumeMean(begin.stage[0])) < 2e-6);
      double changed = 0;
      for (std::size_t i = 0; i < end.stage[0].size(); ++i)
        changed = std::max(changed, static_cast<double>(std::abs(end.stage[0][i] - begin.stage[0][i])));
      CHECK(changed > 0.1);
    }
}

TEST_CASE("reaction in a volume: derivatives converge to the continuous operators at second order") {
  for (const char* expression : {"laplacian(u)", "ddx(u)", "ddy(u)", "ddz(u)", "diffuse(1 + 0*u, u)"}) {
    CAPTURE(std::string(expression));
    double errors[2];
    for (int fine = 0; fine < 2; ++fine) {
      const int side = fine == 0 ? 10 : 20;
      auto p = volumeRule(fmt::format(
          R"X("depth": {}, "species": {{"u": {{"start": "sin(2*pi*x)*cos(2*pi*y)*sin(2*pi*z)"}}, "w": {{"rate": "{}"}}}})X",
          side, expression));
      p.size = {side, side};
      p.spacing = 1.0 / side;
      p.dt = 1;
      const std::vector<float> got = volumeAfter(p, 1).stage[1];
      const double w = 2 * std::numbers::pi;
      double maximum = 0;
      for (std::size_t i = 0; i < got.size(); ++i) {
        const auto at = [&](std::size_t cell) { return w * (static_cast<double>(cell) + 0.5) / side; };
        const auto n = static_cast<std::size_t>(side);
        const double x = at(i % n), y = at(i / n % n), z = at(i / n / n);
        const std::string what = expression;
        const double want = what == "ddx(u)"   ? w * std::cos(x) * std::cos(y) * std::sin(z)
                            : what == "ddy(u)" ? -w * std::sin(x) * std::sin(y) * std::sin(z)
                            : what == "ddz(u)" ? w * std::sin(x) * std::cos(y) * std::cos(z)
                                               : -3 * w * w * std::sin(x) * std::cos(y) * std::sin(z);
        maximum = std::max(maximum, std::abs(static_cast<double>(got[i]) - want));
      }
      errors[fine] = maximum;
    }
    CHECK_MESSAGE(std::abs(std::log2(errors[0] / errors[1]) - 2) < 0.2, errors[0], " ", errors[1]);
  }
}

TEST_CASE("reaction in a volume: equal layers stay equal and step like a plane") {
  const std::string equations = R"X("dt": 0.1, "species": {
    "u": {"diffusion": 0.7, "start": "0.5 + 0.3*sin(x)*cos(0.7*y)", "rate": "u - u^3 - 0.2*v"},
    "v": {"diffusion": 0.2, "start": "0.2*cos(x + y)", "rate": "0.1*laplacian(u) + 0.1*ddx(v) - 0.1*v"}})X";
  for (const char* boundary : {"torus", "no-flux"}) {
    auto flat = volumeRule(equations + fmt::format(", \"boundary\": \"{}\"", boundary));
    flat.size = {19, 14};
    auto deep = flat;
    deep.depth = 5;
    const auto plane = volumeAfter(flat, 60).stage, layers = volumeAfter(deep, 60).stage;
    double off = 0;
    for (std::size_t s = 0; s < 2; ++s)
      for (std::size_t i = 0; i < layers[s].size(); ++i)
        off = std::max(off, static_cast<double>(std::abs(layers[s][i] - plane[s][i % plane[s].size()])));
    CHECK_MESSAGE(off < 2e-5, (off));
  }
}

TEST_CASE("reaction in a volume: errors are reported in one line") {
  const std::string heat = "\"preset\": \"heat\", ";
  const auto says = [](const std::string& refused, const char* what) {
    const bool right = refused.find(what) != std::string::npos;
    if (!right) MESSAGE(refused);
    return right;
  };
  CHECK(says(volumeRefusal(heat + R"X("size": [2048, 2048], "depth": 512)X"),
             "2048x2048x512 are 2147483648 cells; a volume has at most 268435456"));
  CHECK(says(volumeRefusal(heat + R"X("surface": {"level": 0.5})X"), "a flat grid has no surface"));
  CHECK(says(volumeRefusal(heat + R"X("depth": 8, "surface": {"color": "w"})X"), "unknown name \"w\""));
  CHECK(says(volumeRefusal(R"X("species": {"u": {"rate": "ddz(u)"}})X"), "a flat grid has no z"));
  CHECK(says(volumeRefusal(R"X("species": {"u": {"rate": "z"}})X"), "unknown name \"z\""));
  CHECK(says(volumeRefusal(R"X("depth": 8, "species": {"z": {}})X"),
             "is reserved in expressions of volumes"));
  CHECK(volumeRefusal(R"X("species": {"z": {"rate": "1 - z"}, "depth": {}})X") == "none");
}
