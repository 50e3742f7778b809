#include "sim/reaction/parameters.hpp"

#include "scene/json/words.hpp"
#include "sim/reaction/presets.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Reads named groups into a list that already has groups: the scene changes the groups that it names and
/// adds new ones.
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

/// Since version 2, a scene that gives no equations and nothing that a preset would replace has the preset
/// "brusselator".
void ReactionParameters::useStandardPreset(scene::Fields& f) {
  if (f.version() == 1 || !species.empty()) return;
  for (const char* key : {"spacing", "dt", "method", "steps", "boundary", "parameters", "lets", "show"})
    if (f.given(key)) return;
  const std::span<const ReactionPreset> all = reactionPresets();
  const auto found = std::find_if(all.begin(), all.end(), [](const ReactionPreset& one) {
    return std::string_view(one.name) == "brusselator";
  });
  preset = static_cast<int>(found - all.begin());
  found->apply(*this);
}

void ReactionParameters::describe(scene::Fields& f) {
  f.pair("size", size, {4, 32768}, "cells", "Width and height.");
  f.leftOut("size", "[256,256]; in version 2 a plane has as many cells with the picture's aspect ratio");
  display.sized = f.given("size");
  f.integer("depth", depth, {1, 32768}, "cells",
            "Layers of a volume, whose y grows upwards; 1: a flat grid, whose y grows downwards.");
  std::vector<const char*> names;
  for (const ReactionPreset& known : reactionPresets()) names.push_back(known.name);
  f.oneOf("preset", preset, names,
          "Equations by name, listed below; other parameters change or complete them.");
  if (f.given("preset") && preset >= 0) reactionPresets()[static_cast<std::size_t>(preset)].apply(*this);
  const auto presets = [&](const char* name, const char* other) {
    f.leftOut(name, fmt::format("the preset's, or {}", other).c_str());
  };
  f.number("spacing", spacing, {1e-6, 1e6}, "units of length", "Distance between cells.");
  presets("spacing", "1; on a mesh so large that steps are as stable as on a grid");
  hasSpacing = f.given("spacing");
  f.number("dt", dt, {1e-9, 1e6}, "units of time", "Length of a step.");
  presets("dt", "0.1");
  f.choice("method", method, {"euler", "heun", "rk4"},
           "Method of a step: of order 1, 2 or 4 in time, with as many evaluations of the rates.");
  presets("method", "euler");
  f.integer("steps", steps, {0, 100000}, "per frame", "Steps a frame takes.");
  presets("steps", "8");
  f.integer("presteps", presteps, {0, 1e7}, "",
            "Steps before the first frame, with the parameters of time 0.");
  f.choice("boundary", boundary, {"torus", "no-flux", "fixed"},
           "Left meets right, top bottom and the last layer the first; nothing crosses the edges; or each "
           "species has a value beyond.");
  f.shorthand("parameters", "value");
  completed(
      f, "parameters", "Numbers that expressions name.", "parameter", 64, parameters,
      [](scene::Fields& p, ReactionParameter& parameter) {
        p.number("value", parameter.value, scene::anyNumber, "", "Its value.");
        p.optionalNumber("across", parameter.across, scene::anyNumber, "",
                         "Value at the right edge; it changes evenly from \"value\" at the left.");
        p.optionalNumber("down", parameter.down, scene::anyNumber, "",
                         "Value at the bottom; it changes evenly from \"value\" at the top.");
        p.asset("image", parameter.image,
                "Picture that sets it: \"value\" where it is black, \"white\" where white.");
        p.number("white", parameter.white, scene::anyNumber, "", "Value where \"image\" is white.");
        p.text("field", parameter.field,
               "Name of another object's field that supplies the values, NAME or NAME.u, as it is when the "
               "frame begins. Both grids cover the same area; values are bilinear between cells. On a mesh "
               "it lies as \"maps\" says, or it is a field of the same mesh, cell by cell. In a volume it "
               "is the same in all layers, or the field of a volume of the same proportions, trilinear.");
        p.leftOut("field", "none");
        for (const char* other : {"value", "across", "down", "image", "white"})
          if (!parameter.field.empty() && p.given(other))
            p.error(other,
                    fmt::format("the parameter has the values of a \"field\"; leave out \"{}\"", other));
        if (parameter.across.has_value() + parameter.down.has_value() + !parameter.image.empty() > 1)
          p.error(parameter.image.empty() ? "down" : "image",
                  "\"across\", \"down\" and \"image\" exclude each other");
        p.idleUnless(!parameter.image.empty() || !parameter.field.empty(), "image", {"white"},
                     "a parameter with an \"image\"");
      });
  f.shorthand("lets", "is");
  completed(f, "lets", "Names for expressions, which others may use; a stencil may be laid over them.",
            "let", 32, lets,
            [](scene::Fields& l, ReactionLet& let) { l.text("is", let.is, "An expression."); });
  completed(f, "species", "Quantities that have a value in every cell.", "species", maxSpecies, species,
            [](scene::Fields& s, ReactionSpecies& one) {
              s.number("diffusion", one.diffusion, {0, 1e6}, "lengths^2 per unit of time",
                       "D of the term D laplacian(u) in its rate.");
              s.text("rate", one.rate, "The rest of its rate of change: an expression.");
              s.text("next", one.next,
                     "Expression for its value after each step, instead of a rate; for automata.");
              s.leftOut("next", "nothing: it has a rate");
              s.text("start", one.start,
                     "In the first state: an expression of x, y, in volumes z, random(k) and parameters.");
              s.number("edge", one.edge, scene::anyNumber, "",
                       "Beyond the edges of \"boundary\": \"fixed\".");
            });
  f.text("show", show, "Value that is drawn: a species, or any expression.");
  f.leftOut("show", "the preset's, or the first species");
  f.list(
      "strokes", strokes,
      "Timed strokes of a brush. In a volume places have three numbers, and circles are balls; on a mesh "
      "places and radii are m of the world, where the mesh is then.",
      [](scene::Fields& s, ReactionStroke& stroke) {
        stroke.describe(s, 1e9, "Value that is painted.");
        s.text("species", stroke.species, "Which species is painted.");
        s.leftOut("species", "the first");
      });
  f.group("display",
          "Placement of the value that is shown over the picture; for a volume only its colours count.",
          [&](scene::Fields& d) { display.describe(d); });
  f.group("surface", "Draws a volume as the surface where the value that is shown reaches a level.",
          [&](scene::Fields& g) { surface.describe(g); });
  f.optionalGroup(
      "mesh", mesh,
      "The cells are the vertices of a mesh, in place of a grid: \"spacing\" is their mean distance.");
  useStandardPreset(f);
  checkSpace(f);
  if (presteps > 0 && readsFields())
    f.error(
        "presteps",
        "no other object has a field before the first frame; leave out \"presteps\" and give the scene's "
        "\"time\" a \"start\", which steps all of them");

  if (species.empty()) {
    f.error("species", "there are no equations: give a \"preset\" or \"species\"");
    return;
  }
  if (species.size() > maxSpecies)
    f.error("species", fmt::format("at most {} species, with those of the preset; found {}", maxSpecies,
                                   species.size()));
  for (const ReactionSpecies& one : species)
    if (!one.next.empty() && method != RuleMethod::euler)
      f.error("method",
              fmt::format("{} has a \"next\", which works only with \"euler\"", scene::inQuotes(one.name)));
  std::vector<std::string> known;
  for (const ReactionSpecies& one : species) known.push_back(one.name);
  for (const ReactionStroke& stroke : strokes)
    if (painted(stroke) < 0)
      f.error("strokes",
              fmt::format("a stroke paints the species {}, which does not exist; {}",
                          scene::inQuotes(stroke.species), scene::suggestion(stroke.species, known)));
  try {
    static_cast<void>(compileRule(ruleText()));
  } catch (const RuleMistake& mistake) {
    f.errorIn(mistake.path, mistake.begin, mistake.end, mistake.message);
  }
}

