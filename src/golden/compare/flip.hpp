#pragma once
#include "frame/image.hpp"

#include <vector>

namespace simreel::golden {

/// Returns the LDR-FLIP error map, which predicts the difference that a viewer sees when flipping between
/// two pictures (Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: "FLIP: A Difference
/// Evaluator for Alternating Images", 2020). 0 means equal, and 1 is the difference between green and blue.
/// The viewing conditions are those of the paper: the viewer is 0.7 m from a screen that is 0.7 m wide and
/// has 3840 pixels per row, which gives 67.02 pixels per degree. Ignores alpha. The pictures must have
/// equal sizes. Returns width * height errors, row by row from the top.
[[nodiscard]] std::vector<float> flipMap(const frame::Image& a, const frame::Image& b);
/// Returns the mean of flipMap(), summed in double. The authors' program sums floats, which changes the
/// result by 0.1% for two million pixels.
[[nodiscard]] double flipMean(const frame::Image& a, const frame::Image& b);

}  // namespace simreel::golden
