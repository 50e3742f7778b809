#include "sim/body/model_scene.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "scene/light.hpp"
#include "sim/body/figure.hpp"
#include "sim/mesh/file/builder.hpp"
#include "sim/mesh/file/mesh_file.hpp"
#include "sim/nodes/gltf_nodes.hpp"
#include "sim/nodes/sample.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

namespace simreel::sim {

namespace {

using Json = nlohmann::ordered_json;
constexpr const char* lightsName = "KHR_lights_punctual";

Json listOf(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

/// Returns a name made of the characters that a scene allows: letters, digits, '-' and '_'. The name is
/// short enough to append a suffix.
std::string plainName(const std::string& name) {
  std::string plain = name.substr(0, 56);
  for (char& c : plain)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_') c = '_';
  return plain.empty() ? "light" : plain;
}

/// Light of a file, with the position and direction given by its node.
struct FileLight {
  std::string name, type;
  glm::dvec3 position, direction;  ///< direction in which the light shines
  glm::dvec3 color{1};
  double intensity = 1;  ///< intensity in cd, or in lx for a directional light
  double range = 0;      ///< range in metres; 0 if unlimited
  double inner = 0, outer = std::numbers::pi / 4;

  /// Returns the illuminance (lx) at a point of a surface that faces the light.
  [[nodiscard]] double at(const glm::dvec3& place) const {
    if (type == "directional") return intensity;
    const glm::dvec3 way = place - position;
    return intensity / std::max(glm::dot(way, way), 1e-6);
  }
};

class ModelReader {
 public:
  ModelReader(const std::filesystem::path& file, std::string_view text)
      : file_(file), text_(text), document_(file, text), nodes_(document_) {}

  std::string scene() {
    nodes_.walk([&](const JsonValue& node, std::uint64_t /*number*/, int here) { place(node, here); });
    const std::string name = file_.filename().string();
    const FigureAnimation* animation = motion();
    // A scene without an animation has one frame.
    const double seconds = animation == nullptr ? 0.03 : animation->seconds;
    Json object = {{"mesh", {{"file", name}}}};
    if (animation != nullptr) object = {{"body", {{"file", name}, {"animation", animation->name}}}};
    Json scene = {{"version", 2}, {"title", name}, {"time", {{"fps", 30}, {"duration", seconds}}}};
    addLights(scene);
    scene["objects"] = {{"model", object}};
    return scene.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }

 private:
  void place(const JsonValue& node, int here) {
    const FigureNode& made = nodes_.nodes()[static_cast<std::size_t>(here)];
    const glm::dmat4 own =
        made.hasMatrix ? made.matrix : transformOf(made.translation, made.rotation, made.scale);
    worlds_.push_back(made.parent < 0 ? own : worlds_[static_cast<std::size_t>(made.parent)] * own);
    if (node.has("mesh")) addBounds(GltfDocument::number(node, "mesh"), worlds_.back());
    if (const auto extensions = node.find("extensions"))
      if (const auto light = extensions->find(lightsName)) readLight(*light, made.name);
  }

  /// Extends the bounds by the bounds that the accessors of a mesh state.
  void addBounds(std::size_t mesh, const glm::dmat4& world) {
    document_.item("meshes", mesh).at("primitives").eachItem([&](const JsonValue& primitive) {
      const auto attributes = primitive.find("attributes");
      if (!attributes || !attributes->has("POSITION")) return;
      const JsonValue accessor = document_.item("accessors", GltfDocument::number(*attributes, "POSITION"));
      const std::vector<float> low = GltfDocument::numbers(accessor, "min"),
                               high = GltfDocument::numbers(accessor, "max");
      if (low.size() != 3 || high.size() != 3) return;
      for (int corner = 0; corner < 8; ++corner) {
        glm::dvec4 at(1);
        for (int k = 0; k < 3; ++k)
          at[k] =
              (corner >> k & 1) == 0 ? low[static_cast<std::size_t>(k)] : high[static_cast<std::size_t>(k)];
        const glm::dvec3 placed(world * at);
        low_ = bounded_ ? glm::min(low_, placed) : placed;
        high_ = bounded_ ? glm::max(high_, placed) : placed;
        bounded_ = true;
      }
    });
  }

  void readLight(const JsonValue& use, const std::string& nodeName) {
    const auto extensions = document_.root().find("extensions");
    const auto defined = extensions ? extensions->find(lightsName) : std::nullopt;
    if (!defined) document_.refuse("has a node with a light, and no list of lights");
    const JsonValue described = defined->at("lights").at(GltfDocument::number(use, "light"));
    FileLight light;
    light.name = nodeName;
    light.type = described.at("type").text();
    if (light.type != "point" && light.type != "spot" && light.type != "directional") {
      ++dropped_;
      return;
    }
    const glm::dmat4& world = worlds_.back();
    light.position = glm::dvec3(world[3]);
    const double length = glm::length(glm::dvec3(world[2]));
    light.direction = length > 0 ? -glm::dvec3(world[2]) / length : glm::dvec3(0, -1, 0);
    const auto number = [](const JsonValue& object, const char* key, double otherwise) {
      const auto found = object.find(key);
      return found ? found->number() : otherwise;
    };
    light.intensity = std::clamp(number(described, "intensity", 1), 0.0, 1e9);
    light.range = std::clamp(number(described, "range", 0), 0.0, 1e6);
    if (const std::vector<float> c = GltfDocument::numbers(described, "color", 3); !c.empty())
      light.color = glm::clamp(glm::dvec3(c[0], c[1], c[2]), 0.0, 1.0);
    if (const auto spot = described.find("spot")) {
      light.inner = number(*spot, "innerConeAngle", light.inner);
      light.outer = std::clamp(number(*spot, "outerConeAngle", light.outer), 0.01, 1.5);
    }
    lights_.push_back(light);
  }

  /// Returns the first animation that moves nodes; null if none exists that a body can show.
  const FigureAnimation* motion() {
    animations_ = nodes_.animations();
    const auto found = std::find_if(animations_.begin(), animations_.end(), [](const FigureAnimation& one) {
      return !one.channels.empty() && one.seconds > 0;
    });
    if (found == animations_.end()) return nullptr;
    try {
      static_cast<void>(readFigure(file_, text_));
      return &*found;
    } catch (const UserError&) {
      return nullptr;  // in this case, a mesh shows the pose of the nodes and reports that the animation is
                       // ignored
    }
  }

  void addLights(Json& scene) {
    if (lights_.empty()) return;
    const glm::dvec3 middle = 0.5 * (low_ + high_);
    double sum = 0;
    for (const FileLight& light : lights_) sum += light.at(middle);
    constexpr double darkest = 1, brightest = 10, wanted = 5;
    const double factor = sum > 0 && (sum < darkest || sum > brightest) ? wanted / sum : 1;
    const double size = glm::length(high_ - low_);
    scene["sun"] = {{"intensity", 0}};
    bool sun = false;
    std::size_t shadows = 0;
    for (const FileLight& light : lights_) {
      const double intensity = light.intensity * factor;
      if (light.type == "directional") {
        if (sun) ++dropped_;
        if (!std::exchange(sun, true))
          scene["sun"] = {{"direction", listOf(-light.direction)},
                          {"color", listOf(light.color)},
                          {"intensity", intensity}};
        continue;
      }
      if (scene["lights"].size() + 1 >= scene::maxLights) {  // The stage adds one light to the lights of
                                                             // the file.
        ++dropped_;
        continue;
      }
      Json made = {{"type", light.type},
                   {"position", listOf(light.position)},
                   {"color", listOf(light.color)},
                   {"intensity", intensity},
                   {"radius", std::clamp(0.01 * size, 1e-3, 10.0)},
                   {"glow", 0},
                   {"shadow", shadows++ + 1 < scene::maxShadowedLights}};
      if (light.range > 0) made["range"] = light.range;
      if (light.type == "spot") {
        constexpr double degrees = 180 / std::numbers::pi;
        made["spot"] = {{"target", listOf(light.position + light.direction)},
                        {"angle", 2 * light.outer * degrees},
                        {"softness", std::clamp(1 - light.inner / light.outer, 0.0, 1.0)}};
      }
      const std::string plain = plainName(light.name);
      std::string name = plain;
      for (int i = 2; name == "rim" || scene["lights"].contains(name); ++i)
        name = fmt::format("{}_{}", plain, i);
      scene["lights"][name] = made;
    }
    if (scene["lights"].empty()) scene.erase("lights");
    if (dropped_ > 0)
      warn(
          "{}: {} of its lights are not drawn: a scene has one directional light and {} others, point or "
          "spot",
          file_.string(), dropped_, scene::maxLights - 1);
  }

  const std::filesystem::path& file_;
  std::string_view text_;
  GltfDocument document_;
  GltfNodes nodes_;
  std::vector<FigureAnimation> animations_;
  std::vector<glm::dmat4> worlds_;  ///< world transform of each node
  std::vector<FileLight> lights_;
  int dropped_ = 0;              ///< number of lights left out because a scene does not support them
  glm::dvec3 low_{0}, high_{0};  ///< bounds of the meshes
  bool bounded_ = false;
};

}  // namespace

std::string sceneAroundModel(const std::filesystem::path& file) {
  if (!isGltf(file) || !pathExists(file)) return {};
  return readInSeparateProcess(file, [&] {
    const std::string text = readFile(file, "mesh");
    try {
      return ModelReader(file, text).scene();
    } catch (const JsonError& error) {
      refuseMesh(file, fmt::format("is not valid glTF: {}", error.what()));
    }
  });
}

}  // namespace simreel::sim