void ReactionSurface::describe(scene::Fields& f) {
  f.choice("draw", draw, {"isosurface", "cubes"},
           "isosurface: a smooth surface where the value passes \"level\"; cubes: a cube for every cell at "
           "that level or above.");
  f.optionalValue("level", level, scene::Animated<float>(0.5F), [&](scene::Animated<float>& value) {
    f.number("level", value, scene::anyNumber, "",
             "Value at the surface; inside, the value that is shown is at least this.");
  });
  f.leftOut("level", "the middle between the display's \"low\" and \"high\"");
  f.text("color", color,
         "Value that the display's \"map\" colours it by, from \"low\" to \"high\": a species, or any "
         "expression.");
  f.leftOut("color", "nothing: it has its material's colour");
  f.vector("position", position, scene::anyNumber, "m", "Middle of the volume.");
  f.number("width", width, {1e-3, 1e4}, "m", "Width of the volume along x; its cells are cubes.");
  f.boolean("closed", closed,
            "Closes the surface where it reaches the border of the volume; else it ends there.");
}

void ReactionParameters::checkSpace(scene::Fields& f) const {
  if (mesh) return checkMesh(f);
  constexpr std::int64_t maxVolume = std::int64_t{1} << 28;
  if (depth == 1) {
    if (f.given("surface"))
      f.error("surface", "a flat grid has no surface; give it a \"depth\" of more than 1");
    return;
  }
  if (const std::int64_t cells = std::int64_t{size.x} * size.y * depth; cells > maxVolume)
    f.error("depth",
            fmt::format("{} are {} cells; a volume has at most {}", cellsText(), cells, maxVolume));
  checkBrushes(f);
}

