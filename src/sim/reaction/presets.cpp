#include "sim/reaction/presets.hpp"

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Excited in a quarter, beside what still rests: fronts whose ends curl up.
constexpr const char* crossedU = "if(x > 0.5*width, if(y < 0.5*height, 1, 0), 0)";

}  // namespace

std::span<const ReactionPreset> reactionPresets() {
  using enum RuleMethod;
  static const std::vector<ReactionPreset> presets = {
      {"heat",
       "Fourier, Theorie analytique de la chaleur, 1822",
       {{"u", 1, "0", "if((x - width/2)^2 + (y - height/2)^2 < (height/5)^2, 1, 0)"}},
       {},
       {},
       1,
       0.2,
       8,
       euler,
       "",
       "inferno",
       0,
       1},
      {"wave",
       "d'Alembert 1747, with a loss",
       {{"u", 0, "v", "exp(-((x - 0.4*width)^2 + (y - 0.45*height)^2) / 20)"},
        {"v", 0, "c^2 * laplacian(u) - loss*v", "0"}},
       {{"c", 1}, {"loss", 0.001F}},
       {},
       1,
       0.5,
       4,
       rk4,
       "",
       "polar",
       -0.2,
       0.2},
      {"fitzHughNagumo",
       "FitzHugh 1961; Nagumo et al. 1962; as Hagberg and Meron, Chaos 4, 1994",
       {{"u", 1, "u - u^3 - v", "if(abs(y - height/2 + 8*sin(6*pi*x/width)) < 5, 1, -0.6)"},
        {"v", 4, "epsilon*(u - a1*v - a0)", "-0.3"}},
       {{"epsilon", 0.05F}, {"a1", 2}, {"a0", -0.1F}},
       {},
       0.8,
       0.03,
       60,
       euler,
       "",
       "viridis",
       -0.8,
       0.8},
      {"brusselator",
       "Prigogine and Lefever, J. Chem. Phys. 48, 1968",
       {{"u", 2, "a - (b + 1)*u + u^2*v", "a + 0.1*random(1)"},
        {"v", 16, "b*u - u^2*v", "b/a + 0.1*random(2)"}},
       {{"a", 4.5F}, {"b", 7.5F}},
       {},
       1,
       0.01,
       32,
       euler,
       "",
       "plasma",
       2,
       8},
      {"schnakenberg",
       "Schnakenberg, J. Theor. Biol. 81, 1979",
       {{"u", 1, "a - u + u^2*v", "a + b + 0.02*random(1)"}, {"v", 40, "b - u^2*v", "b/(a + b)^2"}},
       {{"a", 0.1F}, {"b", 0.9F}},
       {},
       1,
       0.008,
       64,
       euler,
       "",
       "magma",
       0,
       3},
      {"giererMeinhardt",
       "Gierer and Meinhardt, Kybernetik 12, 1972",
       {{"u", 1, "u^2/v - mu*u + s", "(nu + s)/mu + 0.02*random(1)"},
        {"v", 30, "u^2 - nu*v", "((nu + s)/mu)^2/nu"}},
       {{"mu", 1}, {"nu", 1.5F}, {"s", 0.02F}},
       {},
       1,
       0.01,
       64,
       euler,
       "",
       "inferno",
       0,
       5},
      {"barkley",
       "Barkley, Physica D 49, 1991",
       {{"u", 1, "u*(1 - u)*(u - (v + b)/a)/epsilon", crossedU},
        {"v", 0, "u - v", "if(y > 0.5*height, 0.4, 0)"}},
       {{"a", 0.75F}, {"b", 0.02F}, {"epsilon", 0.02F}},
       {},
       0.4,
       0.01,
       20,
       euler,
       "",
       "inferno",
       0,
       1.2},
      {"ginzburgLandau",
       "complex; Aranson and Kramer, Rev. Mod. Phys. 74, 2002",
       {{"u", 1, "u - alpha*laplacian(v) - square*(u - beta*v)", "0.1*random(1)"},
        {"v", 1, "v + alpha*laplacian(u) - square*(v + beta*u)", "0.1*random(2)"}},
       {{"alpha", 0}, {"beta", 0.7F}},
       {{"square", "u^2 + v^2"}},
       1,
       0.05,
       20,
       euler,
       "",
       "polar",
       -1.1,
       1.1},
      {"swiftHohenberg",
       "Swift and Hohenberg, Phys. Rev. A 15, 1977",
       {{"u", 0, "r*u - w - laplacian(w) + g*u^2 - u^3", "0.1*random(1)"}},
       {{"r", 0.3F}, {"g", 0}},
       {{"w", "u + laplacian(u)"}},
       1,
       0.08,
       24,
       euler,
       "",
       "viridis",
       -0.7,
       0.7},
      {"cahnHilliard",
       "Cahn and Hilliard, J. Chem. Phys. 28, 1958; mobility 1",
       {{"c", 0, "laplacian(mu)", "mean + 0.1*random(1)"}},
       {{"gamma", 0.5F}, {"mean", 0}},
       {{"mu", "c^3 - c - gamma*laplacian(c)"}},
       1,
       0.05,
       40,
       euler,
       "",
       "polar",
       -1.1,
       1.1},
      {"kuramotoSivashinsky",
       "Kuramoto 1978; Sivashinsky 1977",
       {{"u", 0, "-w - laplacian(w) - 0.5*(ddx(u)^2 + ddy(u)^2)", "0.1*random(1)"}},
       {},
       {{"w", "laplacian(u)"}},
       1,
       0.05,
       20,
       euler,
       "laplacian(u)",
       "magma",
       -1.2,
       2.5},
      {"oregonator",
       "Field and Noyes 1974; as Tyson and Fife, J. Chem. Phys. 73, 1980",
       {{"u", 1, "(u*(1 - u) - f*v*(u - q)/(u + q))/epsilon",
         "if(x > 0.3*width and x < 0.34*width and y > 0.25*height and y < 0.75*height, 0.8, q)"},
        {"v", 0, "u - v",
         "if(x > 0.1*width and x < 0.3*width and y > 0.2*height and y < 0.75*height, 0.15, 0.004)"}},
       {{"epsilon", 0.03F}, {"f", 3}, {"q", 0.002F}},
       {},
       0.25,
       0.0005,
       120,
       euler,
       "v",
       "inferno",
       0,
       0.2},
  };
  return presets;
}

