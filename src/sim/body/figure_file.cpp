#include "sim/body/figure.hpp"
#include "sim/mesh/builder.hpp"
#include "sim/mesh/gltf_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

namespace simreel::sim {

namespace {

constexpr std::size_t maxNodes = 16'384;
constexpr std::size_t maxJoints = 1024;
constexpr std::size_t maxKeys = 4'000'000;  ///< of all animations

std::string nameOf(const JsonValue& object, const char* kind, std::size_t number) {
  std::string name = textIfThere(object, "name");
  return name.empty() ? fmt::format("{} {}", kind, number) : name;
}

class FigureReader {
 public:
  FigureReader(const std::filesystem::path& file, std::string_view text)
      : parts_(file, text), builder_(file) {}

  Figure read() {
    walk();
    if (skinned_ == 0)
      document().refuse("has no skin in its default scene; without bones it is a \"mesh\", not a \"body\"");
    for (const Placed& placed : placed_) parts_.count(placed.mesh);
    for (const Placed& placed : placed_) add(placed);
    figure_.mesh = builder_.finish();
    readAnimations();
    return std::move(figure_);
  }

 private:
  /// A mesh, and the joint that is the first of its skin.
  struct Placed {
    std::size_t mesh;
    std::size_t firstJoint;
    std::size_t joints;  ///< of its skin
    bool skinned;
  };

  [[nodiscard]] const GltfDocument& document() const { return parts_.document(); }

  /// The nodes of the default scene, parents first, and their meshes.
  void walk() {
    struct Step {
      std::uint64_t node;
      int parent, depth;
    };
    const JsonValue scene = document().item("scenes", GltfDocument::number(document().root(), "scene", 0));
    std::vector<Step> open;
    for (const std::uint64_t node : GltfDocument::wholeNumbers(scene, "nodes"))
      open.push_back({node, -1, 0});
    place_.assign(document().size("nodes"), -1);
    std::vector<std::pair<std::uint64_t, int>> meshes;  // their nodes, in the file and here
    while (!open.empty()) {
      const Step step = open.back();
      open.pop_back();
      const JsonValue node = document().item("nodes", step.node);
      if (place_[step.node] >= 0)
        document().refuse(fmt::format("has a node with two parents (number {})", step.node));
      if (step.depth > maxNodeDepth)
        document().refuse(fmt::format("nests its nodes deeper than {} levels", maxNodeDepth));
      const int here = place_[step.node] = static_cast<int>(figure_.nodes.size());
      if (figure_.nodes.size() >= maxNodes)
        document().refuse(fmt::format("has more than {} nodes", maxNodes));
      figure_.nodes.push_back(nodeOf(node, step.node, step.parent));
      if (node.has("mesh")) meshes.emplace_back(step.node, here);
      for (const std::uint64_t child : GltfDocument::wholeNumbers(node, "children"))
        open.push_back({child, here, step.depth + 1});
      if (open.size() > place_.size()) document().refuse("has a node with two parents");
    }
    for (const auto& [number, here] : meshes) {
      const JsonValue node = document().item("nodes", number);
      const std::size_t mesh = GltfDocument::number(node, "mesh");
      const bool skinned = node.has("skin");
      std::size_t first = figure_.joints.size();
      std::size_t count = 1;
      if (skinned)
        std::tie(first, count) = jointsOf(GltfDocument::number(node, "skin"));
      else
        figure_.joints.push_back({here, false, glm::dmat4(1)});
      placed_.push_back({mesh, first, count, skinned});
      skinned_ += skinned ? 1 : 0;
      if (figure_.joints.size() > maxJoints)
        document().refuse(fmt::format("has more than {} joints", maxJoints));
    }
  }

  static FigureNode nodeOf(const JsonValue& node, std::size_t number, int parent) {
    FigureNode made;
    made.name = nameOf(node, "node", number);
    made.parent = parent;
    const std::vector<float> matrix = GltfDocument::numbers(node, "matrix", 16);
    made.hasMatrix = !matrix.empty();
    if (made.hasMatrix) made.matrix = glm::dmat4(glm::make_mat4(matrix.data()));
    if (const auto t = GltfDocument::numbers(node, "translation", 3); !t.empty())
      made.translation = {t[0], t[1], t[2]};
    if (const auto s = GltfDocument::numbers(node, "scale", 3); !s.empty()) made.scale = {s[0], s[1], s[2]};
    if (const auto q = GltfDocument::numbers(node, "rotation", 4); !q.empty())
      made.rotation = glm::dquat(q[3], q[0], q[1], q[2]);
    return made;
  }

