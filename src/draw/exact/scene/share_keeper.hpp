#pragma once
#include "draw/exact/exact_view.hpp"
#include "draw/exact/passes.hpp"
#include "draw/exact/scene/picture_layers.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Counts how many of a pixel's samples show which object, over all pictures (moments, points of a lens)
/// that one is the mean of: shares are as blurred as the light.
class ShareKeeper {
 public:
  ShareKeeper(glm::ivec2 size, int samples);
  /// What the samples of a band show, as Visibility numbers them. `things`: what has numbers, their first
  /// ones ascending.
  void add(std::span<const unsigned> numbers, const shader::ExactView& view,
           std::span<const DrawnThing> things);
  /// Objects and the largest shares, of the mean of so many pictures.
  void finish(PictureLayers& into, int pictures) const;

 private:
  struct Count {
    std::uint32_t object = 0, samples = 0;
  };

  void countOne(std::size_t pixel, std::uint32_t object);
  std::uint32_t numbered(const std::string& name);

  std::size_t samples_;
  std::vector<std::string> objects_;
  std::vector<Count> first_;  ///< of each pixel the object that was met first,
  std::unordered_map<std::size_t, std::vector<Count>> more_;  ///< and, of few, others
};

}  // namespace simreel::draw
