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

/// What vertices follow: a node, and what takes them from the mesh into the node's own space (the inverse
/// bind matrix of a joint; of a mesh without a skin, which is carried whole by its node, none).
struct FigureJoint {
  int node = 0;
  bool bone = true;  ///< of a skin
  glm::dmat4 inverseBind{1};
};

/// A skinned mesh with its bones and motions, as a glTF file has them.
struct Figure {
  Mesh mesh;                       ///< at bind, in its own space (m)
  std::vector<glm::uvec4> follow;  ///< of each vertex: four joints
  std::vector<glm::vec4> weights;  ///< of each vertex: of those, sum 1
  std::vector<FigureNode> nodes;
  std::vector<FigureJoint> joints;
  std::vector<FigureAnimation> animations;

  /// The number of the node of that name. Throws UserError(usage): `what` ("body \"walker\""), then what is
  /// wrong.
  [[nodiscard]] int nodeNamed(const std::string& name, const std::string& what) const;
  /// Likewise of an animation.
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

/// Reads glTF 2.0 or GLB: the meshes of the default scene with a skin (others follow the node that they
/// hang on), at most 1024 joints and 4 bones a vertex, and every animation of translations, rotations and
/// scales. Names that are missing are "node 3", "animation 0"; morph targets are not read. Throws UserError
/// as loadMesh() does; also for a file without a skin, missing weights or a sum that is not about 1, a
/// joint that the skin does not have, and keys whose times do not grow.
[[nodiscard]] Figure loadFigure(const std::filesystem::path& file);

/// The same of a text, in this process.
[[nodiscard]] Figure readFigure(const std::filesystem::path& file, std::string_view text);

}  // namespace simreel::sim