void ReactionParameters::checkMesh(scene::Fields& f) const {
  for (const char* name : {"size", "depth", "boundary", "surface"})
    if (f.given(name))
      f.error(name, fmt::format("\"{}\" is for a grid; the cells of a \"mesh\" are its vertices", name));
  checkBrushes(f);
}

void ReactionParameters::checkBrushes(scene::Fields& f) const {
  for (const ReactionStroke& stroke : strokes)
    if (stroke.shape == StrokeParameters::Shape::image)
      f.error("strokes",
              "an \"image\" can be painted only on flat grids; use a circle, which is a ball here");
}

std::string ReactionParameters::cellsText() const {
  return depth > 1 ? fmt::format("{}x{}x{}", size.x, size.y, depth) : fmt::format("{}x{}", size.x, size.y);
}

float ReactionParameters::levelAt(double time) const {
  return surface.level ? surface.level->at(time) : static_cast<float>(0.5 * (display.low + display.high));
}

std::optional<scene::Box> ReactionParameters::framed() const {
  if (space() == RuleSpace::plane) return std::nullopt;
  if (mesh) return mesh->framed();
  const glm::vec3 half = 0.5F * cellWidth() * glm::vec3(size, depth);
  return scene::Box{surface.position - half, surface.position + half};
}

RuleText ReactionParameters::ruleText() const {
  RuleText text;
  for (const ReactionSpecies& one : species)
    text.species.push_back(
        {one.name, one.rate, one.start, one.next, one.diffusion.moves() || one.diffusion.at(0) != 0});
  for (const ReactionParameter& parameter : parameters)
    text.parameters.push_back(
        {parameter.name, parameter.isMapped(), parameter.isPresets, !parameter.field.empty()});
  for (const ReactionLet& let : lets) text.lets.push_back({let.name, let.is});
  text.show = show;
  text.tint = surface.color;
  text.space = space();
  return text;
}

void ReactionParameters::ports(Ports& ports) const {
  Ports::Offer& field = ports.provide<FieldSource>(space() == RuleSpace::plane);
  for (const ReactionSpecies& one : species) field.parts.push_back(one.name);
  if (space() == RuleSpace::mesh)
    field.unless = " on a mesh, whose field only a reaction on the same mesh can use";
  if (space() == RuleSpace::volume)
    field.unless = fmt::format(
        " in a volume of {} cells, whose field only a volume of the same proportions can use", cellsText());
  for (const ReactionParameter& parameter : parameters)
    if (!parameter.field.empty())
      ports.requireFrom<FieldSource>(parameter.field, {"parameters", parameter.name, "field"},
                                     When::frameStart);
}

bool ReactionParameters::readsFields() const {
  return std::any_of(parameters.begin(), parameters.end(),
                     [](const ReactionParameter& parameter) { return !parameter.field.empty(); });
}

bool ReactionParameters::readsCellsOf(const OwnCells& other) const {
  const auto* reaction = dynamic_cast<const ReactionParameters*>(&other);
  if (reaction == nullptr || space() != reaction->space()) return false;
  if (space() == RuleSpace::mesh) return mesh->isMadeAs(*reaction->mesh);
  const auto alike = [&](int side, int theirs) {
    return std::int64_t{side} * reaction->size.x == std::int64_t{theirs} * size.x;
  };
  return space() == RuleSpace::volume && alike(size.y, reaction->size.y) && alike(depth, reaction->depth);
}

int ReactionParameters::painted(const ReactionStroke& stroke) const {
  if (stroke.species.empty()) return 0;
  for (std::size_t i = 0; i < species.size(); ++i)
    if (species[i].name == stroke.species) return static_cast<int>(i);
  return -1;
}

std::span<const scene::Quantity> ReactionParameters::quantities() const {
  static const scene::Quantity table[] = {
      {"meanValue", "", "Mean of the value that is shown."},
      {"leastValue", "", "Least of the value that is shown."},
      {"mostValue", "", "Greatest of the value that is shown."},
      {"deviation", "", "Standard deviation of the value that is shown."},
      {"wavelength", "cells", "Wavelength that holds most of the variance of the value that is shown."}};
  return table;
}

}  // namespace simreel::sim
