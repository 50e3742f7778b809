#include "sim/reaction/parameters.hpp"

#include "scene/words.hpp"
#include "sim/reaction/presets.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Groups under names of which some are there already: a scene changes those that it names and adds others.
template <class Item, class Describe>
void completed(scene::Fields& f, const char* name, const char* doc, const char* one, std::size_t max,
               std::vector<Item>& items, Describe describe) {
  const std::vector<Item> before = items;
  std::vector<std::size_t> order;
  std::vector<std::string> names;
  for (const Item& item : items) {
    order.push_back(order.size());
    names.push_back(item.name);
  }
  f.namedGroups(
      name, doc, one, max, names,
      [&](const std::vector<std::string>& wanted) {
        items = before;
        order.clear();
        for (const std::string& next : wanted) {
          const auto found =
              std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.name == next; });
          order.push_back(static_cast<std::size_t>(found - items.begin()));
          if (found == items.end()) items.emplace_back().name = next;
        }
      },
      [&](scene::Fields& inner, std::size_t i) { describe(inner, items[order[i]]); });
}

}  // namespace

ReactionParameters::ReactionParameters() {
  display.map = "viridis";
}

void ReactionParameters::describe(scene::Fields& f) {
  f.pair("size", size, {4, 32768}, "cells", "Width and height.");
  std::vector<const char*> names;
  for (const ReactionPreset& known : reactionPresets()) names.push_back(known.name);
  f.oneOf("preset", preset, names,
          "Equations by name, below; what else is given changes or completes them.");
  if (f.given("preset") && preset >= 0) reactionPresets()[static_cast<std::size_t>(preset)].apply(*this);
  const auto presets = [&](const char* name, const char* other) {
    f.leftOut(name, fmt::format("the preset's, or {}", other).c_str());
  };
  f.number("spacing", spacing, {1e-6, 1e6}, "units of length", "Of cells.");
  presets("spacing", "1");
  f.number("dt", dt, {1e-9, 1e6}, "units of time", "Of a step.");
  presets("dt", "0.1");
  f.choice("method", method, {"euler", "heun", "rk4"},
           "How a step goes: of order 1, 2 or 4 in time, with as many evaluations of the rates.");
  presets("method", "euler");
  f.integer("steps", steps, {0, 100000}, "per frame", "Steps a frame takes.");
  presets("steps", "8");
  f.integer("presteps", presteps, {0, 1e7}, "",
            "Steps before the first frame, with the parameters of time 0.");
  f.choice(
      "boundary", boundary, {"torus", "no-flux", "fixed"},
      "Left meets right and top bottom; nothing crosses the edges; or each species has a value beyond.");
  f.shorthand("parameters", "value");
  completed(f, "parameters", "Numbers that expressions name.", "parameter", 64, parameters,
            [](scene::Fields& p, ReactionParameter& parameter) {
              p.number("value", parameter.value, scene::anyNumber, "", "Its value.");
              p.optionalNumber("across", parameter.across, scene::anyNumber, "",
                               "Value at the right edge; it changes evenly from \"value\" at the left.");
              p.optionalNumber("down", parameter.down, scene::anyNumber, "",
                               "Value at the bottom; it changes evenly from \"value\" at the top.");
              p.asset("image", parameter.image,
                      "Picture that sets it: \"value\" where it is black, \"white\" where white.");
              p.number("white", parameter.white, scene::anyNumber, "", "Value where \"image\" is white.");
              if (parameter.across.has_value() + parameter.down.has_value() + !parameter.image.empty() > 1)
                p.error(parameter.image.empty() ? "down" : "image",
                        "\"across\", \"down\" and \"image\" exclude each other");
            });
  f.shorthand("lets", "is");
  completed(f, "lets", "Names for expressions, which others may use; a stencil may be laid over them.",
            "let", 32, lets,
            [](scene::Fields& l, ReactionLet& let) { l.text("is", let.is, "An expression."); });
  completed(
      f, "species", "What there is in each cell.", "species", maxSpecies, species,
      [](scene::Fields& s, ReactionSpecies& one) {
        s.number("diffusion", one.diffusion, {0, 1e6}, "lengths^2 per unit of time",
                 "D of the term D laplacian(u) in its rate.");
        s.text("rate", one.rate, "The rest of its rate of change: an expression.");
        s.text("start", one.start, "In the first state: an expression of x, y, random(k) and parameters.");
        s.number("edge", one.edge, scene::anyNumber, "", "Beyond the edges of \"boundary\": \"fixed\".");
      });
  f.text("show", show, "What is drawn: a species, or any expression.");
  f.leftOut("show", "the preset's, or the first species");
  f.list("strokes", strokes, "Timed strokes of a brush.", [](scene::Fields& s, ReactionStroke& stroke) {
    stroke.describe(s, 1e9, "What is painted.");
    s.text("species", stroke.species, "Which species is painted.");
    s.leftOut("species", "the first");
  });
  f.group("display", "How what is shown is laid over the picture.",
          [&](scene::Fields& d) { display.describe(d); });

  if (species.empty()) {
    f.error("species", "there are no equations: give a \"preset\" or \"species\"");
    return;
  }
  if (species.size() > maxSpecies)
    f.error("species", fmt::format("at most {} species, with those of the preset; found {}", maxSpecies,
                                   species.size()));
  std::vector<std::string> known;
  for (const ReactionSpecies& one : species) known.push_back(one.name);
  for (const ReactionStroke& stroke : strokes)
    if (painted(stroke) < 0)
      f.error("strokes",
              fmt::format("a stroke paints the species {}, which is not there; {}",
                          scene::inQuotes(stroke.species), scene::suggestion(stroke.species, known)));
  try {
    static_cast<void>(understandRule(ruleText()));
  } catch (const RuleMistake& mistake) {
    f.errorIn(mistake.path, mistake.begin, mistake.end, mistake.message);
  }
}

RuleText ReactionParameters::ruleText() const {
  RuleText text;
  for (const ReactionSpecies& one : species)
    text.species.push_back(
        {one.name, one.rate, one.start, one.diffusion.moves() || one.diffusion.at(0) != 0});
  for (const ReactionParameter& parameter : parameters)
    text.parameters.push_back({parameter.name, parameter.isMapped(), parameter.isPresets});
  for (const ReactionLet& let : lets) text.lets.push_back({let.name, let.is});
  text.show = show;
  return text;
}

int ReactionParameters::painted(const ReactionStroke& stroke) const {
  if (stroke.species.empty()) return 0;
  for (std::size_t i = 0; i < species.size(); ++i)
    if (species[i].name == stroke.species) return static_cast<int>(i);
  return -1;
}

std::span<const scene::Quantity> ReactionParameters::quantities() const {
  static const scene::Quantity table[] = {{"meanValue", "", "Of what is shown."},
                                          {"leastValue", "", "Of what is shown."},
                                          {"mostValue", "", "Of what is shown."},
                                          {"deviation", "", "Root of the variance of what is shown."},
                                          {"wavelength", "cells", "Of most of that variance."}};
  return table;
}

}  // namespace simreel::sim
