#include "draw/overlay/axes_pass.hpp"

#include "base/error.hpp"
#include "draw/overlay/field_view.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace simreel::draw {

namespace {

constexpr glm::vec3 groundColor(0.045F, 0.047F, 0.060F);  // colours of the axes' background and ticks,
                                                          // sRGB-encoded
constexpr glm::vec3 letterColor(0.80F, 0.82F, 0.86F);
constexpr glm::vec3 letterLight(0.604F, 0.639F, 0.711F);  // letter colour as linear RGB

/// A text of an axis. `at` is a point at the top of the text's capitals, at the fraction `aligned` of the
/// text's width. If `minimum` and `maximum` differ, the text stays between these pixel positions.
struct AxisText {
  std::string text;
  glm::vec2 at;
  float aligned = 0;
  float minimum = 0, maximum = 0;
};

/// Rectangles (each as its edges left, top, right, bottom, followed by its colour) and texts of the axes of
/// one field.
struct AxisParts {
  std::vector<glm::vec4> boxes;
  std::vector<AxisText> texts;

  void fill(glm::vec4 box, glm::vec3 color) {
    boxes.push_back(box);
    boxes.emplace_back(color, 1.0F);
  }
};

struct Decade {
  int exponent;
  double value;  ///< value of 10^exponent, correctly rounded from 1e-22 to 1e22
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
  const double hair = 1e-4 * step;  // tolerance for the rounding of the axis ends, which are floats
  std::vector<Tick> ticks;
  for (double i = std::ceil((low - hair) / step); i * step <= low + span + hair; ++i)
    ticks.push_back({(i * step - first) / (last - first), fmt::format("{:.{}f}", i * step + 0.0, digits)});
  return ticks;
}

namespace {

constexpr float axisCapital = 7.5F;  // height of a capital, in letter units

/// Adds the axis below the field.
void addAcross(AxisParts& out, const sim::FieldDisplay& display, glm::ivec4 part, double first, double last,
               int u) {
  const int length = part.z - part.x;
  for (const Tick& tick : ticksBetween(first, last, length / (60 * u))) {
    const int x = part.x + static_cast<int>(std::lround(tick.place * length));
    out.fill(glm::vec4(x - u / 2, part.w, x - u / 2 + u, part.w + 4 * u), letterColor);
    out.texts.push_back({tick.label,
                         {x, part.w + 6 * u},
                         0.5F,
                         static_cast<float>(part.x),
                         static_cast<float>(part.z - 2 * u)});
  }
  out.texts.push_back({display.across->name, {part.x + length / 2, part.w + 19 * u}, 0.5F});
}

/// Adds the axis at the left. A name with a comma such as "k, kill rate" takes two lines in the corner
/// below.
void addDown(AxisParts& out, const sim::FieldDisplay& display, glm::ivec4 part, int margin, double first,
             double last, int u) {
  const int length = part.w - part.y;
  const int tall = static_cast<int>(std::lround(axisCapital * static_cast<float>(u)));
  for (const Tick& tick : ticksBetween(first, last, length / (40 * u))) {
    const int y = part.y + static_cast<int>(std::lround(tick.place * length));
    out.fill(glm::vec4(part.x - 4 * u, y - u / 2, part.x, y - u / 2 + u), letterColor);
    // Leaves space for the name in the corner.
    const int top = std::clamp(y - tall / 2, part.y + 2 * u, std::max(part.y + 2 * u, part.w - tall));
    out.texts.push_back({tick.label, {part.x - 6 * u, top}, 1});
  }
  const std::string& name = display.down->name;
  const std::size_t comma = name.find(", ");
  out.texts.push_back({name.substr(0, comma), {part.x - margin + 4 * u, part.w + 6 * u}});
  if (comma != std::string::npos)
    out.texts.push_back({name.substr(comma + 2), {part.x - margin + 4 * u, part.w + 19 * u}});
}

AxisParts partsOf(const sim::Field& field, glm::ivec2 picture, double seconds) {
  AxisParts out;
  const sim::FieldDisplay& display = *field.display;
  const glm::ivec2 margin = axesMargin(display, picture);
  if (margin == glm::ivec2(0)) return out;
  const int u = sim::letterUnit(picture);
  const FieldView view = fieldView(display, field.size, picture, seconds);
  const glm::ivec4 part(view.part);
  out.fill(glm::vec4(part.x - margin.x, part.y, part.x, part.w), groundColor);
  out.fill(glm::vec4(part.x - margin.x, part.w, part.z, part.w + margin.y), groundColor);
  // Returns the value at a pixel, interpolated linearly between the centres of the first and the last cell.
  const auto valueAt = [&](const sim::FieldDisplay::Axis& axis, int i, int pixel) {
    const double cell = view.origin[i] + pixel * view.perPixel[i] - 0.5;
    const auto first = static_cast<double>(axis.first.at(seconds));
    return first + (static_cast<double>(axis.last.at(seconds)) - first) * cell / (field.size[i] - 1);
  };
  if (display.across)
    addAcross(out, display, part, valueAt(*display.across, 0, part.x), valueAt(*display.across, 0, part.z),
              u);
  if (display.down)
    addDown(out, display, part, margin.x, valueAt(*display.down, 1, part.y),
            valueAt(*display.down, 1, part.w), u);
  return out;
}

/// Returns the parts of the axes of all fields drawn over the picture.
std::vector<AxisParts> partsOf(const sim::Drawables& drawables, glm::ivec2 picture, double seconds) {
  std::vector<AxisParts> all;
  for (const sim::Field& field : drawables.fields)
    if (field.display != nullptr && field.display->layer == sim::FieldDisplay::Layer::over)
      all.push_back(partsOf(field, picture, seconds));
  return all;
}

}  // namespace

std::vector<glm::vec4> AxesPass::boxesOf(const sim::Drawables& drawables, double seconds) const {
  std::vector<glm::vec4> boxes;
  for (const AxisParts& parts : partsOf(drawables, picture_, seconds))
    boxes.insert(boxes.end(), parts.boxes.begin(), parts.boxes.end());
  return boxes;
}

std::vector<sim::Writing> AxesPass::letters(const sim::Drawables& drawables, double seconds) {
  words_.forget();
  const float tall = axisCapital * static_cast<float>(sim::letterUnit(picture_));
  std::vector<sim::Writing> all;
  for (const AxisParts& parts : partsOf(drawables, picture_, seconds))
    for (const AxisText& text : parts.texts) {
      const LabelWord& word = words_.of(text.text);
      const float wide = tall * word.width;
      float left = text.at.x - text.aligned * wide;
      if (text.minimum < text.maximum) left = std::max(std::min(left, text.maximum - wide), text.minimum);
      sim::Writing& writing = all.emplace_back();
      writing.outlines = &word.outlines;
      writing.place = glm::vec2(left, text.at.y + tall) / glm::vec2(picture_);
      writing.height = tall / static_cast<float>(picture_.y);
      writing.color = letterLight;
    }
  return all;
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
