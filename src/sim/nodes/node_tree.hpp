#pragma once
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Node of a glTF file: a bone, or an object attached to a bone. In a list of nodes, parents precede their
/// children.
struct FigureNode {
  std::string name;
  int parent = -1;         ///< index of the parent, or -1 for none
  bool hasMatrix = false;  ///< true if the matrix replaces translation, rotation and scale; the node is
                           ///< then not animated
  glm::dmat4 matrix{1};
  glm::dvec3 translation{0};  ///< translation in metres
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 scale{1};

  template <class Archive>
  void pack(Archive& archive) {
    archive(name);
    archive(parent);
    archive(hasMatrix);
    archive(matrix);
    archive(translation);
    archive(rotation);
    archive(scale);
  }
};

/// Animation of one property of a node (glTF 2.0, 3.11 and appendix C).
struct FigureChannel {
  enum class Path { translation, rotation, scale };
  enum class Interpolation { step, linear, cubic };
  int node = 0;
  Path path = Path::translation;
  Interpolation way = Interpolation::linear;
  std::vector<float> times;   ///< times of the keys in seconds, increasing
  std::vector<float> values;  ///< 3 or 4 values (x y z w) per key; for `cubic`: in-tangent, value and
                              ///< out-tangent per key

  template <class Archive>
  void pack(Archive& archive) {
    archive(node);
    archive(path);
    archive(way);
    archive(times);
    archive(values);
  }
};

struct FigureAnimation {
  std::string name;
  double seconds = 0;  ///< time of the last key of all channels
  std::vector<FigureChannel> channels;

  template <class Archive>
  void pack(Archive& archive) {
    archive(name);
    archive(seconds);
    archive(channels);
  }
};

}  // namespace simreel::sim
