#include "sim/isolines/isolines.hpp"

#include "base/error.hpp"
#include "sim/grid/field_values.hpp"
#include "sim/grid/field_view.hpp"
#include "sim/isolines/labels.hpp"
#include "sim/isolines/lines.hpp"
#include "sim/isolines/parameters.hpp"
#include "sim/mesh/buffers.hpp"
#include "sim/ports/field_source.hpp"
#include "sim/ports/landform.hpp"
#include "sim/ports/shown_picture.hpp"
#include "sim/text/letters/layout.hpp"
#include "sim/text/solid_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

/// Throws UserError(usage) for characters that the font does not have.
void checkIsolines(const scene::Object& object, const Setting& /*setting*/) {
  const auto& parameters = parametersOf<IsolineParameters>(object);
  if (!parameters.labels) return;
  const Font font(parameters.fontFile());
  try {
    checkWritable(font, parameters.unit);
  } catch (const UserError& error) {
    fail(error.code(), "isolines \"{}\": {}", object.name, error.what());
  }
}

constexpr int landSamples = 512;  // samples along the longer side of a surface

/// Heights of a surface on a regular grid, seen from above: x along x and y along z of the world. A pixel
/// of the grid is `pixel` metres wide, and the corner of its first pixel is at `corner`.
struct LandGrid {
  IsoGrid grid;
  glm::dvec2 corner{0};
  double pixel = 1;

  /// Returns the height in metres at a position in pixels, or NaN beside the surface.
  [[nodiscard]] double at(const glm::dvec2& place) const {
    const glm::dvec2 from = glm::clamp(glm::floor(place - 0.5), glm::dvec2(0), glm::dvec2(grid.size - 2));
    const glm::dvec2 beyond = glm::clamp(place - 0.5 - from, 0.0, 1.0);
    const auto value = [&](double x, double y) {
      return grid.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.size.x) +
                         static_cast<std::size_t>(x)];
    };
    const double above = glm::mix(value(from.x, from.y), value(from.x + 1, from.y), beyond.x);
    const double below = glm::mix(value(from.x, from.y + 1), value(from.x + 1, from.y + 1), beyond.x);
    return glm::mix(above, below, beyond.y);
  }
  [[nodiscard]] glm::dvec3 inWorld(const glm::dvec2& place, double height) const {
    return {corner.x + pixel * place.x, height, corner.y + pixel * place.y};
  }
};

/// Enters the heights of a triangle into the samples that it covers. Where several triangles are above each
/// other, the highest counts.
void enterTriangle(LandGrid& land, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const auto place = [&](const glm::dvec3& p) {
    return (glm::dvec2(p.x, p.z) - land.corner) / land.pixel - 0.5;
  };
  const glm::dvec2 p = place(a), q = place(b), r = place(c);
  const double area = (q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y);
  if (std::abs(area) < 1e-12) return;
  const glm::dvec2 low = glm::ceil(glm::min(p, glm::min(q, r)) - 1e-6);
  const glm::dvec2 high = glm::floor(glm::max(p, glm::max(q, r)) + 1e-6);
  for (double y = std::max(low.y, 0.0); y <= std::min<double>(high.y, land.grid.size.y - 1); ++y)
    for (double x = std::max(low.x, 0.0); x <= std::min<double>(high.x, land.grid.size.x - 1); ++x) {
      const double ofB = ((x - p.x) * (r.y - p.y) - (r.x - p.x) * (y - p.y)) / area;
      const double ofC = ((q.x - p.x) * (y - p.y) - (x - p.x) * (q.y - p.y)) / area;
      constexpr double edge = -1e-6;  // samples on edges belong to both triangles
      if (ofB < edge || ofC < edge || 1 - ofB - ofC < edge) continue;
      double& height =
          land.grid.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(land.grid.size.x) +
                           static_cast<std::size_t>(x)];
      const double here = a.y + ofB * (b.y - a.y) + ofC * (c.y - a.y);
      if (!(height >= here)) height = here;
    }
}

LandGrid landGrid(const MeshTable& surface) {
  LandGrid land;
  if (surface.positions.empty()) return land;
  glm::dvec3 low(surface.positions.front()), high = low;
  for (const glm::vec3& p : surface.positions) {
    low = glm::min(low, glm::dvec3(p));
    high = glm::max(high, glm::dvec3(p));
  }
  const double longer = std::max(high.x - low.x, high.z - low.z);
  if (!(longer > 0)) return land;
  land.corner = {low.x, low.z};
  land.pixel = longer / landSamples;
  land.grid.first = glm::dvec2(0.5);
  land.grid.size = glm::max(
      glm::ivec2(glm::ceil(glm::dvec2(high.x - low.x, high.z - low.z) / land.pixel - 1e-6)), glm::ivec2(2));
  land.grid.values.assign(
      static_cast<std::size_t>(land.grid.size.x) * static_cast<std::size_t>(land.grid.size.y),
      std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i + 2 < surface.indices.size(); i += 3)
    enterTriangle(land, surface.positions[surface.indices[i]], surface.positions[surface.indices[i + 1]],
                  surface.positions[surface.indices[i + 2]]);
  return land;
}

