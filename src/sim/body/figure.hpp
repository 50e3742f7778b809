#pragma once
#include "sim/mesh/file/mesh_file.hpp"
#include "sim/nodes/node_tree.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Node that vertices follow, with the matrix from mesh space to node space. For a joint, this is its
/// inverse bind matrix. For a mesh without a skin, it is the identity, and the node moves the whole mesh.
struct FigureJoint {
  int node = 0;
  bool bone = true;  ///< true if the node is a joint of a skin
  glm::dmat4 inverseBind{1};
};

/// Skinned mesh with its bones and animations, as read from a glTF file.
struct Figure {
  Mesh mesh;                       ///< mesh in the bind pose, in mesh space (metres)
  std::vector<glm::uvec4> follow;  ///< indices of four joints per vertex
  std::vector<glm::vec4> weights;  ///< weights of the joints in `follow` per vertex; their sum is 1
  std::vector<FigureNode> nodes;
  std::vector<FigureJoint> joints;
  std::vector<FigureAnimation> animations;

  /// Returns the index of the node with this name. Throws UserError(usage) for an unknown name; the message
  /// starts with `what`, for example "body \"walker\"".
  [[nodiscard]] int nodeNamed(const std::string& name, const std::string& what) const;
  /// Returns the animation with this name. Throws the same error as nodeNamed().
  [[nodiscard]] const FigureAnimation& animationNamed(const std::string& name,
                                                      const std::string& what) const;

  template <class Archive>
  void pack(Archive& archive) {
    archive(mesh);
    archive(follow);
    archive(weights);
    archive(nodes);
    archive(joints);
    archive(animations);
  }
};

/// Reads glTF 2.0 or GLB: the skinned meshes of the default scene (meshes without a skin follow their
/// node), with at most 1024 joints and 4 joints per vertex, and all animations of translation, rotation and
/// scale. Missing names become "node 3" or "animation 0"; morph targets keep their initial weights. Throws
/// UserError as loadMesh() does, and also for a file without a skin or a moving mesh, missing weights or
/// weights whose sum is not about 1, an invalid joint, and key times that do not increase.
[[nodiscard]] Figure loadFigure(const std::filesystem::path& file);

/// Parses a figure from text like loadFigure(), but in the calling process instead of a separate one.
[[nodiscard]] Figure readFigure(const std::filesystem::path& file, std::string_view text);

}  // namespace simreel::sim
