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
#include <glm/vec4.hpp>

namespace simreel::draw {

/// Computes the fraction of each pixel that each object covers. Counts the samples that show the object,
/// over all views (moments and lens points) of a picture. The coverage is thus blurred in the same way as
/// the light.
class CoverageCounter {
 public:
  /// `shifted`: true if each pixel shows other pixels of the view (countView()).
  CoverageCounter(glm::ivec2 size, int samples, bool shifted);
  /// Counts the samples of a band, or keeps them until countView() if pixels are shifted. `numbers`:
  /// primitive ids of the samples, as in Visibility. `things`: objects with primitive ids, sorted by
  /// firstId.
  void add(std::span<const unsigned> numbers, const shader::ExactView& view,
           std::span<const DrawnThing> things);
  /// Counts the samples of a whole view. `from`: for each pixel, the indices of the four pixels of the view
  /// that it shows in equal parts (glsl/draw/exact/screen/lens_sources.comp).
  void countView(std::span<const glm::uvec4> from);
  /// Writes the objects and the largest coverages of each pixel. The coverages are means over `pictures`
  /// views.
  void finish(PictureLayers& into, int pictures) const;

 private:
  struct Count {
    std::uint32_t object = 0, samples = 0;  ///< samples: in quarters
  };

  void count(std::size_t pixel, std::uint32_t object, std::uint32_t samples);
  std::uint32_t numbered(const std::string& name);

  std::size_t samples_;
  bool shifted_;
  std::vector<std::string> objects_;
  std::vector<std::uint32_t> view_;  ///< object of each sample of the view, if pixels are shifted
  std::vector<Count> first_;  ///< for each pixel, the sample count of the object that was found first
  std::unordered_map<std::size_t, std::vector<Count>> more_;  ///< for each pixel with several objects, the
                                                              ///< sample counts of the other objects
};

}  // namespace simreel::draw
