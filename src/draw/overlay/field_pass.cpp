#include "draw/overlay/field_pass.hpp"

#include "base/error.hpp"
#include "draw/overlay/box_kernel.hpp"
#include "draw/rows_at_once.hpp"
#include "gl/kernel/give.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

struct DrawField {
  static constexpr auto file = "draw/overlay/field.comp";
  using Variant = FieldDrawVariant;
  ShownField shown;
  gl::InOut<"target"> target;
  gl::Uniform<"part", glm::ivec4> part;
  gl::Uniform<"lastRow", int> lastRow;
};

namespace {

using FieldLayer = sim::FieldDisplay::Layer;

constexpr int maxTexels = 4096;  // max side of a reduced field

bool shown(const sim::Field& field, double seconds) {
  return field.display != nullptr && field.display->layer != FieldLayer::none &&
         field.display->opacity.at(seconds) > 1e-6F && field.size.x > 0 && field.size.y > 0;
}

/// True if the field is averaged as light: nearest-neighbour display, categories and colours. Smooth values
/// are averaged before they are coloured.
bool averagesLight(const sim::Field& field) {
  return field.categories || !field.display->smooth || field.cells == sim::Field::Cells::colors;
}

/// True if magnified values or colours are a quadratic spline, which has no creases at the cells.
bool isSplined(const sim::Field& field) {
  return field.display->smooth && !field.categories;
}

bool hasRelief(const sim::Field& field) {
  return field.display->relief != 0 && !field.categories;
}

/// True if no pixel covers more than `elements` on a side. With one element, a pixel's box touches at most
/// two elements per side.
bool isMagnified(const sim::Field& field, int reduction, glm::ivec2 picture, double seconds,
                 double elements) {
  const glm::dvec2 perPixel = fieldView(*field.display, field.size, picture, seconds).perPixel;
  const double maximum = 0.999 * elements;  // slightly less, to allow for float rounding
  return reduction == 1 && perPixel.x <= maximum && perPixel.y <= maximum;
}

/// Returns the number of vertically adjacent pixels per invocation. For fields with relief, the number is
/// 1. Relief needs eight more means over up to 42 elements along each axis, and some drivers silently end a
/// loop after 65,535 iterations.
int rowsFor(const sim::Field& field) {
  return hasRelief(field) ? 1 : rowsAtOnce();
}

}  // namespace

int FieldPass::reductionFor(glm::ivec2 cells, glm::dvec2 perPixel) {
  const double under = std::min(std::min(perPixel.x, perPixel.y), 2.0 * FieldKernel::maxReduction);
  const int wanted = std::max(1, static_cast<int>(under / 2));
  const int min = (std::max(cells.x, cells.y) + maxTexels - 1) / maxTexels;
  // If a reduced field would exceed `maxTexels`, the cells are read directly.
  return wanted < min ? 1 : wanted;
}

void FieldPass::prepare(const sim::Drawables& drawables, double seconds) {
  if (cached_.size() != drawables.fields.size()) cached_ = std::vector<Cached>(drawables.fields.size());
  for (std::size_t i = 0; i < cached_.size(); ++i)
    if (shown(drawables.fields[i], seconds)) reduce(drawables.fields[i], cached_[i], seconds);
}

void FieldPass::reduce(const sim::Field& field, Cached& cached, double seconds) {
  cached.colors.update(*field.colors);
  const int reduction =
      reductionFor(field.size, fieldView(*field.display, field.size, picture_, seconds).perPixel);
  const bool colored = averagesLight(field);
  const bool same =
      cached.cells == field.size && cached.reduction == reduction && cached.colored == colored;
  cached.cells = field.size;
  cached.reduction = reduction;
  cached.colored = colored;
  if (reduction == 1) return;
  if (!same || !cached.reduced) cached.reduced = FieldKernel::texture(field, reduction, colored, 1);
  kernel_.average(field, cached.colors, cached.reduced, colored);
}

namespace {

/// Returns the indices of the fields in drawing order. This is the scene order, except that decorations
/// come last, above the other fields.
std::vector<std::size_t> decorationsLast(const sim::Drawables& drawables) {
  std::vector<std::size_t> order(drawables.fields.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t i) { return !drawables.fields[i].decoration; });
  return order;
}

}  // namespace

