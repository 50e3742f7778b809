#pragma once
#include "golden/compare/allowance.hpp"
#include "golden/compare/compare.hpp"
#include "golden/result.hpp"
#include "scene/test.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace simreel::golden {

/// Two files to compare.
struct Pair {
  std::string name;  ///< of the file, or "frame 12" where the files are named differently
  std::filesystem::path a, b;
};

/// How they are compared.
struct PairTerms {
  scene::Tolerance tolerance;
  Allowance allowance;
  Measures measures = Measures::all;
};

struct PairList {
  std::vector<Pair> pairs;  ///< by name, or by frame number
  std::vector<std::string> onlyA, onlyB;
  std::vector<std::string> passedOver;  ///< files that are no pictures, and hidden folders ("a/.git/")
};

struct PairResult {
  enum class Outcome { equal, within, different, unreadable };
  Outcome outcome = Outcome::equal;
  int width = 0, height = 0;        ///< of both, padded where they differ; 0 when unreadable
  std::optional<Metrics> metrics;   ///< none where a file could not be read
  std::vector<std::string> broken;  ///< why they are different, a clause each
  std::string message;              ///< unreadable: why
  std::vector<std::string> notes;   ///< what of the files is not compared
};
/// "equal", "within tolerance", "different", "unreadable".
[[nodiscard]] const char* outcomeName(PairResult::Outcome outcome);

/// The pictures of two folders and all below them, by path. Throws UserError(inputOutput) for a folder that
/// cannot be listed.
[[nodiscard]] PairList pairFolders(const std::filesystem::path& a, const std::filesystem::path& b);
/// Whether the file name holds a frame number: #### or %04d.
[[nodiscard]] bool isPattern(const std::string& name);
/// The files that two patterns name, by frame number. Throws UserError: usage for a senseless pattern,
/// inputOutput for a folder that cannot be listed.
[[nodiscard]] PairList pairPatterns(const std::string& a, const std::string& b);

/// Reads and compares two pictures; metrics are filled in for equal pictures too. Pictures of different
/// sizes differ, and are measured padded. The difference image is written where a path is given; for equal
/// pictures only with `always`. Throws UserError(inputOutput) naming the file; nothing has been written
/// then.
[[nodiscard]] PairResult comparePair(const Pair& pair, const PairTerms& terms,
                                     const std::filesystem::path& differenceFile, bool always);

/// Compares pairs in parallel and hands results over in order, from one thread at a time. A pair that
/// cannot be read is a result like any other. `differenceFolder` (empty: none) must exist.
void comparePairs(const std::vector<Pair>& pairs, const PairTerms& terms,
                  const std::filesystem::path& differenceFolder,
                  const std::function<void(const Pair&, const PairResult&)>& done);

}  // namespace simreel::golden
