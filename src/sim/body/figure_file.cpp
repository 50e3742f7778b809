#include "sim/body/figure.hpp"
#include "sim/mesh/file/builder.hpp"
#include "sim/mesh/file/gltf_materials.hpp"
#include "sim/mesh/file/gltf_parts.hpp"
#include "sim/mesh/file/texture_place.hpp"
#include "sim/nodes/gltf_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

namespace simreel::sim {

namespace {

constexpr std::size_t maxJoints = 1024;

class FigureReader {
 public:
  FigureReader(const std::filesystem::path& file, std::string_view text)
      : parts_(file, text), nodes_(parts_.document()), builder_(file) {}

  Figure read() {
    walk();
    figure_.animations = nodes_.animations();
    if (skinned_ == 0 && !movesMesh())
      document().refuse(
          "has neither a skin nor a moving mesh in its default scene; it is a \"mesh\", not a \"body\"");
    for (const Placed& placed : placed_) parts_.count(placed.mesh);
    for (const Placed& placed : placed_) add(placed);
    figure_.mesh = builder_.finish();
    GltfMaterials looks = readMaterials(document());
    figure_.mesh.materials = std::move(looks.materials);
    figure_.mesh.images = std::move(looks.images);
    figure_.mesh.ignored = std::move(looks.ignored);
    figure_.mesh.undrawn = parts_.undrawn();
    if (fades_) figure_.mesh.ignored.emplace_back("the opacity in COLOR_0");
    if (figure_.mesh.materials.empty()) figure_.mesh.materialOf.clear();
    placeTextures(figure_.mesh);
    return std::move(figure_);
  }

 private:
  /// Mesh instance, with the index of the first joint of its skin.
  struct Placed {
    std::size_t mesh;
    std::size_t firstJoint;
    std::size_t joints;  ///< number of joints of the skin
    bool skinned;
    std::vector<float> morphs;
  };

  [[nodiscard]] const GltfDocument& document() const { return parts_.document(); }

  /// Collects the nodes of the default scene, parents first, and their meshes.
  void walk() {
    std::vector<std::pair<std::uint64_t, int>> meshes;  // pairs of the node index of a mesh in the file and
                                                        // its node index in figure_
    nodes_.walk([&](const JsonValue& node, std::uint64_t number, int here) {
      if (node.has("mesh")) meshes.emplace_back(number, here);
    });
    figure_.nodes = nodes_.nodes();
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
      placed_.push_back({mesh, first, count, skinned, morphsOf(node)});
      skinned_ += skinned ? 1 : 0;
      if (figure_.joints.size() > maxJoints)
        document().refuse(fmt::format("has more than {} joints", maxJoints));
    }
  }

  /// Returns the index of a skin's first joint and the number of its joints.
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
      if (nodes_.placeOf(nodes[i]) < 0)
        document().refuse(fmt::format(
            "has a skin whose joint {} is node {}, which is not in its default scene", i, nodes[i]));
      FigureJoint joint{nodes_.placeOf(nodes[i]), true, glm::dmat4(1)};
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

  /// Returns true if an animation moves the node of a mesh or an ancestor of that node.
  [[nodiscard]] bool movesMesh() const {
    std::set<int> moved;
    for (const FigureAnimation& animation : figure_.animations)
      for (const FigureChannel& channel : animation.channels) moved.insert(channel.node);
    return std::any_of(figure_.joints.begin(), figure_.joints.end(), [&](const FigureJoint& joint) {
      int node = joint.node;
      while (node >= 0 && !moved.contains(node))
        node = figure_.nodes[static_cast<std::size_t>(node)].parent;
      return node >= 0;
    });
  }

  void add(const Placed& placed) {
    parts_.eachPart(placed.mesh, {placed.skinned, {}, placed.morphs}, [&](const GltfPart& part) {
      builder_.begin(part.vertices.size(), part.triangles.size(), glm::mat4(1), part.hasUvs, part.material);
      for (const GltfVertex& vertex : part.vertices) {
        addVertex(builder_, part, vertex);
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
      fades_ = fades_ || part.fades;
    });
  }

  GltfParts parts_;
  GltfNodes nodes_;
  MeshBuilder builder_;
  Figure figure_;
  std::map<std::size_t, std::pair<std::size_t, std::size_t>> skins_;  ///< cache of the results of
                                                                      ///< jointsOf(); the key is the skin
  std::vector<Placed> placed_;
  int skinned_ = 0;
  bool fades_ = false;
};

}  // namespace

Figure readFigure(const std::filesystem::path& file, std::string_view text) {
  try {
    return FigureReader(file, text).read();
  } catch (const JsonError& error) {
    refuseMesh(file, fmt::format("is not valid glTF: {}", error.what()));
  }
}

}  // namespace simreel::sim
