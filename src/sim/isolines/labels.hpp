#pragma once
#include "sim/isolines/lines.hpp"

#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Number on a line.
struct IsoLabel {
  std::size_t line = 0;    ///< index of the line
  glm::dvec2 middle{0};    ///< middle of the text in pixels
  glm::dvec2 along{1, 0};  ///< direction of writing, a unit vector (y down) with x >= 0: text is upright
  double width = 0;        ///< width of the text in pixels
};

/// Sizes of labels in pixels.
struct IsoLabelSizes {
  std::vector<double> widths;  ///< width of the text of each level; 0: no label
  double capital = 12;         ///< height of a capital
};

/// Chooses the places of labels: on the straightest part of each line that is long enough, within `part`,
/// away from other lines and from labels that were placed before. If no part is away from other lines, it
/// may lie over lines without labels. A long line has several labels. The places depend on the arguments
/// alone.
[[nodiscard]] std::vector<IsoLabel> placeLabels(std::span<const IsoLine> lines, const IsoLabelSizes& sizes,
                                                const glm::dvec4& part);

/// Returns the parts of a line outside of all labels and a gap around them. `capital`: height of a capital
/// in pixels.
[[nodiscard]] std::vector<IsoLine> withoutLabels(const IsoLine& line, std::span<const IsoLabel> labels,
                                                 double capital);

}  // namespace simreel::sim