void FieldPass::draw(const sim::Drawables& drawables, FieldLayer layer, double seconds) {
  SIMREEL_CHECK(!exact_);
  for (const std::size_t i : decorationsLast(drawables)) {
    const sim::Field& field = drawables.fields[i];
    if (shown(field, seconds) && field.display->layer == layer) drawOne(field, cached_.at(i), seconds);
  }
}

FieldDrawVariant FieldPass::variant(const sim::Field& field, const Cached& cached, double seconds) const {
  const bool over = field.display->layer == FieldLayer::over;
  FieldDrawVariant all{.field = fieldVariant(field, cached.colored),
                       .reduced = cached.reduction > 1,
                       .over = over,
                       // OPAQUE avoids reading the picture that the field hides. Software drivers would
                       // read the picture even in a branch that is not taken.
                       .opaque = exact_ && over && field.display->opacity.at(seconds) >= 1,
                       .magnified = isMagnified(field, cached.reduction, picture_, seconds, 1),
                       .splined = isSplined(field),
                       .fine = isMagnified(field, cached.reduction, picture_, seconds, 0.5),
                       .tiled = field.display->tiled,
                       .relief = hasRelief(field)};
  if (exact_) all.rows = rowsFor(field);
  return all;
}

ShownField FieldPass::shownAs(const sim::Field& field, const Cached& cached, const FieldView& view,
                              double seconds) {
  const sim::FieldDisplay& display = *field.display;
  const bool reduced = cached.reduction > 1;
  const FieldPlace place = fieldPlace(
      field, view, reduced ? glm::ivec2(cached.reduced.width(), cached.reduced.height()) : field.size);
  return {.field = fieldInputs(field, cached.colors),
          .reduced = reduced ? gl::Resource(cached.reduced) : gl::Resource(),
          .size = place.size,
          .base = place.base,
          .start = place.start,
          .perPixel = place.perPixel,
          .slope = place.slope,
          .border = display.border,
          .opacity = display.opacity.at(seconds)};
}

void FieldPass::drawOne(const sim::Field& field, const Cached& cached, double seconds) {
  const FieldView view = fieldView(*field.display, field.size, picture_, seconds);
  const gl::Defines defines = gl::with({}, variant(field, cached, seconds));
  gl::Program& shader = programs_[defines];
  if (!shader)
    shader = gl::Program::graphics("draw/overlay/field.vert", "draw/overlay/field.frag", defines);
  DrawState{.depthTest = false}.set();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl::give(shader, shownAs(field, cached, view, seconds));
  shader.set("part", glm::vec4(view.part));
  shader.set("picture", glm::vec2(picture_));
  shader.set("topFirst", static_cast<int>(field.display->layer == FieldLayer::over));
  shader.use();
  vertices_.bind();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void FieldPass::drawOver(const sim::Drawables& drawables, double seconds, const gl::Texture& picture) {
  SIMREEL_CHECK(exact_);
  for (const std::size_t i : decorationsLast(drawables)) {
    const sim::Field& field = drawables.fields[i];
    if (shown(field, seconds) && field.display->layer == FieldLayer::over)
      drawOneExactly(field, cached_.at(i), seconds, picture, -1);
  }
}

void FieldPass::drawBehind(const sim::Drawables& drawables, double seconds, const gl::Texture& light,
                           bool topFirst) {
  SIMREEL_CHECK(exact_);
  // Each field is drawn behind everything drawn so far, so the last field of the scene is drawn first.
  for (std::size_t i = drawables.fields.size(); i-- > 0;) {
    const sim::Field& field = drawables.fields[i];
    if (shown(field, seconds) && field.display->layer == FieldLayer::behind)
      drawOneExactly(field, cached_.at(i), seconds, light, topFirst ? -1 : picture_.y - 1);
  }
}

void FieldPass::drawOneExactly(const sim::Field& field, const Cached& cached, double seconds,
                               const gl::Texture& target, int lastRow) {
  const FieldView view = fieldView(*field.display, field.size, picture_, seconds);
  const glm::ivec4 part(
      glm::clamp(view.part, glm::dvec4(0), glm::dvec4(picture_.x, picture_.y, picture_.x, picture_.y)));
  const int rows = rowsFor(field);
  kernels_.of(variant(field, cached, seconds))
      .dispatch(glm::ivec2(part.z - part.x, (part.w - part.y + rows - 1) / rows),
                {.shown = shownAs(field, cached, view, seconds),
                 .target = target,
                 .part = part,
                 .lastRow = lastRow});
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