/// Adds a tube of `radius` metres around a level line.
void addTube(const IsoLine& line, const LandGrid& land, double height, double radius, Mesh& mesh) {
  constexpr int sides = 6;
  constexpr double half = 0.8660254037844386;  // sine of 60 degrees
  constexpr std::array<glm::dvec2, sides> circle = {
      {{1, 0}, {0.5, half}, {-0.5, half}, {-1, 0}, {-0.5, -half}, {0.5, -half}}};
  const std::size_t count = line.points.size();
  if (count < 2) return;
  const auto first = static_cast<unsigned>(mesh.positions.size());
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec2& before = line.points[i > 0 ? i - 1 : line.closed ? count - 1 : 0];
    const glm::dvec2& after = line.points[i + 1 < count ? i + 1 : line.closed ? 0 : i];
    const glm::dvec2 way = after - before;
    const double length = glm::length(way);
    const glm::dvec2 side = length > 0 ? glm::dvec2(way.y, -way.x) / length : glm::dvec2(1, 0);
    const glm::dvec3 middle = land.inWorld(line.points[i], height);
    for (const glm::dvec2& turn : circle) {
      const glm::dvec3 out(turn.x * side.x, turn.y, turn.x * side.y);
      mesh.positions.emplace_back(middle + radius * out);
      mesh.normals.emplace_back(out);
    }
  }
  const auto rings = static_cast<unsigned>(count);
  for (unsigned i = 0; i + (line.closed ? 0U : 1U) < rings; ++i)
    for (unsigned k = 0; k < sides; ++k) {
      const unsigned a = first + i * sides + k, b = first + i * sides + (k + 1) % sides;
      const unsigned next = first + (i + 1) % rings * sides;
      const unsigned c = next + (k + 1) % sides, d = next + k;
      mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    }
}

/// Adds a number that lies flat on the surface below it, `lift` metres above its highest point.
void addNumber(const IsoLabel& label, const TextOutlines& text, double unit, const LandGrid& land,
               double lift, Mesh& mesh) {
  const Mesh letters = solidText(text, 1, 0);
  const glm::dvec2 up(label.along.y, -label.along.x);
  const double reach = 0.5 * label.width;
  const double here = land.at(label.middle);
  const auto slope = [&](const glm::dvec2& way, double far) {
    const double rise = (land.at(label.middle + far * way) - land.at(label.middle - far * way)) / (2 * far);
    return std::isfinite(rise) ? rise : 0.0;
  };
  const double alongSlope = slope(label.along, reach), upSlope = slope(up, 0.5 * unit);
  double above = 0;
  std::vector<glm::dvec2> places;
  for (const glm::vec3& p : letters.positions) {
    const glm::dvec2 at = unit * glm::dvec2(p);
    places.push_back(at);
    const double over = land.at(label.middle + at.x * label.along + at.y * up) -
                        (here + at.x * alongSlope + at.y * upSlope);
    if (std::isfinite(over)) above = std::max(above, over);
  }
  const glm::dvec2 downhill = -(alongSlope * label.along + upSlope * up) / land.pixel;
  const glm::vec3 normal(glm::normalize(glm::dvec3(downhill.x, 1, downhill.y)));
  const auto first = static_cast<unsigned>(mesh.positions.size());
  for (const glm::dvec2& at : places) {
    mesh.positions.emplace_back(land.inWorld(label.middle + at.x * label.along + at.y * up,
                                             here + at.x * alongSlope + at.y * upSlope + above + lift));
    mesh.normals.push_back(normal);
  }
  for (const unsigned index : letters.indices) mesh.indices.push_back(first + index);
}

using Outlines = std::vector<std::vector<glm::vec2>>;

/// True if the colour that a field has for a value is so dark that dark lines are hardly visible.
bool isDark(const Field& field, double value) {
  if (field.colors == nullptr || field.colors->empty() || field.categories || field.ownColors) return false;
  const double width = static_cast<double>(field.range.y) - field.range.x;
  const double part = width == 0 ? 0 : std::clamp((value - field.range.x) / width, 0.0, 1.0);
  const std::vector<glm::vec3>& colors = *field.colors;
  const double at = part * static_cast<double>(colors.size() - 1);
  const auto first = static_cast<std::size_t>(at);
  const glm::vec3 color = glm::mix(colors[first], colors[std::min(first + 1, colors.size() - 1)],
                                   static_cast<float>(at - std::floor(at)));
  constexpr float dark = 0.08F;  // luminance
  return glm::dot(color, glm::vec3(0.2126F, 0.7152F, 0.0722F)) < dark;
}

