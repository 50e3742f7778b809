#pragma once
#include "golden/result.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::golden {

/// Text that any reader takes: what is no UTF-8, what steers terminals other than tab and newline, and the
/// code points that XML 1.0 forbids become U+FFFD; "\r\n" and "\r" become "\n".
[[nodiscard]] std::string cleanText(std::string_view text);
/// Up to the first newline.
[[nodiscard]] std::string_view firstLine(std::string_view text);
/// At most `bytes` bytes of clean text, not ending inside a character; "..." stands for the rest.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t bytes);
/// "1 scene", "2 scenes".
[[nodiscard]] std::string counted(long count, std::string_view thing);

/// Why the scene came out so, each line once: its messages, then those of checks and of the divergence.
[[nodiscard]] std::vector<std::string> reasons(const SceneResult& scene);
/// The first line of the first reason; what the status means where a scene gives none.
[[nodiscard]] std::string firstReason(const SceneResult& scene);
/// "failed, then passed on attempt 2"
[[nodiscard]] std::string flakyText(const SceneResult& scene);
/// "within 2 of 255: another machine with the same numerics drew the baseline"; empty without a baseline.
[[nodiscard]] std::string comparedText(const SceneResult& scene);
/// "15 scenes within 2 of 255 ...; 4 scenes within their tolerance ...": those whose pictures need not be
/// equal to their baselines, and why; empty where all have to be.
[[nodiscard]] std::string comparedText(const SuiteResult& suite);
/// How many scenes came out so.
[[nodiscard]] long countOf(const SuiteResult& suite, Status status);
/// The frame that stands for a scene: the one with most pixels beyond the tolerance among those that did
/// not pass; null where all did.
[[nodiscard]] const FrameResult* worstFrame(const SceneResult& scene);
/// Those that make the run fail, in order.
[[nodiscard]] std::vector<const SceneResult*> failures(const SuiteResult& suite);

}  // namespace simreel::golden
