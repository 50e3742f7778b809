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

/// Pixels; x grows right, y down.
struct Rectangle {
  int x = 0, y = 0, width = 0, height = 0;
};

/// What some pictures may differ in. What is not given stays as earlier rules have it; masks add up.
struct Rule {
  std::string match;                        ///< nameMatches(); empty: every picture
  std::map<std::string, double> tolerance;  ///< by field name
  std::optional<bool> ignoreAntialiased;
  std::optional<int> searchRadius;
  std::vector<Rectangle> rectangles;
  std::vector<std::filesystem::path> masks;  ///< pictures; pixels that are not black do not count
  std::string xfail;
  std::string origin;  ///< "rules.json" or "--max-diff-ratio"
};

/// A file of rules:
///
///     {"tolerance": {"maxChannelDiff": 2},
///      "pictures": [{"match": "ui/", "ignoreAntialiased": true, "searchRadius": 1,
///                    "masks": [[0, 0, 64, 16], "masks/clock.png"], "xfail": "why"}]}
///
/// Top-level members hold for all pictures; the last rule that says something wins. Paths are relative to
/// the file; comments may stand in it. Throws UserError(usage) naming the file and the mistake.
[[nodiscard]] std::vector<Rule> readRules(const std::filesystem::path& file);
[[nodiscard]] std::vector<Rule> parseRules(const std::string& text, const std::filesystem::path& file);

/// Whether a glob names a picture: its path, that without extension, or a folder that it is in.
[[nodiscard]] bool nameMatches(const std::string& glob, const std::string& picture);

/// What holds for one picture.
struct Terms {
  scene::Tolerance tolerance;
  std::map<std::string, Bound> bounds;  ///< those in force, and who said so
  bool ignoreAntialiased = false;
  int searchRadius = 0;
  std::vector<Rectangle> rectangles;
  std::vector<std::filesystem::path> masks;
  std::string xfail;
};
/// Of the rules that match it. Without a bound pictures have to be equal, as strictTolerance() says.
[[nodiscard]] Terms termsFor(const std::string& picture, const std::vector<Rule>& rules);

/// What a comparison needs, for pictures of this size. Throws UserError: usage where a mask has another
/// size or a rectangle lies outside, as readPicture() for a mask that cannot be read.
[[nodiscard]] Allowance allowanceOf(const Terms& terms, int width, int height);

}  // namespace simreel::golden
