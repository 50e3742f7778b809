#include "sim/text/parameters.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "sim/core/collider.hpp"
#include "sim/core/moments.hpp"
#include "sim/ports/measured.hpp"

#include <stdexcept>

#include <fmt/format.h>
#include <glm/vec4.hpp>

namespace simreel::sim {

namespace {

/// Returns the parsed text, or nullopt if it is malformed, which describe() reports.
std::optional<TextContent> readContent(const std::string& text) {
  try {
    return TextContent(text);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace

void ScreenText::describe(scene::Fields& f) {
  f.number("x", x, {-10, 10}, "", "Where its anchor is: fraction of the picture's width, from the left.");
  f.number("y", y, {-10, 10}, "",
           "Place of its anchor as a fraction of the picture's height, from the top.");
  f.number("height", height, {0.001, 10}, "",
           "Height of capital letters, as a fraction of the picture's height.");
  f.color("color", color, scene::notNegative, "Linear RGB; it is not tone mapped.");
  f.leftOut("color", "[1,1,1], or dark on a bright stage");
  colored = f.given("color");
  f.number("opacity", opacity, scene::fraction, "", "Opacity; 0: invisible.");
  f.number("backdrop", backdrop, scene::fraction, "", "Opacity of a dark panel behind it.");
}

void TextParameters::describe(scene::Fields& f) {
  f.text("text", text,
         "Words in UTF-8; \"\\n\" begins a line. {frame}, {time} (s) and {OBJECT.QUANTITY} stand for "
         "numbers, {time:1} for a number with one digit after the point; \"{{\" is a brace.");
  f.asset("font", font, "A TrueType or OpenType file.");
  f.leftOut("font", "Open Sans, which ships with simreel");
  f.choice("weight", weight, {"regular", "bold"}, "Weight of the shipped font.");
  if (f.given("font") && f.given("weight"))
    f.error("weight",
            "\"weight\" works only with the shipped font; leave it out with a \"font\" of your own");
  f.choice("align", anchor.across, {"left", "center", "right"},
           "Point of each line that lies at its place, horizontally.");
  f.leftOut("align", "\"center\", or \"left\" on the screen");
  f.choice("vertical", anchor.down, {"baseline", "top", "middle", "bottom"},
           "Height of the text that lies at its place: the first baseline, the top of its capitals, the "
           "middle, or the last baseline.");
  f.leftOut("vertical", "\"baseline\", or \"top\" on the screen");
  f.number("spacing", spacing, {0, 100}, "", "Distance of lines, as a factor on the font's own.");
  f.number("height", height, {1e-4, 1e4}, "m", "Height of capital letters.");
  f.number("depth", depth, {0, 1e4}, "m", "Thickness of the letters; 0: flat, seen from both sides.");
  f.vector("position", position, scene::anyNumber, "m", "Where its anchor is.");
  f.leftOut("position", "[0,0,0]; in version 2 above the other objects");
  placed = f.given("position");
  f.vector("rotation", rotation, scene::anyNumber, "degrees", "About x, then y, then z.");
  f.number("scale", scale, {1e-6, 1e6}, "", "Factor on its size.");
  f.optionalGroup("screen", onScreen,
                  "Places the text over the picture instead of in the world, sharp, in one colour.",
                  [&](scene::Fields& inner) { screen.describe(inner); });
  for (const char* name : {"height", "depth", "position", "rotation", "scale"})
    if (onScreen && f.given(name))
      f.error(name,
              fmt::format("\"{}\" is only for text in the world; leave it out with \"screen\"", name));
  if (onScreen && !f.given("align")) anchor.across = TextAnchor::Across::left;
  if (onScreen && !f.given("vertical")) anchor.down = TextAnchor::Down::top;
  constexpr std::size_t longest = 4096;
  if (text.size() > longest)
    f.error("text", fmt::format("{} bytes of text; {} at most", text.size(), longest));
  if (!isUtf8(text)) f.error("text", "the text is not UTF-8");
  try {
    static_cast<void>(TextContent(text));
  } catch (const std::invalid_argument& mistake) {
    f.error("text", mistake.what());
  }
}

void TextParameters::standAbove(const scene::Box& others) {
  if (onScreen || placed) return;
  const std::optional<scene::Box> own = framed();
  if (!own) return;
  const glm::vec3 foot(0.5F * (own->min.x + own->max.x), own->min.y, 0.5F * (own->min.z + own->max.z));
  const glm::vec3 top(0.5F * (others.min.x + others.max.x), others.max.y + 0.5F * height,
                      0.5F * (others.min.z + others.max.z));
  position = position.at(0) + top - foot;
}

void TextParameters::ports(Ports& ports) const {
  const std::optional<TextContent> content = readContent(text);
  if (!content) return;
  for (const TextContent::Part& part : content->parts())
    if (part.number == TextContent::Part::Number::quantity)
      ports.requireFrom<Measured>(part.object + "." + part.quantity, {"text"});
}

void TextParameters::ink(const glm::vec3& color) {
  const bool onPanel = screen.backdrop.moves() || screen.backdrop.at(0) > 0;
  if (onScreen && !screen.colored && !onPanel) screen.color = color;
}

std::filesystem::path TextParameters::fontFile() const {
  if (!font.empty()) return font;
  return assetFolder() / "fonts" / (weight == Weight::bold ? "OpenSans-Bold.ttf" : "OpenSans-Regular.ttf");
}

glm::mat4 TextParameters::model(double seconds) const {
  glm::mat4 matrix = rotationMatrix(rotation.at(seconds));
  for (int i = 0; i < 3; ++i) matrix[i] *= scale.at(seconds);
  matrix[3] = glm::vec4(position.at(seconds), 1.0F);
  return matrix;
}

std::optional<scene::Box> TextParameters::framed() const {
  if (onScreen) return std::nullopt;
  TextOutlines outlines;
  const std::optional<TextContent> content = readContent(text);
  if (!content) return std::nullopt;
  try {
    Font file(fontFile());
    outlines = written(file, content->at(0, 0, [](const auto&, const auto&) { return 0.0; }), anchor,
                       static_cast<double>(spacing));
  } catch (const UserError&) {
    return std::nullopt;
  }
  std::optional<scene::Box> own, box;
  for (const auto& polygon : outlines)
    for (const glm::dvec2& point : polygon) {
      const glm::vec2 at = height * glm::vec2(point);
      scene::include(own, glm::vec3(at, -0.5F * depth));
      scene::include(own, glm::vec3(at, 0.5F * depth));
    }
  if (!own) return std::nullopt;
  for (const double seconds : momentsOf(position, rotation, scale))
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 at((corner & 1) != 0 ? own->max.x : own->min.x,
                         (corner & 2) != 0 ? own->max.y : own->min.y,
                         (corner & 4) != 0 ? own->max.z : own->min.z);
      scene::include(box, glm::vec3(model(seconds) * glm::vec4(at, 1.0F)));
    }
  return box;
}

}  // namespace simreel::sim
