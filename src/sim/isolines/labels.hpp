#pragma once
#include "sim/isolines/lines.hpp"

#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Number on a line.
struct IsoLabel {
  std::size_t line = 0;    ///< index of the line
  glm::dvec2 middle{0};    ///< centre of the text in pixels
  glm::dvec2 along{1, 0};  ///< writing direction, a unit vector (y down) with x >= 0, so that the text is
                           ///< upright
  double width = 0;        ///< width of the text in pixels
};

/// Sizes of labels in pixels.
struct IsoLabelSizes {
  std::vector<double> widths;  ///< width of the text of each level; 0 if the level has no label
  double capital = 12;         ///< cap height
};

/// Chooses the positions of labels: on the straightest stretch of each line that is long enough, within the
/// rectangle `part`, away from other lines and from labels that were placed before. If no such stretch is
/// away from other lines, the label may cover lines without labels. A long line has several labels. The
/// positions depend only on the arguments.
[[nodiscard]] std::vector<IsoLabel> placeLabels(std::span<const IsoLine> lines, const IsoLabelSizes& sizes,
                                                const glm::dvec4& part);

/// Returns the pieces of a line that are outside all labels and a gap around the labels. `capital` is the
/// cap height in pixels.
[[nodiscard]] std::vector<IsoLine> withoutLabels(const IsoLine& line, std::span<const IsoLabel> labels,
                                                 double capital);

}  // namespace simreel::sim
