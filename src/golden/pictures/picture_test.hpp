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
  Measures measures = Measures::all;   ///< quick: SSIM and FLIP only where a bound needs them
  std::filesystem::path reportFolder;  ///< of report.json; image paths are relative to it
  std::filesystem::path artifacts;     ///< pictures of failures go below it; empty: nowhere
};

/// Compares one picture with its baseline, updates that where asked and keeps what a report needs. What
/// cannot be read or written is a result like any other.
[[nodiscard]] SceneResult testPicture(const PictureCase& one, const PictureOptions& options);

/// Tests pictures in parallel and hands results over in order, from one thread at a time.
void testPictures(const std::vector<PictureCase>& cases, const PictureOptions& options,
                  const std::function<void(SceneResult&&)>& done);

/// "rules.json, "ui/*" matches no picture": what the rules say in vain.
[[nodiscard]] std::vector<std::string> unusedRules(const std::vector<Rule>& rules,
                                                   const std::vector<PictureCase>& cases);

}  // namespace simreel::golden
