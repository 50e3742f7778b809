#pragma once
#include "golden/compare/compare.hpp"
#include "golden/pictures/picture_set.hpp"
#include "golden/pictures/rules.hpp"
#include "golden/result.hpp"
#include "golden/tally.hpp"
#include "golden/update.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace simreel::golden {

struct PictureOptions {
  std::filesystem::path expected;  ///< folder of the baselines
  std::vector<Rule> rules;
  Update update = Update::none;
  Measures measures = Measures::all;   ///< selection of measurements; with `quick`, SSIM and FLIP are
                                       ///< measured only if a bound needs them
  std::filesystem::path reportFolder;  ///< folder of report.json; image paths are relative to it
  std::filesystem::path artifacts;     ///< folder for pictures of failures; if empty, no pictures are
                                       ///< stored
};

/// Compares one picture with its baseline. Depending on the options, updates the baseline or stores files
/// for a report. Read and write errors become results, not exceptions.
[[nodiscard]] SceneResult testPicture(const PictureCase& one, const PictureOptions& options);

/// Tests pictures in parallel. Calls `done` for each result in order, from one thread at a time.
void testPictures(const std::vector<PictureCase>& cases, const PictureOptions& options,
                  const std::function<void(SceneResult&&)>& done);

/// Returns a message for each rule that matches no picture: "rules.json, "ui/*" matches no picture".
[[nodiscard]] std::vector<std::string> unusedRules(const std::vector<Rule>& rules,
                                                   const std::vector<PictureCase>& cases);

}  // namespace simreel::golden
