#include "sim/scale_bar/scale_bar.hpp"

#include "base/error.hpp"
#include "base/ieee.hpp"
#include "sim/grid/field_view.hpp"
#include "sim/ports/field_source.hpp"
#include "sim/ports/shown_picture.hpp"
#include "sim/scale_bar/parameters.hpp"
#include "sim/text/letters/layout.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

/// Throws UserError(usage) for characters that the font does not have.
void checkScaleBar(const scene::Object& object, const Setting& /*setting*/) {
  const auto& parameters = parametersOf<ScaleBarParameters>(object);
  const Font font(parameters.fontFile());
  try {
    checkWritable(font, parameters.unit);
  } catch (const UserError& error) {
    fail(error.code(), "scaleBar \"{}\": {}", object.name, error.what());
  }
}

/// Returns the distance in metres from the camera to its target; negative if it is known only after
/// simulating.
double targetDistance(const scene::Camera& camera, double time) {
  if (camera.gltf) return static_cast<double>(camera.gltf->distance);
  if (camera.orbit) return static_cast<double>(camera.orbit->distance.at(time));
  if (camera.follow || camera.track || camera.damping > 0) return -1;
  return glm::distance(glm::dvec3(camera.position.at(time)), glm::dvec3(camera.target.at(time)));
}

/// Bar with end marks and a number, drawn over the picture. It has no state.
class ScaleBar : public Simulation {
 public:
  ScaleBar(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        parameters_(parametersOf<ScaleBarParameters>(object)),
        links_(setting.links),
        font_(parameters_.fontFile()) {
    checkScaleBar(object, setting);
  }

  void step(double /*time*/, const StepWatch& /*watch*/) override {}

  void publish(double time, Drawables& drawables) const override {
    const glm::ivec2 picture = shownPicture(links_).size;
    const double perPixel = parameters_.of.empty() ? cameraScale(time) : fieldScale(time, picture);
    const ScaleLength length =
        parameters_.length
            ? givenLength(*parameters_.length, parameters_.unit)
            : roundLength(perPixel * static_cast<double>(parameters_.most) * picture.x, parameters_.unit);
    write(length.length / perPixel, length.text, picture);
    Writing writing;
    writing.outlines = &outlines_;
    writing.place = parameters_.corner;
    writing.height = parameters_.height;
    writing.color = parameters_.color;
    writing.backdrop = parameters_.backdrop;
    drawables.writings.push_back(writing);
  }

 private:
  /// Returns the size of a pixel in the display of the field, in the unit of the bar.
  [[nodiscard]] double fieldScale(double time, glm::ivec2 picture) const {
    Field found = fieldNamed(*links_, parameters_.of);
    Drawables drawables;
    links_->simulation(PartName(parameters_.of).object)->publish(links_->now(), drawables);
    for (const Field& other : drawables.fields)
      if (found.display == nullptr && other.display != nullptr && other.size == found.size)
        found.display = other.display;
    if (found.display == nullptr || found.display->layer == FieldDisplay::Layer::none)
      fail(ExitCode::usage, "scaleBar \"{}\": \"{}\" is not displayed over the picture; leave out \"of\"",
           name_, parameters_.of);
    return parameters_.cell * fieldView(*found.display, found.size, picture, time).perPixel.x;
  }

  /// Returns the size of a pixel in metres, at the distance of the camera's target.
  [[nodiscard]] double cameraScale(double time) const {
    const ShownPicture picture = shownPicture(links_);
    if (picture.camera == nullptr) return 1;
    const scene::Camera& camera = *picture.camera;
    if (camera.projection == scene::Projection::orthographic)
      return static_cast<double>(camera.height.at(time)) / picture.size.y;
    const double distance = targetDistance(camera, time);
    if (distance < 0)
      fail(ExitCode::usage,
           "scaleBar \"{}\": the distance to the target of a camera with \"follow\", \"track\" or "
           "\"damping\" is not known before it is drawn; take an orthographic camera, or an orbit",
           name_);
    constexpr double radiansPerDegree = 0.017453292519943295;
    const double half = 0.5 * radiansPerDegree * static_cast<double>(camera.fieldOfView.at(time));
    return 2 * distance * ieee::tan(half) / picture.size.y;
  }

  /// Adds the bar, which is `pixels` long from end to end, and the number above its centre.
  void write(double pixels, const std::string& text, glm::ivec2 picture) const {
    constexpr float thick = 0.16F, tall = 0.62F, gap = 0.55F;
    const double unit = static_cast<double>(parameters_.height) * picture.y;
    const auto wide = static_cast<float>(pixels / unit);
    // A single outline forms the bar with an upright mark at each end; the marks are inside the length.
    outlines_ = {{{0, 0},
                  {wide, 0},
                  {wide, tall},
                  {wide - thick, tall},
                  {wide - thick, thick},
                  {thick, thick},
                  {thick, tall},
                  {0, tall}}};
    for (const auto& polygon :
         written(font_, text, {TextAnchor::Across::center, TextAnchor::Down::baseline}, 1)) {
      auto& moved = outlines_.emplace_back();
      for (const glm::dvec2& point : polygon)
        moved.push_back(glm::vec2(0.5F * wide, gap) + glm::vec2(point));
    }
  }

  std::string name_;
  ScaleBarParameters parameters_;
  const Links* links_;
  mutable Font font_;
  mutable std::vector<std::vector<glm::vec2>> outlines_;
};

}  // namespace

SimulationKind scaleBarKind() {
  return kindOf<ScaleBarParameters>("scaleBar", "A bar of a round length with its number, as on a map.",
                                    checkScaleBar, makeSimulation<ScaleBar>);
}

}  // namespace simreel::sim
