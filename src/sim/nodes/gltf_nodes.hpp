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

/// The nodes of a glTF 2.0 document's default scene, and its motions of them. Names that are missing are
/// "node 3", "animation 0". Throws UserError as GltfDocument does, also for keys whose times do not grow.
class GltfNodes {
 public:
  /// `document` must outlive it.
  explicit GltfNodes(const GltfDocument& document) : document_(document) {}

  /// Hears of each node: it, and its numbers in the file and in the list.
  using Visit = std::function<void(const JsonValue& node, std::uint64_t number, int here)>;
  /// Reads them, parents first.
  void walk(const Visit& visit);
  [[nodiscard]] const std::vector<FigureNode>& nodes() const { return nodes_; }
  /// Where a node of the file stands in that list; -1: not in the default scene.
  [[nodiscard]] int placeOf(std::uint64_t number) const {
    return number < place_.size() ? place_[number] : -1;
  }
  /// Every animation of translations, rotations and scales of those nodes.
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
