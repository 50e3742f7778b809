#pragma once
#include "frame/image.hpp"

#include <vector>

namespace simreel::golden {

/// LDR-FLIP: how far apart two pictures look when one flips between them (Andersson, Nilsson,
/// Akenine-Moller, Oskarsson, Astrom, Fairchild: "FLIP: A Difference Evaluator for Alternating Images",
/// 2020). 0 is equal, 1 the difference of green and blue. The observer is the paper's: 0.7 m from a screen
/// of 3840 pixels in 0.7 m, which is 67.02 pixels per degree. Alpha does not count. Sizes must be equal (an
/// invariant). Returns width * height errors, rows from the top.
[[nodiscard]] std::vector<float> flipMap(const frame::Image& a, const frame::Image& b);
/// Mean of the map, summed in double. (The authors' program sums floats, and differs by 0.1% at two million
/// pixels.)
[[nodiscard]] double flipMean(const frame::Image& a, const frame::Image& b);

}  // namespace simreel::golden
