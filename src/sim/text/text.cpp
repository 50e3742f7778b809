#include "sim/text/text.hpp"

#include "base/error.hpp"
#include "sim/core/kind.hpp"
#include "sim/core/moments.hpp"
#include "sim/mesh/buffers.hpp"
#include "sim/ports/measured.hpp"
#include "sim/text/parameters.hpp"
#include "sim/text/solid_text.hpp"

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/common.hpp>

namespace simreel::sim {

namespace {

/// Text in the world or over the picture. It has no state, but its content may change with the frame.
class Text : public Simulation {
 public:
  Text(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        parameters_(parametersOf<TextParameters>(object)),
        material_(object.material),
        content_(parameters_.text),
        font_(parameters_.fontFile()),
        perFrame_(1.0 / setting.frameSeconds),
        measured_(QuantityReader(setting.links, object)),
        time_(setting.startTime) {
    check(name_, font_, content_);
  }

  /// Throws UserError(usage) for characters that the font does not have.
  static void check(const std::string& name, const Font& font, const TextContent& content) {
    try {
      checkWritable(font, content.alphabet());
    } catch (const UserError& error) {
      fail(error.code(), "text \"{}\": {}", name, error.what());
    }
  }

  void step(double time, const StepWatch& /*watch*/) override { time_ = time + 1.0 / perFrame_; }
  void resumed(double time) override { time_ = time; }

  [[nodiscard]] double jumpedBy(double time) const override {
    return lastJump(time, parameters_.position, parameters_.rotation, parameters_.scale);
  }

  void publish(double time, Drawables& drawables) const override {
    say(time);
    if (parameters_.onScreen) {
      const ScreenText& screen = parameters_.screen;
      Writing writing;
      writing.outlines = &lines_;
      writing.place = {screen.x.at(time), screen.y.at(time)};
      writing.height = screen.height.at(time);
      writing.color = screen.color.at(time);
      writing.opacity = screen.opacity.at(time);
      writing.backdrop = screen.backdrop.at(time);
      drawables.writings.push_back(writing);
      return;
    }
    if (!buffers_) return;
    Surface surface = buffers_->surface();
    surface.model = parameters_.model(time);
    surface.doubleSided = parameters_.depth == 0;
    surface.material = &material_;
    drawables.surfaces.push_back(surface);
  }

  [[nodiscard]] std::optional<MeshTable> mesh() const override {
    if (parameters_.onScreen) return std::nullopt;
    say(time_);
    MeshTable table = buffers_ ? buffers_->table(parameters_.model(time_)) : MeshTable{};
    table.doubleSided = parameters_.depth == 0;
    return table;
  }

 private:
  /// Rebuilds the drawn geometry if the text has changed.
  void say(double time) const {
    std::string now = content_.at(std::lround(time * perFrame_), time, measured_);
    if (now == said_) return;
    said_ = std::move(now);
    const TextOutlines outlines =
        written(font_, *said_, parameters_.anchor, static_cast<double>(parameters_.spacing));
    if (parameters_.onScreen) {
      lines_.clear();
      for (const auto& polygon : outlines) lines_.emplace_back(polygon.begin(), polygon.end());
      return;
    }
    const Mesh mesh = solidText(outlines, static_cast<double>(parameters_.height),
                                static_cast<double>(parameters_.depth));
    buffers_.reset();
    if (!mesh.indices.empty()) buffers_.emplace(name_, mesh);
  }

  std::string name_;
  TextParameters parameters_;
  scene::Material material_;
  TextContent content_;
  mutable Font font_;
  double perFrame_;
  TextContent::Measured measured_;
  double time_;  ///< time of the current frame in seconds
  mutable std::optional<std::string> said_;
  mutable std::optional<MeshBuffers> buffers_;
  mutable std::vector<std::vector<glm::vec2>> lines_;
};

void checkText(const scene::Object& object, const Setting& /*setting*/) {
  const auto& parameters = parametersOf<TextParameters>(object);
  const Font font(parameters.fontFile());
  Text::check(object.name, font, TextContent(parameters.text));
}

}  // namespace

SimulationKind textKind() {
  return kindOf<TextParameters>("text",
                                "Words and numbers, as solid letters in the world or over the picture.",
                                checkText, makeSimulation<Text>);
}

}  // namespace simreel::sim
