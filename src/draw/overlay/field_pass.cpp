#include "draw/overlay/field_pass.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

namespace {

using Layer = sim::FieldDisplay::Layer;

constexpr int maxTexels = 4096;      // of a reduced field, on a side
constexpr float reliefCells = 7.0F;  // height of the whole range at relief 1

bool shown(const sim::Field& field, double seconds) {
  return field.display != nullptr && field.display->layer != Layer::none &&
         field.display->opacity.at(seconds) > 0 && field.size.x > 0 && field.size.y > 0;
}

/// Squares and categories are averaged as light; smooth values are averaged before they are coloured.
bool averagesLight(const sim::Field& field) {
  return field.categories || !field.display->smooth;
}

bool hasRelief(const sim::Field& field) {
  return field.display->relief != 0 && !field.categories;
}

/// Cells averaged into a texel on a side: the picture shows two to three texels a pixel then.
int reductionFor(glm::ivec2 cells, glm::dvec2 perPixel) {
  const double under = std::min(std::min(perPixel.x, perPixel.y), 2.0 * FieldKernel::maxReduction);
  const int wanted = std::max(1, static_cast<int>(under / 2));
  const int min = (std::max(cells.x, cells.y) + maxTexels - 1) / maxTexels;
  // Too few texels for this magnification: the cells themselves then.
  return wanted < min ? 1 : wanted;
}

glm::dvec2 wrapped(glm::dvec2 at, glm::dvec2 size) {
  return at - size * glm::floor(at / size);
}

}  // namespace

void FieldPass::prepare(const sim::Drawables& drawables, double seconds) {
  if (kept_.size() != drawables.fields.size()) kept_ = std::vector<Kept>(drawables.fields.size());
  for (std::size_t i = 0; i < kept_.size(); ++i)
    if (shown(drawables.fields[i], seconds)) reduce(drawables.fields[i], kept_[i], seconds);
}

void FieldPass::reduce(const sim::Field& field, Kept& kept, double seconds) {
  kept.colors.update(*field.colors);
  const int reduction =
      reductionFor(field.size, fieldView(*field.display, field.size, picture_, seconds).perPixel);
  const bool colored = averagesLight(field);
  const bool same = kept.cells == field.size && kept.reduction == reduction && kept.colored == colored;
  kept.cells = field.size;
  kept.reduction = reduction;
  kept.colored = colored;
  if (reduction == 1) return;
  if (!same || !kept.reduced) kept.reduced = FieldKernel::texture(field, reduction, colored, 1);
  kernel_.average(field, kept.colors, kept.reduced, colored);
}

void FieldPass::draw(const sim::Drawables& drawables, Layer layer, double seconds) {
  for (std::size_t i = 0; i < drawables.fields.size(); ++i) {
    const sim::Field& field = drawables.fields[i];
    if (shown(field, seconds) && field.display->layer == layer) drawOne(field, kept_.at(i), seconds);
  }
}

const gl::Program& FieldPass::program(const sim::Field& field, const Kept& kept) {
  const bool reduced = kept.reduction > 1;
  const bool over = field.display->layer == Layer::over;
  const int variant = static_cast<int>(field.cells) + (field.categories ? 4 : 0) + (kept.colored ? 8 : 0) +
                      (reduced ? 16 : 0) + (over ? 32 : 0) + (hasRelief(field) ? 64 : 0);
  const auto found = programs_.find(variant);
  if (found != programs_.end()) return found->second;
  gl::Defines defines = fieldDefines(field, kept.colored);
  if (reduced) defines.emplace_back("REDUCED", "1");
  if (over) defines.emplace_back("OVER", "1");
  if (hasRelief(field)) defines.emplace_back("RELIEF", "1");
  return programs_
      .emplace(variant,
               gl::Program::graphics("draw/overlay/field.vert", "draw/overlay/field.frag", defines))
      .first->second;
}

void FieldPass::drawOne(const sim::Field& field, const Kept& kept, double seconds) {
  const sim::FieldDisplay& display = *field.display;
  const FieldView view = fieldView(display, field.size, picture_, seconds);
  const gl::Program& shader = program(field, kept);
  const bool reduced = kept.reduction > 1;
  const glm::ivec2 size = reduced ? glm::ivec2(kept.reduced.width(), kept.reduced.height()) : field.size;
  const glm::dvec2 elements = glm::dvec2(size) / glm::dvec2(field.size);  // a cell
  // Whole elements apart: a float keeps the rest of them exact, however large the field.
  glm::dvec2 first = glm::clamp(view.origin * elements, -1e9, 1e9);
  if (display.tiled) first = wrapped(first, glm::dvec2(size));
  const glm::dvec2 base = glm::floor(first);

  DrawState{.depthTest = false}.set();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  shader.use();
  setField(shader, field, kept.colors);
  if (reduced) kept.reduced.bind(reducedUnit);
  shader.set("part", glm::vec4(view.part));
  shader.set("picture", glm::vec2(picture_));
  shader.set("topFirst", static_cast<int>(display.layer == Layer::over));
  shader.set("size", size);
  shader.set("base", glm::ivec2(base));
  shader.set("start", glm::vec2(first - base));
  shader.set("perPixel", glm::vec2(view.perPixel * elements));
  shader.set("tiled", static_cast<int>(display.tiled));
  shader.set("border", display.border);
  shader.set("opacity", display.opacity.at(seconds));
  shader.set("slope", display.relief * reliefCells * glm::vec2(elements));
  vertices_.bind();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

bool FieldPass::hidesAll(const sim::Drawables& drawables, double seconds) const {
  return std::any_of(drawables.fields.begin(), drawables.fields.end(), [&](const sim::Field& field) {
    if (!shown(field, seconds) || field.display->layer != Layer::over) return false;
    const glm::ivec4 part(fieldView(*field.display, field.size, picture_, seconds).part);
    const glm::ivec2 scales = axesMargin(*field.display, picture_);
    return field.display->opacity.at(seconds) >= 1 && part.x <= scales.x && part.y <= 0 &&
           part.z >= picture_.x && part.w + scales.y >= picture_.y;
  });
}

}  // namespace simreel::draw