void ReactionPreset::apply(ReactionParameters& p) const {
  p.species.clear();
  for (const Species& s : species) p.species.push_back({s.name, s.diffusion, s.rate, s.start, {}, 0});
  p.parameters.clear();
  for (const auto& [parameter, value] : parameters) {
    ReactionParameter& added = p.parameters.emplace_back();
    added.name = parameter;
    added.value = value;
    added.isPresets = true;
  }
  p.lets.clear();
  for (const auto& [let, is] : lets) p.lets.push_back({let, is});
  p.spacing = spacing;
  p.dt = dt;
  p.steps = steps;
  p.method = method;
  p.show = show;
  p.display.map = map;
  p.display.low = low;
  p.display.high = high;
}

std::string reactionPresetsText() {
  std::string out = "Presets (\"preset\"); what a scene gives beside one goes before it:\n";
  for (const ReactionPreset& preset : reactionPresets()) {
    ReactionParameters p;
    preset.apply(p);
    out += fmt::format("\n  {}: {}\n", preset.name, preset.source);
    const std::string text = understandRule(p.ruleText()).text;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = text.find('\n', at);
      out += "    " + text.substr(at, end - at) + "\n";
      at = end + 1;
    }
    std::string values;
    for (const ReactionSpecies& s : p.species)
      if (s.diffusion.at(0) != 0) values += fmt::format("diffusion_{} {}, ", s.name, s.diffusion.at(0));
    for (const ReactionParameter& parameter : p.parameters)
      values += fmt::format("{} {}, ", parameter.name, parameter.value.at(0));
    constexpr const char* methods[] = {"euler", "heun", "rk4"};
    out += fmt::format("    {}spacing {}, dt {}, steps {}, {}\n", values, p.spacing, p.dt, p.steps,
                       methods[static_cast<std::size_t>(p.method)]);
  }
  out +=
      "\nExpressions: + - * / ^, < <= > >= == !=, and, or, not, numbers, species, parameters, lets, x, y, "
      "t, pi, "
      "width, height and\n";
  out += fmt::format("  {:<10}  of what is below 1e-30: 0, but for whole exponents up to {}\n", "^",
                     greatestWholePower);
  for (const scene::ExpressionFunction& function : scene::expressionFunctions())
    out += fmt::format("  {:<10}  {}\n", function.name,
                       *function.doc == '\0' ? std::string() : std::string(function.doc));
  return out;
}

}  // namespace simreel::sim
