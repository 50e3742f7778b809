#pragma once
#include "frame/image.hpp"
#include "golden/suite/judge.hpp"

#include <span>
#include <string>

namespace simreel::serve {

/// Returns the result of comparing a frame with its baseline in words: "1,204 of 57,600 pixels differ
/// (2.09%), by 31 of 255 at most, at (211, 90); mean FLIP error 0.0043.", and the reason for a failure.
[[nodiscard]] std::string verdictWords(const golden::FrameResult& frame, const golden::Reference& held,
                                       const frame::Image& made);
/// Returns the text for a frame that the test does not compare.
[[nodiscard]] std::string untestedWords(int frame, std::span<const int> tested,
                                        const golden::Reference& held);

}  // namespace simreel::serve
