#pragma once
#include "golden/suite/sequence_diff.hpp"
#include "scene/test.hpp"

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace simreel::cli {

/// What `simreel diff` prints for two pictures: a line for each metric, then the verdict.
[[nodiscard]] std::string pairText(const golden::PairResult& result, const scene::Tolerance& tolerance);
[[nodiscard]] nlohmann::ordered_json pairJson(const std::string& a, const std::string& b,
                                              const golden::PairResult& result);
/// The line of a pair in a sequence; empty when the pair is equal.
[[nodiscard]] std::string pairLine(const golden::Pair& pair, const golden::PairResult& result);

/// What is known of a sequence so far.
struct SequenceReport {
  int equal = 0, within = 0, different = 0, unreadable = 0;
  std::vector<std::string> onlyA, onlyB;
  nlohmann::ordered_json frames = nlohmann::ordered_json::array();

  void add(const golden::Pair& pair, const golden::PairResult& result);
  [[nodiscard]] bool differs() const { return different > 0 || !onlyA.empty() || !onlyB.empty(); }
  /// Names in only one, then a line with the counts.
  [[nodiscard]] std::string summary(const std::string& a, const std::string& b) const;
  [[nodiscard]] nlohmann::ordered_json json(const std::string& a, const std::string& b) const;
};

}  // namespace simreel::cli
