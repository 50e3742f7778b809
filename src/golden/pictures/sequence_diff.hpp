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

/// Two picture files to compare.
struct Pair {
  std::string name;  ///< file name, or "frame 12" if the two files have different names
  std::filesystem::path a, b;
};

/// Settings for comparing pairs of picture files.
struct PairTerms {
  scene::Tolerance tolerance;
  Allowance allowance;
  Measures measures = Measures::all;
};

struct PairList {
  std::vector<Pair> pairs;  ///< pairs of files, sorted by name or frame number
  std::vector<std::string> onlyA, onlyB;
  std::vector<std::string> passedOver;  ///< skipped paths: other files and hidden folders ("a/.git/")
};

struct PairResult {
  enum class Outcome { equal, within, different, unreadable };
  Outcome outcome = Outcome::equal;
  /// size of both pictures, or of the padded pictures if the sizes differ; 0 if a file is unreadable
  int width = 0, height = 0;
  std::optional<Metrics> metrics;   ///< measured differences; empty if a file could not be read
  std::vector<std::string> broken;  ///< reasons for the difference, one clause each
  std::string message;              ///< reason why a file is unreadable
  std::vector<std::string> notes;   ///< remarks on parts of the files that are not compared
};
/// Returns "equal", "within tolerance", "different" or "unreadable".
[[nodiscard]] const char* outcomeName(PairResult::Outcome outcome);

/// Pairs the pictures in and below two folders by path. Throws UserError(inputOutput) if a folder cannot be
/// listed.
[[nodiscard]] PairList pairFolders(const std::filesystem::path& a, const std::filesystem::path& b);
/// True if the file name contains a placeholder for the frame number, #### or %04d.
[[nodiscard]] bool isPattern(const std::string& name);
/// Pairs the files that match two patterns by frame number. Throws UserError(usage) for an invalid pattern,
/// UserError(inputOutput) if a folder cannot be listed.
[[nodiscard]] PairList pairPatterns(const std::string& a, const std::string& b);

/// Reads and compares two pictures. Fills in the metrics even if the pictures are equal. Pictures of
/// different sizes count as different and are padded. If `differenceFile` is not empty, writes the
/// difference image to that file. For equal pictures, writes it only if `always` is true. Throws
/// UserError(inputOutput) with the file's name if a file cannot be read or written. In that case no
/// difference image has been written.
[[nodiscard]] PairResult comparePair(const Pair& pair, const PairTerms& terms,
                                     const std::filesystem::path& differenceFile, bool always);

/// Compares pairs in parallel. Calls `done` for each result in order, from one thread at a time. Unreadable
/// files are reported as results. `differenceFolder` must exist; if it is empty, no difference images are
/// written.
void comparePairs(const std::vector<Pair>& pairs, const PairTerms& terms,
                  const std::filesystem::path& differenceFolder,
                  const std::function<void(const Pair&, const PairResult&)>& done);

}  // namespace simreel::golden