  /// The first of a skin's joints and how many it has.
  std::pair<std::size_t, std::size_t> jointsOf(std::size_t skin) {
    if (const auto known = skins_.find(skin); known != skins_.end()) return known->second;
    const JsonValue described = document().item("skins", skin);
    const std::vector<std::uint64_t> nodes = GltfDocument::wholeNumbers(described, "joints");
    if (nodes.empty()) document().refuse(fmt::format("has a skin without joints (number {})", skin));
    if (nodes.size() > maxJoints)
      document().refuse(fmt::format("has a skin of {} joints, more than {}", nodes.size(), maxJoints));
    std::vector<float> binds;
    if (described.has("inverseBindMatrices")) {
      const std::size_t accessor = GltfDocument::number(described, "inverseBindMatrices");
      if (document().count(accessor) < nodes.size())
        document().refuse(fmt::format("has a skin of {} joints with {} inverse bind matrices", nodes.size(),
                                      document().count(accessor)));
      binds = document().floats(accessor, 16);
    }
    const std::size_t first = figure_.joints.size();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i] >= place_.size() || place_[nodes[i]] < 0)
        document().refuse(fmt::format(
            "has a skin whose joint {} is node {}, which is none of its default scene", i, nodes[i]));
      FigureJoint joint{place_[nodes[i]], true, glm::dmat4(1)};
      if (!binds.empty()) joint.inverseBind = glm::dmat4(glm::make_mat4(&binds[16 * i]));
      for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
          if (!std::isfinite(joint.inverseBind[c][r]))
            document().refuse(
                fmt::format("has a skin whose inverse bind matrix {} is not of finite numbers", i));
      figure_.joints.push_back(joint);
    }
    return skins_[skin] = {first, nodes.size()};
  }

  void add(const Placed& placed) {
    parts_.eachPart(placed.mesh, placed.skinned, [&](const GltfPart& part) {
      builder_.begin(part.vertices.size(), part.triangles.size(), glm::mat4(1), part.hasUvs);
      for (const GltfVertex& vertex : part.vertices) {
        const std::array<float, 8>& v = vertex.values;
        builder_.vertex({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7]});
        glm::uvec4 follow(static_cast<unsigned>(placed.firstJoint));
        glm::vec4 weights(1, 0, 0, 0);
        for (std::size_t k = 0; placed.skinned && k < 4; ++k) {
          if (vertex.bones[k] >= placed.joints)
            document().refuse(fmt::format("has a vertex (number {}) that follows joint {}, its skin has {}",
                                          &vertex - part.vertices.data(), vertex.bones[k], placed.joints));
          follow[static_cast<int>(k)] += vertex.bones[k];
          weights[static_cast<int>(k)] = vertex.weights[k];
        }
        figure_.follow.push_back(follow);
        figure_.weights.push_back(weights);
      }
      for (const auto& triangle : part.triangles) builder_.triangle(triangle);
    });
  }

  void readAnimations() {
    for (std::size_t i = 0; i < document().size("animations"); ++i) {
      const JsonValue described = document().item("animations", i);
      FigureAnimation animation;
      animation.name = nameOf(described, "animation", i);
      described.at("channels").eachItem([&](const JsonValue& channel) {
        if (auto made = channelOf(described, channel, animation.name)) {
          animation.seconds = std::max(animation.seconds, double{made->times.back()});
          animation.channels.push_back(std::move(*made));
        }
      });
      figure_.animations.push_back(std::move(animation));
    }
  }

  /// Nothing of a channel that moves no bone.
  std::optional<FigureChannel> channelOf(const JsonValue& animation, const JsonValue& channel,
                                         const std::string& name) {
    using Path = FigureChannel::Path;
    using Way = FigureChannel::Way;
    const JsonValue target = channel.at("target");
    const std::string path = target.at("path").text();
    if (!target.has("node") || path == "weights" || path == "pointer") return std::nullopt;
    const std::uint64_t node = GltfDocument::number(target, "node");
    static_cast<void>(document().item("nodes", node));
    if (place_[node] < 0) return std::nullopt;  // of another scene
    FigureChannel made;
    made.node = place_[node];
    const auto refuse = [&](const std::string& why) {
      document().refuse(fmt::format("has an animation \"{}\" that moves \"{}\" {}", name,
                                    figure_.nodes[static_cast<std::size_t>(made.node)].name, why));
    };
    if (path != "translation" && path != "rotation" && path != "scale")
      refuse(fmt::format("along \"{}\", which is no property", path));
    if (figure_.nodes[static_cast<std::size_t>(made.node)].hasMatrix)
      refuse("although that has a matrix; give it translation, rotation and scale");
    made.path = path == "translation" ? Path::translation
                : path == "rotation"  ? Path::rotation
                                      : Path::scale;
    const JsonValue sampler = animation.at("samplers").at(GltfDocument::number(channel, "sampler"));
    const std::string way = textIfThere(sampler, "interpolation");
    if (!way.empty() && way != "STEP" && way != "LINEAR" && way != "CUBICSPLINE")
      refuse(fmt::format("by the interpolation \"{}\", which is none", way));
    made.way = way == "STEP" ? Way::step : way == "CUBICSPLINE" ? Way::cubic : Way::linear;
    made.times = document().floats(GltfDocument::number(sampler, "input"), 1);
    const std::size_t width = made.path == Path::rotation ? 4 : 3;
    made.values = document().floats(GltfDocument::number(sampler, "output"), width);
    const std::size_t expected = made.times.size() * width * (made.way == Way::cubic ? 3 : 1);
    if (made.values.size() != expected)
      refuse(fmt::format("by {} values at {} times", made.values.size() / width, made.times.size()));
    for (std::size_t k = 0; k < made.times.size(); ++k)
      if (!(made.times[k] >= 0 && made.times[k] < 1e6F) || (k > 0 && made.times[k] <= made.times[k - 1]))
        refuse(fmt::format("at {} s (key {}): times begin at 0 or later and grow", made.times[k], k));
    for (const float value : made.values)
      if (!(std::abs(value) < 1e9F)) refuse("to a place that is not finite");
    if ((keys_ += made.times.size()) > maxKeys)
      document().refuse(fmt::format("has more than {} keys; sample its animations less often", maxKeys));
    return made;
  }

  GltfParts parts_;
  MeshBuilder builder_;
  Figure figure_;
  std::vector<int> place_;  ///< of a node of the file: here; -1: not in the default scene
  std::map<std::size_t, std::pair<std::size_t, std::size_t>> skins_;  ///< as jointsOf() gives them
  std::vector<Placed> placed_;
  int skinned_ = 0;
  std::size_t keys_ = 0;
};

}  // namespace

Figure readFigure(const std::filesystem::path& file, std::string_view text) {
  try {
    return FigureReader(file, text).read();
  } catch (const JsonError& error) {
    refuseMesh(file, fmt::format("is no sound glTF: {}", error.what()));
  }
}

}  // namespace simreel::sim
