#pragma once
#include "golden/result.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::golden {

/// Returns text that every program can display. U+FFFD replaces invalid UTF-8, control characters that
/// affect terminals (except tab and newline), and code points that XML 1.0 forbids. A carriage return, or a
/// carriage return and a newline, becomes one newline.
[[nodiscard]] std::string cleanText(std::string_view text);
/// Returns the text up to the first newline.
[[nodiscard]] std::string_view firstLine(std::string_view text);
/// Cuts clean text to at most `bytes` bytes at a character boundary, and appends "..." if text was cut.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t bytes);
/// Returns a number with its noun: "1 scene", "2 scenes".
[[nodiscard]] std::string counted(long count, std::string_view thing);

/// Returns the reasons for the scene's status without duplicates. The scene's messages come first, then the
/// messages of frames, checks and the divergence.
[[nodiscard]] std::vector<std::string> reasons(const SceneResult& scene);
/// Returns the first line of the first reason, or the meaning of the status if the scene has no reasons.
[[nodiscard]] std::string firstReason(const SceneResult& scene);
/// Returns text such as "failed, then passed on attempt 2".
[[nodiscard]] std::string flakyText(const SceneResult& scene);
/// Returns how closely the pictures had to match: "within 2 of 255: another machine with the same numerics
/// drew the baseline". Returns an empty text if there is no baseline.
[[nodiscard]] std::string comparedText(const SceneResult& scene);
/// Returns the number of scenes whose pictures need not equal their baselines, with the reason: "15 scenes
/// within 2 of 255 (another machine ...), 4 scenes within the tolerance (...)". Returns an empty text if
/// all pictures must be equal.
[[nodiscard]] std::string comparedText(const SuiteResult& suite);
/// Returns the number of scenes with the given status.
[[nodiscard]] long countOf(const SuiteResult& suite, Status status);
/// Returns the frame that represents a scene. Among the frames that did not pass, this is the one with the
/// most pixels beyond the tolerance. Returns nullptr if all frames passed.
[[nodiscard]] const FrameResult* worstFrame(const SceneResult& scene);
/// Returns the scenes that make the run fail, in order.
[[nodiscard]] std::vector<const SceneResult*> failures(const SuiteResult& suite);

}  // namespace simreel::golden
