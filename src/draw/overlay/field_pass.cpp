#include "draw/overlay/field_pass.hpp"

#include "base/error.hpp"
#include "draw/overlay/box_kernel.hpp"
#include "draw/rows_at_once.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

namespace {

using FieldLayer = sim::FieldDisplay::Layer;

constexpr int maxTexels = 4096;  // of a reduced field, on a side

bool shown(const sim::Field& field, double seconds) {
  return field.display != nullptr && field.display->layer != FieldLayer::none &&
         field.display->opacity.at(seconds) > 1e-6F && field.size.x > 0 && field.size.y > 0;
}

/// Squares, categories and what has colours are averaged as light; smooth values before they are coloured.
bool averagesLight(const sim::Field& field) {
  return field.categories || !field.display->smooth || field.cells == sim::Field::Cells::colors;
}

bool hasSmoothColors(const sim::Field& field) {
  return field.cells == sim::Field::Cells::colors && field.display->smooth;
}

bool hasRelief(const sim::Field& field) {
  return field.display->relief != 0 && !field.categories;
}

/// Whether no pixel covers more than an element: boxes then have two on a side at most.
bool isMagnified(const sim::Field& field, int reduction, glm::ivec2 picture, double seconds) {
  const glm::dvec2 perPixel = fieldView(*field.display, field.size, picture, seconds).perPixel;
  constexpr double most = 0.999;  // of floats that were rounded on the way
  return reduction == 1 && perPixel.x <= most && perPixel.y <= most;
}

/// Pixels of an invocation, one below the other. Relief takes eight means over up to 42 elements a side
/// more, and drivers end loops in silence after 65,535 turns.
int rowsFor(const sim::Field& field) {
  return hasRelief(field) ? 1 : rowsAtOnce();
}

}  // namespace

int FieldPass::reductionFor(glm::ivec2 cells, glm::dvec2 perPixel) {
  const double under = std::min(std::min(perPixel.x, perPixel.y), 2.0 * FieldKernel::maxReduction);
  const int wanted = std::max(1, static_cast<int>(under / 2));
  const int min = (std::max(cells.x, cells.y) + maxTexels - 1) / maxTexels;
  // Too few texels for this magnification: the cells themselves then.
  return wanted < min ? 1 : wanted;
}

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

void FieldPass::draw(const sim::Drawables& drawables, FieldLayer layer, double seconds) {
  SIMREEL_CHECK(!exact_);
  for (std::size_t i = 0; i < drawables.fields.size(); ++i) {
    const sim::Field& field = drawables.fields[i];
    if (shown(field, seconds) && field.display->layer == layer) drawOne(field, kept_.at(i), seconds);
  }
}

const gl::Program& FieldPass::program(const sim::Field& field, const Kept& kept, double seconds) {
  const bool reduced = kept.reduction > 1;
  const bool over = field.display->layer == FieldLayer::over;
  const bool magnified = isMagnified(field, kept.reduction, picture_, seconds);
  // Software drivers would read what nobody sees: they run both sides of a branch.
  const bool opaque = exact_ && over && field.display->opacity.at(seconds) >= 1;
  const int variant = static_cast<int>(field.cells) + (field.categories ? 4 : 0) + (kept.colored ? 8 : 0) +
                      (reduced ? 16 : 0) + (over ? 32 : 0) + (hasRelief(field) ? 64 : 0) +
                      (field.display->tiled ? 128 : 0) + (hasSmoothColors(field) ? 256 : 0) +
                      (opaque ? 512 : 0) + (magnified ? 1024 : 0);
  const auto found = programs_.find(variant);
  if (found != programs_.end()) return found->second;
  gl::Defines defines = fieldDefines(field, kept.colored);
  if (reduced) defines.emplace_back("REDUCED", "1");
  if (over) defines.emplace_back("OVER", "1");
  if (opaque) defines.emplace_back("OPAQUE", "1");
  if (magnified) defines.emplace_back("MAGNIFIED", "1");
  if (exact_) defines.emplace_back("ROWS", std::to_string(rowsFor(field)));
  if (hasSmoothColors(field)) defines.emplace_back("SMOOTH_COLORS", "1");
  if (field.display->tiled) defines.emplace_back("TILED", "1");
  if (hasRelief(field)) defines.emplace_back("RELIEF", "1");
  return programs_
      .emplace(variant, exact_ ? gl::Program::compute("draw/overlay/field.comp", defines)
                               : gl::Program::graphics("draw/overlay/field.vert", "draw/overlay/field.frag",
                                                       defines))
      .first->second;
}