/// Lines of equal field values, drawn over the picture. This object has no state.
class Isolines : public Simulation {
 public:
  Isolines(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        parameters_(parametersOf<IsolineParameters>(object)),
        links_(setting.links),
        font_(parameters_.fontFile()) {
    checkIsolines(object, setting);
  }

  void step(double /*time*/, const StepWatch& /*watch*/) override {}

  void publish(double time, Drawables& drawables) const override {
    if (!parameters_.terrain.empty()) return publishOnTerrain(drawables);
    make(time);
    constexpr glm::vec3 lightInk(0.75F);
    for (const Outlines* outlines : {&dark_.lines, &light_.lines, &dark_.numbers, &light_.numbers}) {
      if (outlines->empty()) continue;
      const bool light = outlines == &light_.lines || outlines == &light_.numbers;
      Writing writing;
      writing.outlines = outlines;
      writing.height = parameters_.height;
      writing.color = light ? lightInk : parameters_.color;
      writing.opacity = parameters_.opacity;
      drawables.writings.push_back(writing);
    }
  }

 private:
  void publishOnTerrain(Drawables& drawables) const {
    const auto* land = dynamic_cast<const Landform*>(links_->simulation(parameters_.terrain));
    if (land == nullptr) return;
    MeshTable surface = land->landform();
    if (surface.positions != land_) {
      drawOn(landGrid(surface));
      land_ = std::move(surface.positions);
    }
    if (!drawn_) return;
    Surface lines = drawn_->surface();
    lines.doubleSided = true;
    lines.material = &ink_;
    drawables.surfaces.push_back(lines);
  }

  /// Creates the tubes and numbers on a surface.
  void drawOn(const LandGrid& land) const {
    drawn_.reset();
    glm::dvec2 range(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
    IsoGrid values = land.grid;
    for (double& value : values.values) {
      value = parameters_.zero + parameters_.scale * value;
      if (std::isfinite(value)) range = {std::min(range.x, value), std::max(range.y, value)};
    }
    const std::vector<IsoLevel> levels = parameters_.levels(range, range);
    const Layout made = layOut(levels, values, glm::dvec4(0, 0, values.size.x, values.size.y), landSamples);
    Mesh mesh;
    const double radius = 0.5 * static_cast<double>(parameters_.width) * landSamples * land.pixel;
    for (std::size_t i = 0; i < made.lines.size(); ++i) {
      const IsoLevel& level = levels[static_cast<std::size_t>(made.lines[i].level)];
      const double height = (level.value - parameters_.zero) / parameters_.scale;
      for (const IsoLine& line : withoutLabels(made.lines[i], made.labels, made.unit))
        addTube(line, land, height, radius * (level.bold ? 2 : 1), mesh);
    }
    for (const IsoLabel& label : made.labels)
      addNumber(label, made.texts[static_cast<std::size_t>(made.lines[label.line].level)], made.unit, land,
                radius, mesh);
    if (mesh.indices.empty()) return;
    ink_.color = parameters_.color;
    ink_.roughness = 1;
    ink_.castsShadow = false;
    drawn_.emplace(name_, mesh);
  }

  /// Returns the field. If it has no display, it gets the display of its object.
  [[nodiscard]] Field field() const {
    Field found = fieldNamed(*links_, parameters_.of);
    Drawables drawables;
    links_->simulation(PartName(parameters_.of).object)->publish(links_->now(), drawables);
    for (const Field& other : drawables.fields)
      if (found.display == nullptr && other.display != nullptr && other.size == found.size)
        found.display = other.display;
    if (found.display == nullptr || found.display->layer == FieldDisplay::Layer::none)
      fail(ExitCode::usage,
           "isolines \"{}\": \"{}\" is not displayed over the picture, so it has no place for lines; give "
           "its object \"display\": {{\"layer\": \"over\"}}",
           name_, parameters_.of);
    return found;
  }

  /// Creates the outlines of lines and numbers, unless the field and its view are unchanged.
  void make(double time) const {
    const Field shown = field();
    const glm::ivec2 picture = shownPicture(links_).size;
    const FieldView view = fieldView(*shown.display, shown.size, picture, time);
    std::vector<float> values = fieldValues(shown);
    if (values == values_ && view.origin == view_.origin && view.perPixel == view_.perPixel) return;
    values_ = std::move(values);
    view_ = view;
    glm::dvec2 extremes(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
    for (const float value : values_)
      if (std::isfinite(value))
        extremes = {std::min(extremes.x, static_cast<double>(value)),
                    std::max(extremes.y, static_cast<double>(value))};
    const std::vector<IsoLevel> levels = parameters_.levels(glm::dvec2(shown.range), extremes);
    // Another field may be displayed where the lines are.
    const bool own = parameters_.contrasts && fieldNamed(*links_, parameters_.of).display != nullptr;
    std::vector<bool> light;
    for (const IsoLevel& level : levels) light.push_back(own && isDark(shown, level.value));
    write(levels, light, isoGrid(values_, shown.size, view), picture);
  }

  /// Outlines of one colour.
  struct Inked {
    Outlines lines, numbers;
  };
  /// Lines and numbers in the plane, in pixels.
  struct Layout {
    double unit = 0;                  ///< cap height
    std::vector<TextOutlines> texts;  ///< number of each level, in units of the cap height
    std::vector<IsoLine> lines;
    std::vector<IsoLabel> labels;
  };
  /// Finds lines and numbers in the rectangle `part`. `whole`: the length in pixels of which the heights of
  /// letters are a fraction.
  [[nodiscard]] Layout layOut(const std::vector<IsoLevel>& levels, const IsoGrid& grid,
                              const glm::dvec4& part, double whole) const {
    Layout made;
    made.unit = static_cast<double>(parameters_.height) * whole;
    const bool some =
        std::any_of(levels.begin(), levels.end(), [](const IsoLevel& one) { return one.bold; });
    std::vector<double> at;
    IsoLabelSizes sizes;
    sizes.capital = made.unit;
    for (const IsoLevel& level : levels) {
      at.push_back(level.value);
      made.texts.push_back(
          written(font_, level.text, {TextAnchor::Across::center, TextAnchor::Down::middle}, 1));
      const bool numbered = parameters_.labels && (level.bold || !some);
      sizes.widths.push_back(numbered ? made.unit * widthOf(made.texts.back()) : 0);
    }
    made.lines = isoLines(grid, at, part);
    made.labels = placeLabels(made.lines, sizes, part);
    return made;
  }

  /// Creates the outlines. `light`: whether the ink of each level is light.
  void write(const std::vector<IsoLevel>& levels, const std::vector<bool>& light, const IsoGrid& grid,
             glm::ivec2 picture) const {
    const glm::dvec4 part =
        glm::clamp(view_.part, glm::dvec4(0), glm::dvec4(picture.x, picture.y, picture.x, picture.y));
    const auto [unit, texts, lines, labels] = layOut(levels, grid, part, picture.y);
    dark_ = light_ = {};
    const auto inkOf = [&](int level) -> Inked& {
      return light[static_cast<std::size_t>(level)] ? light_ : dark_;
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const bool bold = levels[static_cast<std::size_t>(lines[i].level)].bold;
      const double width = static_cast<double>(parameters_.width) * picture.y * (bold ? 2 : 1);
      for (const IsoLine& line : withoutLabels(lines[i], labels, unit))
        for (const auto& outline : isoStroke(line, width)) add(inkOf(lines[i].level).lines, outline, unit);
    }
    for (const IsoLabel& label : labels) {
      const glm::dvec2 up(label.along.y, -label.along.x);
      for (const auto& outline : texts[static_cast<std::size_t>(lines[label.line].level)]) {
        std::vector<glm::dvec2> turned;
        turned.reserve(outline.size());
        for (const glm::dvec2& point : outline)
          turned.push_back(label.middle + unit * (point.x * label.along + point.y * up));
        add(inkOf(lines[label.line].level).numbers, turned, unit);
      }
    }
  }

  static double widthOf(const TextOutlines& text) {
    double width = 0;
    for (const auto& outline : text)
      for (const glm::dvec2& point : outline) width = std::max(width, 2 * std::abs(point.x));
    return width;
  }

  /// Adds a polygon given in pixels, converted to the units of a Writing: the cap height, with y up.
  static void add(Outlines& outlines, const std::vector<glm::dvec2>& pixels, double unit) {
    auto& polygon = outlines.emplace_back();
    for (const glm::dvec2& point : pixels) polygon.emplace_back(point.x / unit, -point.y / unit);
  }

  std::string name_;
  IsolineParameters parameters_;
  const Links* links_;
  mutable Font font_;
  mutable std::vector<float> values_;
  mutable FieldView view_;
  mutable Inked dark_, light_;
  mutable std::vector<glm::vec3> land_;  ///< vertices of the surface with the current lines
  mutable std::optional<MeshBuffers> drawn_;
  mutable scene::Material ink_;
};

}  // namespace

SimulationKind isolinesKind() {
  return kindOf<IsolineParameters>("isolines", "Lines of equal values over a field, with numbers.",
                                   checkIsolines, makeSimulation<Isolines>);
}

}  // namespace simreel::sim
