#include "draw/overlay/axes_pass.hpp"

#include "base/error.hpp"
#include "draw/overlay/field_view.hpp"
#include "draw/overlay/text_boxes.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace simreel::draw {

namespace {

constexpr glm::vec3 groundColor(0.045F, 0.047F, 0.060F);  // colours of the axes' background and letters,
                                                          // sRGB-encoded
constexpr glm::vec3 letterColor(0.80F, 0.82F, 0.86F);

/// A list of rectangles of one colour. Each entry has the edges left, top, right, bottom, followed by the
/// colour.
class Boxes {
 public:
  Boxes(std::vector<glm::vec4>& boxes, int unit) : boxes_(boxes), unit_(unit) {}
  void fill(glm::vec4 box, glm::vec3 color) {
    boxes_.push_back(box);
    boxes_.emplace_back(color, 1.0F);
  }
  void text(const std::string& text, glm::ivec2 at) {
    for (const glm::vec4& box : textBoxes(text, at, unit_)) fill(box, letterColor);
  }
  [[nodiscard]] glm::ivec2 size(const std::string& text) const { return textSize(text, unit_); }

 private:
  std::vector<glm::vec4>& boxes_;
  int unit_;
};

struct Decade {
  int exponent;
  double value;  ///< 10^exponent, correctly rounded from 1e-22 to 1e22
};

/// Returns the largest power of ten that is at most x; x > 0.
Decade decadeBelow(double x) {
  Decade decade{0, 1.0};
  double power = 1.0;
  const auto further = [&] { return decade.exponent < 300 && decade.exponent > -300; };
  while (power * 10.0 <= x && further()) decade = {decade.exponent + 1, power *= 10.0};
  while (decade.value > x && further()) decade = {decade.exponent - 1, 1.0 / (power *= 10.0)};
  return decade;
}

}  // namespace

std::vector<Tick> ticksBetween(double first, double last, int max) {
  const double span = std::abs(last - first);
  if (!(span > 0) || max < 1) return {};
  const double min = span / max;
  const double ten = decadeBelow(min).value;
  double step = 10 * ten;
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * ten >= min * (1 - 1e-9)) {
      step = factor * ten;
      break;
    }
  const int digits = std::max(0, -decadeBelow(step * (1 + 1e-9)).exponent);
  const double low = std::min(first, last);
  const double hair = 1e-4 * step;  // tolerance for the rounding of the ends, which are floats
  std::vector<Tick> ticks;
  for (double i = std::ceil((low - hair) / step); i * step <= low + span + hair; ++i)
    ticks.push_back({(i * step - first) / (last - first), fmt::format("{:.{}f}", i * step + 0.0, digits)});
  return ticks;
}

void AxesPass::append(const sim::Field& field, double seconds, std::vector<glm::vec4>& boxes) const {
  const sim::FieldDisplay& display = *field.display;
  const glm::ivec2 margin = axesMargin(display, picture_);
  if (margin == glm::ivec2(0)) return;
  const int u = letterUnit(picture_);
  const FieldView view = fieldView(display, field.size, picture_, seconds);
  const glm::ivec4 part(view.part);
  Boxes out(boxes, u);
  out.fill(glm::vec4(part.x - margin.x, part.y, part.x, part.w), groundColor);
  out.fill(glm::vec4(part.x - margin.x, part.w, part.z, part.w + margin.y), groundColor);
  // Returns the value at a pixel, interpolated linearly between the centres of the first and the last cell.
  const auto valueAt = [&](const sim::FieldDisplay::Axis& axis, int i, int pixel) {
    const double cell = view.origin[i] + pixel * view.perPixel[i] - 0.5;
    const auto first = static_cast<double>(axis.first.at(seconds));
    return first + (static_cast<double>(axis.last.at(seconds)) - first) * cell / (field.size[i] - 1);
  };
  if (display.across) {
    const int length = part.z - part.x;
    for (const Tick& tick : ticksBetween(valueAt(*display.across, 0, part.x),
                                         valueAt(*display.across, 0, part.z), length / (60 * u))) {
      const int x = part.x + static_cast<int>(std::lround(tick.place * length));
      const int wide = out.size(tick.label).x;
      out.fill(glm::vec4(x - u / 2, part.w, x - u / 2 + u, part.w + 4 * u), letterColor);
      out.text(tick.label, {std::clamp(x - wide / 2, part.x, part.z - wide - 2 * u), part.w + 6 * u});
    }
    const int wide = out.size(display.across->name).x;
    out.text(display.across->name, {part.x + (length - wide) / 2, part.w + 19 * u});
  }
  if (display.down) {
    const int length = part.w - part.y;
    for (const Tick& tick : ticksBetween(valueAt(*display.down, 1, part.y),
                                         valueAt(*display.down, 1, part.w), length / (40 * u))) {
      const int y = part.y + static_cast<int>(std::lround(tick.place * length));
      const glm::ivec2 size = out.size(tick.label);
      out.fill(glm::vec4(part.x - 4 * u, y - u / 2, part.x, y - u / 2 + u), letterColor);
      // Limits the position so that the name in the corner has room.
      const int top = std::clamp(y - size.y / 2 + u, part.y + 2 * u, part.w - size.y);
      out.text(tick.label, {part.x - 6 * u - size.x, top});
    }
    // Writes the name below the corner. A name such as "k, kill rate" takes two lines.
    const std::string& name = display.down->name;
    const std::size_t comma = name.find(", ");
    out.text(name.substr(0, comma), {part.x - margin.x + 4 * u, part.w + 6 * u});
    if (comma != std::string::npos)
      out.text(name.substr(comma + 2), {part.x - margin.x + 4 * u, part.w + 19 * u});
  }
}

std::vector<glm::vec4> AxesPass::boxesOf(const sim::Drawables& drawables, double seconds) const {
  std::vector<glm::vec4> boxes;
  for (const sim::Field& field : drawables.fields)
    if (field.display != nullptr && field.display->layer == sim::FieldDisplay::Layer::over)
      append(field, seconds, boxes);
  return boxes;
}

void AxesPass::draw(const sim::Drawables& drawables, double seconds, const gl::Texture& picture) {
  SIMREEL_CHECK(exact_);
  const std::vector<glm::vec4> boxes = boxesOf(drawables, seconds);
  if (boxes.empty()) return;
  list_.paint(boxes, picture);
  imageBarrier();
}

void AxesPass::draw(const sim::Drawables& drawables, double seconds) {
  SIMREEL_CHECK(!exact_);
  std::vector<glm::vec4> boxes = boxesOf(drawables, seconds);
  if (boxes.empty()) return;
  if (!program_)
    program_ = gl::Program::graphics("draw/overlay/chart_text.vert", "draw/overlay/chart_text.frag");
  if (boxes != present_) {
    buffer_ = gl::Buffer::of<glm::vec4>("scales", boxes);
    view_ = gl::Texture::view("scales", GL_RGBA32F, buffer_);
    present_ = std::move(boxes);
  }
  DrawState{.depthTest = false}.set();
  program_.set("picture", glm::vec2(picture_));
  program_.use();
  view_.bind(boxUnit);
  vertices_.bind();
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(present_.size() / 2 * 6));
}

}  // namespace simreel::draw