void FieldPass::setPlace(const gl::Program& shader, const sim::Field& field, const Kept& kept,
                         const FieldView& view, double seconds) const {
  const sim::FieldDisplay& display = *field.display;
  const bool reduced = kept.reduction > 1;
  const FieldPlace place = fieldPlace(
      field, view, reduced ? glm::ivec2(kept.reduced.width(), kept.reduced.height()) : field.size);
  setField(shader, field, kept.colors);
  if (reduced) kept.reduced.bind(reducedUnit);
  shader.set("size", place.size);
  shader.set("base", place.base);
  shader.set("start", place.start);
  shader.set("perPixel", place.perPixel);
  shader.set("slope", place.slope);
  shader.set("border", display.border);
  shader.set("opacity", display.opacity.at(seconds));
}

void FieldPass::drawOne(const sim::Field& field, const Kept& kept, double seconds) {
  const FieldView view = fieldView(*field.display, field.size, picture_, seconds);
  const gl::Program& shader = program(field, kept, seconds);
  DrawState{.depthTest = false}.set();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  setPlace(shader, field, kept, view, seconds);
  shader.set("part", glm::vec4(view.part));
  shader.set("picture", glm::vec2(picture_));
  shader.set("topFirst", static_cast<int>(field.display->layer == FieldLayer::over));
  shader.use();
  vertices_.bind();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void FieldPass::drawOver(const sim::Drawables& drawables, double seconds, const gl::Texture& picture) {
  SIMREEL_CHECK(exact_);
  for (std::size_t i = 0; i < drawables.fields.size(); ++i) {
    const sim::Field& field = drawables.fields[i];
    if (shown(field, seconds) && field.display->layer == FieldLayer::over)
      drawOneExactly(field, kept_.at(i), seconds, picture, -1);
  }
}

void FieldPass::drawBehind(const sim::Drawables& drawables, double seconds, const gl::Texture& light,
                           bool topFirst) {
  SIMREEL_CHECK(exact_);
  // Behind all that is there, so the last one comes first.
  for (std::size_t i = drawables.fields.size(); i-- > 0;) {
    const sim::Field& field = drawables.fields[i];
    if (shown(field, seconds) && field.display->layer == FieldLayer::behind)
      drawOneExactly(field, kept_.at(i), seconds, light, topFirst ? -1 : picture_.y - 1);
  }
}

void FieldPass::drawOneExactly(const sim::Field& field, const Kept& kept, double seconds,
                               const gl::Texture& target, int lastRow) {
  const FieldView view = fieldView(*field.display, field.size, picture_, seconds);
  const glm::ivec4 part(
      glm::clamp(view.part, glm::dvec4(0), glm::dvec4(picture_.x, picture_.y, picture_.x, picture_.y)));
  const gl::Program& shader = program(field, kept, seconds);
  setPlace(shader, field, kept, view, seconds);
  shader.set("part", part);
  shader.set("lastRow", lastRow);
  target.bindImage(targetImage, GL_READ_WRITE);
  imageBarrier();
  const int rows = rowsFor(field);
  shader.dispatch(part.z - part.x, (part.w - part.y + rows - 1) / rows);
  imageBarrier();
}

bool FieldPass::hidesAll(const sim::Drawables& drawables, double seconds) const {
  return std::any_of(drawables.fields.begin(), drawables.fields.end(), [&](const sim::Field& field) {
    if (!shown(field, seconds) || field.display->layer != FieldLayer::over) return false;
    const glm::ivec4 part(fieldView(*field.display, field.size, picture_, seconds).part);
    const glm::ivec2 scales = axesMargin(*field.display, picture_);
    return field.display->opacity.at(seconds) >= 1 && part.x <= scales.x && part.y <= 0 &&
           part.z >= picture_.x && part.w + scales.y >= picture_.y;
  });
}

}  // namespace simreel::draw
