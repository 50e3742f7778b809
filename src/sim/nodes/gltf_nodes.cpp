#include "sim/nodes/gltf_nodes.hpp"

#include "sim/mesh/file/builder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

namespace simreel::sim {

namespace {

constexpr std::size_t maxNodes = 16'384;
constexpr std::size_t maxKeys = 4'000'000;  ///< maximum number of keys in all animations

std::string nodeLabelOf(const JsonValue& object, const char* kind, std::size_t number) {
  std::string name = textIfThere(object, "name");
  return name.empty() ? fmt::format("{} {}", kind, number) : name;
}

FigureNode nodeOf(const JsonValue& node, std::size_t number, int parent) {
  FigureNode made;
  made.name = nodeLabelOf(node, "node", number);
  made.parent = parent;
  const std::vector<float> matrix = GltfDocument::numbers(node, "matrix", 16);
  made.hasMatrix = !matrix.empty();
  if (made.hasMatrix) made.matrix = glm::dmat4(glm::make_mat4(matrix.data()));
  if (const auto t = GltfDocument::numbers(node, "translation", 3); !t.empty())
    made.translation = {t[0], t[1], t[2]};
  if (const auto s = GltfDocument::numbers(node, "scale", 3); !s.empty()) made.scale = {s[0], s[1], s[2]};
  const std::array<double, 4> q = GltfDocument::rotation(node);
  made.rotation = glm::dquat(q[3], q[0], q[1], q[2]);
  return made;
}

}  // namespace

void GltfNodes::walk(const Visit& visit) {
  struct Step {
    std::uint64_t node;
    int parent, depth;
  };
  std::vector<Step> open;
  for (const std::uint64_t node : document_.rootNodes()) open.push_back({node, -1, 0});
  place_.assign(document_.size("nodes"), -1);
  while (!open.empty()) {
    const Step step = open.back();
    open.pop_back();
    const JsonValue node = document_.item("nodes", step.node);
    if (place_[step.node] >= 0)
      document_.refuse(fmt::format("has a node with two parents (number {})", step.node));
    if (step.depth > maxNodeDepth)
      document_.refuse(fmt::format("nests its nodes deeper than {} levels", maxNodeDepth));
    const int here = place_[step.node] = static_cast<int>(nodes_.size());
    if (nodes_.size() >= maxNodes) document_.refuse(fmt::format("has more than {} nodes", maxNodes));
    nodes_.push_back(nodeOf(node, step.node, step.parent));
    visit(node, step.node, here);
    for (const std::uint64_t child : GltfDocument::wholeNumbers(node, "children"))
      open.push_back({child, here, step.depth + 1});
    if (open.size() > place_.size()) document_.refuse("has a node with two parents");
  }
}

std::vector<FigureAnimation> GltfNodes::animations() {
  std::vector<FigureAnimation> all;
  for (std::size_t i = 0; i < document_.size("animations"); ++i) {
    const JsonValue described = document_.item("animations", i);
    FigureAnimation animation;
    animation.name = nodeLabelOf(described, "animation", i);
    described.at("channels").eachItem([&](const JsonValue& channel) {
      if (auto made = channelOf(described, channel, animation.name)) {
        animation.seconds = std::max(animation.seconds, double{made->times.back()});
        animation.channels.push_back(std::move(*made));
      }
    });
    all.push_back(std::move(animation));
  }
  return all;
}

/// Returns a channel of an animation; nullopt if it moves no node of the default scene.
std::optional<FigureChannel> GltfNodes::channelOf(const JsonValue& animation, const JsonValue& channel,
                                                  const std::string& name) {
  using Path = FigureChannel::Path;
  using Interpolation = FigureChannel::Interpolation;
  const JsonValue target = channel.at("target");
  const std::string path = target.at("path").text();
  if (!target.has("node") || path == "weights" || path == "pointer") return std::nullopt;
  const std::uint64_t node = GltfDocument::number(target, "node");
  static_cast<void>(document_.item("nodes", node));
  if (placeOf(node) < 0) return std::nullopt;  // The node does not belong to the default scene.
  FigureChannel made;
  made.node = placeOf(node);
  const auto refuse = [&](const std::string& why) {
    document_.refuse(fmt::format("has an animation \"{}\" that moves \"{}\" {}", name,
                                 nodes_[static_cast<std::size_t>(made.node)].name, why));
  };
  if (path != "translation" && path != "rotation" && path != "scale")
    refuse(fmt::format("along \"{}\", which is not a property that glTF animates", path));
  if (nodes_[static_cast<std::size_t>(made.node)].hasMatrix)
    refuse("although that has a matrix; give it translation, rotation and scale");
  made.path = path == "translation" ? Path::translation : path == "rotation" ? Path::rotation : Path::scale;
  const JsonValue sampler = animation.at("samplers").at(GltfDocument::number(channel, "sampler"));
  const std::string way = textIfThere(sampler, "interpolation");
  if (!way.empty() && way != "STEP" && way != "LINEAR" && way != "CUBICSPLINE")
    refuse(fmt::format("by the interpolation \"{}\", which glTF does not define", way));
  made.way = way == "STEP"          ? Interpolation::step
             : way == "CUBICSPLINE" ? Interpolation::cubic
                                    : Interpolation::linear;
  made.times = document_.floats(GltfDocument::number(sampler, "input"), 1);
  const std::size_t width = made.path == Path::rotation ? 4 : 3;
  made.values = document_.floats(GltfDocument::number(sampler, "output"), width);
  const std::size_t expected = made.times.size() * width * (made.way == Interpolation::cubic ? 3 : 1);
  if (made.values.size() != expected)
    refuse(fmt::format("by {} values at {} times", made.values.size() / width, made.times.size()));
  for (std::size_t k = 0; k < made.times.size(); ++k)
    if (!(made.times[k] >= 0 && made.times[k] < 1e6F) || (k > 0 && made.times[k] <= made.times[k - 1]))
      refuse(fmt::format("at {} s (key {}): times must be 0 or more and increase", made.times[k], k));
  for (const float value : made.values)
    if (!(std::abs(value) < 1e9F)) refuse("to a place that is not finite");
  if ((keys_ += made.times.size()) > maxKeys)
    document_.refuse(fmt::format("has more than {} keys; sample its animations less often", maxKeys));
  return made;
}

}  // namespace simreel::sim
