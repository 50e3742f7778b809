// Scene description of pins.
#include "sim/cloth/parameters.hpp"

#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

void checkLines(scene::Fields& f, const char* name, const std::vector<int>& lines, int count) {
  for (const int line : lines)
    if (line >= count || line < -count)
      f.error(name,
              fmt::format("{} {} is outside the cloth: it has {} (0 to {}, or -1 for the last)",
                          std::string_view(name) == "rows" ? "row" : "column", line, count, count - 1));
}

}  // namespace

void PinGroup::describe(scene::Fields& f, const glm::ivec2& grid, bool onMesh) {
  f.integers("rows", rows, {-1e6, 1e6}, "", "Rows to pin; negative ones count from the last.");
  f.integers("columns", columns, {-1e6, 1e6}, "", "Columns to pin; negative ones count from the last.");
  f.someOf("corners", corners, {"top-left", "top-right", "bottom-left", "bottom-right"},
           "Corners to pin; row 0 is the top.");
  f.pairs("points", points, {0, 1e6}, "", "Single particles to pin, each [x, y].");
  f.integers(
      "vertices", vertices, {0, 1e7}, "",
      "Vertices of a mesh to pin, counted from 0, in the order in which \"simreel bake\" writes them.");
  f.optionalGroup("box", box, "For a mesh: pins every vertex that lies in this box at the start.",
                  [](scene::Fields& b, PinBox& limits) {
                    b.vector("min", limits.min, scene::anyNumber, "m",
                             "Least corner of the box, in world space.");
                    b.vector("max", limits.max, scene::anyNumber, "m", "Greatest corner of the box.");
                    for (int i = 0; i < 3; ++i)
                      if (limits.max[i] < limits.min[i])
                        b.error("max", "the greatest corner lies below the least one");
                  });
  f.asset("map", map, "Picture over the uv of a mesh; vertices are pinned where it is brighter than half.");
  f.boolean("clamp", clamp,
            "Also holds the direction in which a fabric leaves a pinned border, as between two plates.");
  f.integer("every", every, {1, 1e6}, "",
            "Pins only every n-th particle of rows and columns, and the last one.");
  f.vector("move", move, scene::anyNumber, "m", "Movement of the pins.");
  f.vector("rotate", rotate, scene::anyNumber, "degrees", "Rotation of the pins about the pivot.");
  f.vector("scale", scale, {-1e3, 1e3}, "", "Scale of the pins about the pivot.");
  f.vector("pivot", pivot, scene::anyNumber, "m", "Fixed point of rotation and scale, in world space.");
  f.text("to", to,
         "Name of a body that carries the pins: they follow its \"bone\", or its skin, from where the "
         "sheet lies at the "
         "start.");
  f.text("bone", bone, "Name of the bone in the body's file.");
  f.choice("at", at, {"bone", "nearest"},
           "bone: the bone carries the pins; nearest: the nearest place of the body's skin carries each "
           "pin, at the distance that it has at the start.");
  f.idleUnless(!rows.empty() || !columns.empty(), "rows", {"every"}, "\"rows\" and \"columns\"");
  f.idleUnless(f.given("rotate") || f.given("scale"), "rotate", {"pivot"}, "\"rotate\" and \"scale\"");
  checkCarrier(f);
  checkTargets(f, grid, onMesh);
}

void PinGroup::checkCarrier(scene::Fields& f) const {
  if (at == PinPlace::skin) {
    if (to.empty()) f.error("at", "pins at the nearest place of a skin need \"to\": the body");
    if (!bone.empty())
      f.error("bone", "pins at the nearest place of the skin follow no bone; leave out \"bone\" or \"at\"");
    for (const char* name : {"move", "rotate", "scale", "pivot", "clamp"})
      if (f.given(name))
        f.error(name,
                fmt::format("pins at the nearest place of the skin follow only the skin; leave out \"{}\"",
                            name));
  } else if (to.empty() != bone.empty()) {
    f.error(to.empty() ? "bone" : "to",
            "pins that a body carries need both \"to\", the body, and its \"bone\"; or give \"to\" and "
            "\"at\": \"nearest\"");
  }
}

void PinGroup::checkTargets(scene::Fields& f, const glm::ivec2& grid, bool onMesh) const {
  const std::pair<const char*, bool> ofGrids[] = {{"rows", !rows.empty()},
                                                  {"columns", !columns.empty()},
                                                  {"corners", !corners.empty()},
                                                  {"points", !points.empty()},
                                                  {"every", every != 1}};
  const std::pair<const char*, bool> ofMeshes[] = {
      {"vertices", !vertices.empty()}, {"box", box.has_value()}, {"map", !map.empty()}};
  if (onMesh) {
    for (const auto& [name, used] : ofGrids)
      if (used)
        f.error(name, fmt::format("a mesh has no {}; pin by \"vertices\", \"box\" or \"map\"", name));
    return;
  }
  for (const auto& [name, used] : ofMeshes)
    if (used)
      f.error(name, "this pins a mesh; a grid has \"rows\", \"columns\", \"corners\" and \"points\"");
  checkLines(f, "rows", rows, grid.y);
  checkLines(f, "columns", columns, grid.x);
  for (const glm::ivec2& p : points)
    if (p.x >= grid.x || p.y >= grid.y)
      f.error("points",
              fmt::format("[{}, {}] is outside the cloth of {}x{} particles", p.x, p.y, grid.x, grid.y));
}

}  // namespace simreel::sim
