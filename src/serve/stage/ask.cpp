#include "serve/stage/ask.hpp"

#include "draw/overlay/field_view.hpp"
#include "draw/screen/renderer.hpp"
#include "frame/draw_world.hpp"
#include "golden/trace/passes.hpp"
#include "sim/grid/field_values.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace simreel::serve {

namespace {

PixelInfo::Row rowOf(const std::string& name, float value) {
  return {name, static_cast<double>(value), fmt::format("{:08x}", std::bit_cast<std::uint32_t>(value))};
}

/// Adds the four 32-bit words of an array's element to the answer.
void addElement(PixelInfo& answer, const sim::StateArray& array, std::size_t element) {
  constexpr const char* words = "xyzw";
  if (array.integers) {
    const auto all = array.readAll<glm::uvec4>();
    for (int i = 0; i < 4; ++i) {
      const std::uint32_t word = all[element][i];
      answer.rows.push_back({fmt::format("{}.{}", array.name, words[i]), static_cast<double>(word),
                             fmt::format("{:08x}", word)});
    }
    return;
  }
  const auto all = array.readAll<glm::vec4>();
  for (int i = 0; i < 4; ++i)
    answer.rows.push_back(rowOf(fmt::format("{}.{}", array.name, words[i]), all[element][i]));
}

/// Adds the words of the element with index `element` from each of the object's arrays that has the same
/// number of elements.
void addState(PixelInfo& answer, const sim::Simulation& object, std::size_t element, long elements) {
  for (const sim::StateArray& array : object.state())
    if (array.elements() == elements) addElement(answer, array, element);
}

/// Adds the element whose position is nearest to a point of the scene (metres).
void addNearest(PixelInfo& answer, const sim::Simulation& object, const glm::vec3& point) {
  for (const sim::StateArray& array : object.state()) {
    if (array.integers || std::string_view(array.name).find("osition") == std::string_view::npos) continue;
    const auto positions = array.readAll<glm::vec4>();
    std::size_t nearest = 0;
    float minimum = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const float distance = glm::distance(glm::vec3(positions[i]), point);
      if (distance < minimum) {
        minimum = distance;
        nearest = i;
      }
    }
    if (!std::isfinite(minimum)) return;
    answer.rows.push_back(
        {"nearest element", std::nullopt, object.elementName(static_cast<long>(nearest))});
    answer.rows.push_back({"its distance, m", static_cast<double>(minimum), ""});
    return addState(answer, object, nearest, array.elements());
  }
}

/// Adds the element that belongs to a cell, for objects whose elements have cell coordinates.
void addCell(PixelInfo& answer, const sim::Simulation& object, glm::ivec2 cell) {
  constexpr long nameLimit = 2'000'000;
  const std::string wanted = fmt::format("({}, {})", cell.x, cell.y);
  for (const sim::StateArray& array : object.state()) {
    for (long i = 0; i < std::min(array.elements(), nameLimit); ++i) {
      if (object.elementName(i).find(wanted) == std::string::npos) continue;
      answer.rows.push_back({"element", std::nullopt, object.elementName(i)});
      return addElement(answer, array, static_cast<std::size_t>(i));
    }
  }
}

const sim::Simulation* objectNamed(const sim::World& world, std::string name) {
  for (int rounds = 0; rounds < 2; ++rounds) {
    for (std::size_t i = 0; i < world.objectCount(); ++i)
      if (world.objectName(i) == name) return &world.object(i);
    name = name.substr(0, name.find('.'));  // The fields of an object with several fields are named
                                            // OBJECT.FIELD.
  }
  return nullptr;
}

