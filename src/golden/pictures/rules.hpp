#pragma once
#include "golden/compare/allowance.hpp"
#include "golden/result.hpp"
#include "scene/test.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace simreel::golden {

inline constexpr int largestSearchRadius = 16;

/// Rectangle in pixels; x grows to the right, y downwards.
struct Rectangle {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Allowed differences for some pictures. Members without a value are taken from earlier rules. Masks of
/// all rules are combined.
struct Rule {
  std::string match;                        ///< glob as in nameMatches(); if empty, the rule applies to
                                            ///< every picture
  std::map<std::string, double> tolerance;  ///< tolerance bounds by field name
  std::optional<bool> ignoreAntialiased;
  std::optional<int> searchRadius;
  std::vector<Rectangle> rectangles;
  std::vector<std::filesystem::path> masks;  ///< files of mask pictures; pixels that are not black in a
                                             ///< mask are ignored
  std::string xfail;
  std::string origin;  ///< source of the rule: "rules.json" or "--max-diff-ratio"
};

/// Reads a file of rules:
///
///    {"tolerance": {"maxChannelDiff": 2},
///     "pictures": [{"match": "ui/", "ignoreAntialiased": true, "searchRadius": 1,
///                   "masks": [[0, 0, 64, 16], "masks/clock.png"], "xfail": "why"}]}
///
/// Top-level members apply to all pictures. If several rules set a value, the last one wins. Paths are
/// relative to the file; comments are allowed. Throws UserError(usage) with the file's name and the
/// mistake.
[[nodiscard]] std::vector<Rule> readRules(const std::filesystem::path& file);
[[nodiscard]] std::vector<Rule> parseRules(const std::string& text, const std::filesystem::path& file);

/// True if a glob matches the picture's path, its path without extension, its file name, or a folder above
/// it.
[[nodiscard]] bool nameMatches(const std::string& glob, const std::string& picture);

/// Combined rules for one picture.
struct Terms {
  scene::Tolerance tolerance;
  std::map<std::string, Bound> bounds;  ///< bounds that apply, with their origin
  bool ignoreAntialiased = false;
  int searchRadius = 0;
  std::vector<Rectangle> rectangles;
  std::vector<std::filesystem::path> masks;
  std::string xfail;
};
/// Combines the rules that match the picture. Without bounds, pictures must be equal (strictTolerance()).
[[nodiscard]] Terms termsFor(const std::string& picture, const std::vector<Rule>& rules);

/// Returns the allowance for pictures of this size. Throws UserError(usage) if a mask has another size or a
/// rectangle lies outside the picture. Throws the same errors as readPicture() if a mask cannot be read.
[[nodiscard]] Allowance allowanceOf(const Terms& terms, int width, int height);

}  // namespace simreel::golden
