#pragma once
#include "sim/mesh/file/gltf_document.hpp"
#include "sim/nodes/node_tree.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace simreel::sim {

/// Nodes of the default scene of a glTF 2.0 document, and their animations. Missing names become "node 3"
/// or "animation 0". Throws the errors of GltfDocument, and UserError for key times that do not increase.
class GltfNodes {
 public:
  /// Keeps a reference to `document`, which must outlive this object.
  explicit GltfNodes(const GltfDocument& document) : document_(document) {}

  /// Callback for each node: the node, its index in the file, and its index in nodes().
  using Visit = std::function<void(const JsonValue& node, std::uint64_t number, int here)>;
  /// Reads the nodes, parents first.
  void walk(const Visit& visit);
  [[nodiscard]] const std::vector<FigureNode>& nodes() const { return nodes_; }
  /// Returns the index in nodes() of a node of the file, or -1 if it is not in the default scene.
  [[nodiscard]] int placeOf(std::uint64_t number) const {
    return number < place_.size() ? place_[number] : -1;
  }
  /// Returns all animations of translations, rotations and scales of the nodes.
  [[nodiscard]] std::vector<FigureAnimation> animations();

 private:
  std::optional<FigureChannel> channelOf(const JsonValue& animation, const JsonValue& channel,
                                         const std::string& name);

  const GltfDocument& document_;
  std::vector<FigureNode> nodes_;
  std::vector<int> place_;
  std::size_t keys_ = 0;
};

}  // namespace simreel::sim
