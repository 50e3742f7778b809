#include "serve/edit/brush.hpp"

#include "scene/value/value_writer.hpp"
#include "sim/fluid/parameters.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string_view>

#include <glm/geometric.hpp>

namespace simreel::serve {

namespace {

/// Fields that read the default values of an object.
class Standard final : public scene::Fields {
 public:
  std::optional<double> rate;  ///< number of simulation steps per second, if the scene leaves it out
  nlohmann::json strokes = nlohmann::json::array();

  void field(const char* name, scene::Member member, const scene::Spec& spec) override {
    if (std::string_view(name) != "stepsPerSecond") return;
    if (const auto value = scene::written(member, spec); value && value->is_number())
      rate = value->get<double>();
  }
  void section(const char* /*name*/, bool* /*present*/, const char* /*doc*/,
               const std::function<void(Fields&)>& /*describe*/) override {}
  void listOf(const char* name, const char* /*doc*/, std::size_t /*maxItems*/, std::size_t items,
              const std::function<void(std::size_t)>& resize,
              const std::function<void(Fields&, std::size_t)>& describe) override {
    if (std::string_view(name) == "strokes") strokes = scene::standardItems(items, resize, describe);
  }
  void namedGroups(const char* /*name*/, const char* /*doc*/, const char* /*one*/, std::size_t /*maxItems*/,
                   const std::vector<std::string>& /*names*/,
                   const std::function<void(const std::vector<std::string>&)>& /*rename*/,
                   const std::function<void(Fields&, std::size_t)>& /*describe*/) override {}
};

const sim::FluidParameters* fluidOf(const scene::Object& object) {
  return dynamic_cast<const sim::FluidParameters*>(object.parameters.get());
}

Standard standardOf(const scene::Object& object) {
  const std::unique_ptr<scene::Parameters> fresh = sim::simulationNamed(object.kind).kind.makeParameters();
  if (auto* fluid = dynamic_cast<sim::FluidParameters*>(fresh.get())) fluid->size = fluidOf(object)->size;
  Standard standard;
  fresh->describe(standard);
  return standard;
}

nlohmann::json pointAt(glm::dvec2 place) {
  constexpr double tenth = 10;
  return {std::round(place.x * tenth) / tenth, std::round(place.y * tenth) / tenth, 0};
}

}  // namespace

nlohmann::json strokesOf(const scene::Object& object, const nlohmann::json& given) {
  const auto found = given.find("strokes");
  return found != given.end() ? *found : standardOf(object).strokes;
}

nlohmann::json strokeOf(const scene::Object& object, const nlohmann::json& given, const BrushPiece& piece) {
  double at = piece.time;
  std::optional<double> rate = standardOf(object).rate;
  if (const auto own = given.find("stepsPerSecond"); rate && own != given.end() && own->is_number())
    rate = own->get<double>();
  if (rate) at = std::floor(at * *rate + 1e-6) / *rate;
  const bool stands = piece.from == piece.to;
  nlohmann::json stroke = {{"at", at},
                           {"shape", stands ? "circle" : "line"},
                           {"from", pointAt(piece.from)},
                           {"to", pointAt(piece.to)},
                           {"radius", piece.radius}};
  if (piece.value != 1) stroke["value"] = piece.value;
  const sim::FluidParameters* fluid = fluidOf(object);
  if (fluid == nullptr) return stroke;
  if (fluid->heats()) stroke["temperature"] = 1;
  if (fluid->dyes() || !fluid->heats()) stroke["dye"] = {1.6, 0.45, 0.01};
  if (stands) return stroke;
  constexpr double seconds = 0.12;  // seconds between two segments sent by the page
  glm::dvec2 velocity = (piece.to - piece.from) / seconds;
  const double speed = glm::length(velocity);
  velocity *= std::min(1.0, static_cast<double>(fluid->speed) / speed);
  stroke["velocity"] = pointAt(velocity);
  return stroke;
}

}  // namespace simreel::serve
