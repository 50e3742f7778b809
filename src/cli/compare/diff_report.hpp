#pragma once
#include "golden/pictures/sequence_diff.hpp"
#include "scene/test.hpp"

#include <map>
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
  using Outcome = golden::PairResult::Outcome;

  std::map<Outcome, int> counts;
  std::vector<std::string> onlyA, onlyB, passedOver;
  nlohmann::ordered_json frames = nlohmann::ordered_json::array();

  void add(const golden::Pair& pair, const golden::PairResult& result);
  [[nodiscard]] int count(Outcome outcome) const;
  [[nodiscard]] bool differs() const;
  /// Names in only one, then a line with the counts.
  [[nodiscard]] std::string summary(const std::string& a, const std::string& b) const;
  [[nodiscard]] nlohmann::ordered_json json(const std::string& a, const std::string& b) const;
};

}  // namespace simreel::cli