/// Returns the cell of the topmost field of `layer` at the pixel, with its values. Returns nullopt if there
/// is no field.
std::optional<PixelInfo> cellAt(const scene::Scene& scene, sim::World& world, glm::dvec2 pixel,
                                sim::FieldDisplay::Layer layer) {
  const sim::Drawables drawables = world.drawables();
  std::optional<PixelInfo> answer;
  for (const sim::Field& field : drawables.fields) {
    if (field.decoration || field.display == nullptr || field.display->layer != layer) continue;
    const draw::FieldView view =
        draw::fieldView(*field.display, field.size, scene.render.size, world.time());
    if (pixel.x < view.part.x || pixel.y < view.part.y || pixel.x >= view.part.z || pixel.y >= view.part.w)
      continue;
    glm::ivec2 cell(glm::floor(view.origin + view.perPixel * pixel));
    if (field.display->tiled)
      cell = ((cell % field.size) + field.size) % field.size;
    else if (cell.x < 0 || cell.y < 0 || cell.x >= field.size.x || cell.y >= field.size.y)
      continue;
    const auto values = sim::fieldValues(field);
    const auto at = static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(field.size.x) +
                    static_cast<std::size_t>(cell.x);
    answer = PixelInfo{fmt::format("cell ({}, {}) of {}", cell.x, cell.y, *field.name), {}};
    answer->rows.push_back(rowOf("value", values.at(at)));
    if (const sim::Simulation* object = objectNamed(world, *field.name)) addCell(*answer, *object, cell);
  }
  return answer;
}

}  // namespace

std::optional<FieldPoint> fieldAt(const scene::Scene& scene, const sim::World& world, glm::dvec2 place) {
  const glm::dvec2 pixel = place * glm::dvec2(scene.render.size);
  const sim::Drawables drawables = world.drawables();
  std::optional<FieldPoint> found;
  for (const sim::Field& field : drawables.fields) {
    if (field.decoration || field.display == nullptr ||
        field.display->layer == sim::FieldDisplay::Layer::none)
      continue;
    const draw::FieldView view =
        draw::fieldView(*field.display, field.size, scene.render.size, world.time());
    if (pixel.x < view.part.x || pixel.y < view.part.y || pixel.x >= view.part.z || pixel.y >= view.part.w)
      continue;
    found =
        FieldPoint{field.name->substr(0, field.name->find('.')), view.origin + view.perPixel * pixel - 0.5};
  }
  return found;
}

PixelInfo pixelInfo(const scene::Scene& scene, sim::World& world, glm::dvec2 place) {
  const glm::ivec2 size = scene.render.size;
  const glm::ivec2 pixel =
      glm::clamp(glm::ivec2(glm::floor(place * glm::dvec2(size))), glm::ivec2(0), size - 1);
  const PixelInfo::Row where{"pixel", std::nullopt, fmt::format("{}, {}", pixel.x, pixel.y)};
  const glm::dvec2 middle = glm::dvec2(pixel) + 0.5;
  if (auto cell = cellAt(scene, world, middle, sim::FieldDisplay::Layer::over)) {
    cell->rows.insert(cell->rows.begin(), where);
    return *cell;
  }
  draw::Renderer renderer(scene, size, 1, {.rasterizer = scene::Rasterizer::exact});
  draw::PassPicture passes;
  renderer.keepPasses(&passes);
  renderer.keepLayers({{draw::Layer::depth, draw::Layer::position, draw::Layer::object}, false, 32, true});
  frame::drawWorld(renderer, world);
  const draw::PictureLayers layers = renderer.takeLayers();
  const golden::SeenThing thing = golden::thingAt(passes, pixel.x, pixel.y);
  if (thing.primitive == "sky")
    if (auto cell = cellAt(scene, world, middle, sim::FieldDisplay::Layer::behind)) {
      cell->rows.insert(cell->rows.begin(), where);
      return *cell;
    }
  PixelInfo answer{thing.name(), {where}};
  const auto at = static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size.x) +
                  static_cast<std::size_t>(pixel.x);
  if (thing.primitive == "sky" || layers.position.size() < 3 * (at + 1)) return answer;
  const glm::vec3 point(layers.position[3 * at], layers.position[3 * at + 1], layers.position[3 * at + 2]);
  for (int i = 0; i < 3; ++i) answer.rows.push_back(rowOf(fmt::format("world {}, m", "xyz"[i]), point[i]));
  answer.rows.push_back({"depth, m", static_cast<double>(layers.depth[at]), ""});
  if (const sim::Simulation* object = objectNamed(world, thing.object)) addNearest(answer, *object, point);
  return answer;
}

}  // namespace simreel::serve
