#pragma once
#include "golden/pictures/sequence_diff.hpp"
#include "scene/test.hpp"

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace simreel::cli {

/// Returns the output of `simreel diff` for two pictures: one line per metric, then the verdict.
[[nodiscard]] std::string pairText(const golden::PairResult& result, const scene::Tolerance& tolerance);
[[nodiscard]] nlohmann::ordered_json pairJson(const std::string& a, const std::string& b,
                                              const golden::PairResult& result);
/// Returns the line about one pair of a sequence, or an empty text if the pictures are equal.
[[nodiscard]] std::string pairLine(const golden::Pair& pair, const golden::PairResult& result);

/// Collected results of a sequence of pairs.
struct SequenceReport {
  using Outcome = golden::PairResult::Outcome;

  std::map<Outcome, int> counts;
  std::vector<std::string> onlyA, onlyB, passedOver;
  nlohmann::ordered_json frames = nlohmann::ordered_json::array();

  void add(const golden::Pair& pair, const golden::PairResult& result);
  [[nodiscard]] int count(Outcome outcome) const;
  [[nodiscard]] bool differs() const;
  /// Returns the names that exist only on one side, followed by a line with the counts.
  [[nodiscard]] std::string summary(const std::string& a, const std::string& b) const;
  [[nodiscard]] nlohmann::ordered_json json(const std::string& a, const std::string& b) const;
};

}  // namespace simreel::cli
