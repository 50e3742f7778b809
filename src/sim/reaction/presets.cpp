#include "sim/reaction/presets.hpp"

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Initial state in which one excited quarter is next to a resting region. The ends of its fronts curl up
/// into spirals.
constexpr const char* crossedU = "if(x > 0.5*width, if(y < 0.5*height, 1, 0), 0)";

}  // namespace

std::span<const ReactionPreset> reactionPresets() {
  using enum RuleMethod;
  static const std::vector<ReactionPreset> presets = {
      {.name = "heat",
       .source = "Fourier, Theorie analytique de la chaleur, 1822",
       .species = {{.name = "u",
                    .diffusion = 1,
                    .rate = "0",
                    .start = "if((x - width/2)^2 + (y - height/2)^2 < (height/5)^2, 1, 0)"}},
       .dt = 0.2,
       .steps = 8,
       .map = "inferno",
       .low = 0,
       .high = 1},
      {.name = "wave",
       .source = "d'Alembert 1747, with a loss",
       .species = {{.name = "u",
                    .diffusion = 0,
                    .rate = "v",
                    .start = "exp(-((x - 0.4*width)^2 + (y - 0.45*height)^2) / 20)"},
                   {.name = "v", .diffusion = 0, .rate = "c^2 * laplacian(u) - loss*v", .start = "0"}},
       .parameters = {{"c", 1}, {"loss", 0.001F}},
       .dt = 0.5,
       .steps = 4,
       .method = rk4,
       .map = "polar",
       .low = -0.2,
       .high = 0.2},
      {.name = "fitzHughNagumo",
       .source = "FitzHugh 1961; Nagumo et al. 1962; as Hagberg and Meron, Chaos 4, 1994",
       .species = {{.name = "u",
                    .diffusion = 1,
                    .rate = "u - u^3 - v",
                    .start = "if(abs(y - height/2 + 8*sin(6*pi*x/width)) < 5, 1, -0.6)"},
                   {.name = "v", .diffusion = 4, .rate = "epsilon*(u - a1*v - a0)", .start = "-0.3"}},
       .parameters = {{"epsilon", 0.05F}, {"a1", 2}, {"a0", -0.1F}},
       .spacing = 0.8,
       .dt = 0.03,
       .steps = 60,
       .map = "viridis",
       .low = -0.8,
       .high = 0.8},
      {.name = "brusselator",
       .source = "Prigogine and Lefever, J. Chem. Phys. 48, 1968",
       .species =
           {{.name = "u", .diffusion = 2, .rate = "a - (b + 1)*u + u^2*v", .start = "a + 0.1*random(1)"},
            {.name = "v", .diffusion = 16, .rate = "b*u - u^2*v", .start = "b/a + 0.1*random(2)"}},
       .parameters = {{"a", 4.5F}, {"b", 7.5F}},
       .dt = 0.01,
       .steps = 32,
       .map = "plasma",
       .low = 2,
       .high = 8},
      {.name = "schnakenberg",
       .source = "Schnakenberg, J. Theor. Biol. 81, 1979",
       .species =
           {{.name = "u", .diffusion = 1, .rate = "a - u + u^2*v", .start = "a + b + 0.02*random(1)"},
            {.name = "v", .diffusion = 40, .rate = "b - u^2*v", .start = "b/(a + b)^2"}},
       .parameters = {{"a", 0.1F}, {"b", 0.9F}},
       .dt = 0.008,
       .steps = 64,
       .map = "magma",
       .low = 0,
       .high = 3},
      {.name = "giererMeinhardt",
       .source = "Gierer and Meinhardt, Kybernetik 12, 1972",
       .species = {{.name = "u",
                    .diffusion = 1,
                    .rate = "u^2/v - mu*u + s",
                    .start = "(nu + s)/mu + 0.02*random(1)"},
                   {.name = "v", .diffusion = 30, .rate = "u^2 - nu*v", .start = "((nu + s)/mu)^2/nu"}},
       .parameters = {{"mu", 1}, {"nu", 1.5F}, {"s", 0.02F}},
       .dt = 0.01,
       .steps = 64,
       .map = "inferno",
       .low = 0,
       .high = 5},
      {.name = "barkley",
       .source = "Barkley, Physica D 49, 1991",
       .species =
           {{.name = "u", .diffusion = 1, .rate = "u*(1 - u)*(u - (v + b)/a)/epsilon", .start = crossedU},
            {.name = "v", .diffusion = 0, .rate = "u - v", .start = "if(y > 0.5*height, 0.4, 0)"}},
       .parameters = {{"a", 0.75F}, {"b", 0.02F}, {"epsilon", 0.02F}},
       .spacing = 0.4,
       .dt = 0.01,
       .steps = 20,
       .map = "inferno",
       .low = 0,
       .high = 1.2},
      {.name = "ginzburgLandau",
       .source = "complex; Aranson and Kramer, Rev. Mod. Phys. 74, 2002",
       .species = {{.name = "u",
                    .diffusion = 1,
                    .rate = "u - alpha*laplacian(v) - square*(u - beta*v)",
                    .start = "0.1*random(1)"},
                   {.name = "v",
                    .diffusion = 1,
                    .rate = "v + alpha*laplacian(u) - square*(v + beta*u)",
                    .start = "0.1*random(2)"}},
       .parameters = {{"alpha", 0}, {"beta", 0.7F}},
       .lets = {{"square", "u^2 + v^2"}},
       .dt = 0.05,
       .steps = 20,
       .map = "polar",
       .low = -1.1,
       .high = 1.1},
      {.name = "swiftHohenberg",
       .source = "Swift and Hohenberg, Phys. Rev. A 15, 1977",
       .species = {{.name = "u",
                    .diffusion = 0,
                    .rate = "r*u - w - laplacian(w) + g*u^2 - u^3",
                    .start = "0.1*random(1)"}},
       .parameters = {{"r", 0.3F}, {"g", 0}},
       .lets = {{"w", "u + laplacian(u)"}},
       .dt = 0.08,
       .steps = 24,
       .map = "viridis",
       .low = -0.7,
       .high = 0.7},
      {.name = "cahnHilliard",
       .source = "Cahn and Hilliard, J. Chem. Phys. 28, 1958; mobility 1",
       .species = {{.name = "c", .diffusion = 0, .rate = "laplacian(mu)", .start = "mean + 0.1*random(1)"}},
       .parameters = {{"gamma", 0.5F}, {"mean", 0}},
       .lets = {{"mu", "c^3 - c - gamma*laplacian(c)"}},
       .dt = 0.05,
       .steps = 40,
       .map = "polar",
       .low = -1.1,
       .high = 1.1},
      {.name = "kuramotoSivashinsky",
       .source = "Kuramoto 1978; Sivashinsky 1977",
       .species = {{.name = "u",
                    .diffusion = 0,
                    .rate = "-w - laplacian(w) - 0.5*(ddx(u)^2 + ddy(u)^2)",
                    .start = "0.1*random(1)"}},
       .lets = {{"w", "laplacian(u)"}},
       .dt = 0.05,
       .steps = 20,
       .show = "laplacian(u)",
       .map = "magma",
       .low = -1.2,
       .high = 2.5},
      {.name = "oregonator",
       .source = "Field and Noyes 1974; as Tyson and Fife, J. Chem. Phys. 73, 1980",
       .species =
           {{.name = "u",
             .diffusion = 1,
             .rate = "(u*(1 - u) - f*v*(u - q)/(u + q))/epsilon",
             .start =
                 "if(x > 0.3*width and x < 0.34*width and y > 0.25*height and y < 0.75*height, 0.8, q)"},
            {.name = "v",
             .diffusion = 0,
             .rate = "u - v",
             .start = "if(x > 0.1*width and x < 0.3*width and y > 0.2*height and y < 0.75*height, 0.15, "
                      "0.004)"}},
       .parameters = {{"epsilon", 0.03F}, {"f", 3}, {"q", 0.002F}},
       .spacing = 0.25,
       .dt = 0.0005,
       .steps = 120,
       .show = "v",
       .map = "inferno",
       .low = 0,
       .high = 0.2}};
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
  std::string out = "Presets (\"preset\"); values that a scene gives beside a preset override it:\n";
  for (const ReactionPreset& preset : reactionPresets()) {
    ReactionParameters p;
    preset.apply(p);
    out += fmt::format("\n  {}: {}\n", preset.name, preset.source);
    const std::string text = compileRule(p.ruleText()).text;
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
  out += fmt::format("  {:<10}  0 for bases below 1e-30, except for whole exponents up to {}\n", "^",
                     greatestWholePower);
  for (const scene::ExpressionFunction& function : scene::expressionFunctions())
    out += fmt::format("  {:<10}  {}\n", function.name,
                       *function.doc == '\0' ? std::string() : std::string(function.doc));
  return out;
}

}  // namespace simreel::sim
