#include "golden/pictures/rules.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/strict_json.hpp"
#include "golden/baseline/tolerance.hpp"
#include "golden/files/picture.hpp"

#include <algorithm>
#include <cmath>
#include <fnmatch.h>

#include <nlohmann/json.hpp>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

void readTolerance(const JsonValue& value, Rule& rule) {
  JsonObject tolerance(value);
  for (const scene::Bound& bound : scene::Tolerance().bounds()) {
    const auto found = tolerance.find(bound.name);
    if (!found) continue;
    const double number = found->number();
    const scene::Range& range = bound.spec.range;
    const bool whole = std::holds_alternative<int*>(bound.member);
    if (!(number >= range.min && number <= range.max) || (whole && number != std::floor(number)))
      found->wrong(fmt::format("must be a {} from {:g} to {:g}", whole ? "whole number" : "number",
                               range.min, range.max));
    rule.tolerance[bound.name] = number;
  }
  tolerance.finish();
}

void readMask(const JsonValue& value, const fs::path& folder, Rule& rule) {
  if (value.json().is_string()) {
    rule.masks.push_back(folder / value.text());
    return;
  }
  if (!value.json().is_array() || value.size() != 4)
    value.wrong("must be [x, y, width, height] or the name of a picture");
  const auto number = [&](std::size_t i, int min) { return value.at(i).integer<int>(min, 1 << 20); };
  rule.rectangles.push_back({number(0, 0), number(1, 0), number(2, 1), number(3, 1)});
}

/// Reads the members that are allowed both in a single rule and in the whole file.
Rule ruleOf(JsonObject& from, const fs::path& folder) {
  Rule rule;
  if (const auto tolerance = from.find("tolerance")) readTolerance(*tolerance, rule);
  if (const auto ignore = from.find("ignoreAntialiased")) rule.ignoreAntialiased = ignore->boolean();
  if (const auto radius = from.find("searchRadius"))
    rule.searchRadius = radius->integer<int>(0, largestSearchRadius);
  if (const auto masks = from.find("masks"))
    masks->eachItem([&](const JsonValue& mask) { readMask(mask, folder, rule); });
  return rule;
}

}  // namespace

std::vector<Rule> parseRules(const std::string& text, const fs::path& file) {
  try {
    const auto json = parseStrictJson(text, {.comments = true});
    JsonObject root{JsonValue(json)};
    std::vector<Rule> rules = {ruleOf(root, file.parent_path())};
    rules.front().origin = file.generic_string();
    if (const auto list = root.find("pictures"))
      list->eachItem([&](const JsonValue& item) {
        JsonObject object(item);
        Rule rule = ruleOf(object, file.parent_path());
        rule.match = object.at("match").text();
        if (rule.match.empty()) object.at("match").wrong("must not be empty");
        rule.xfail = textIfThere(object, "xfail");
        rule.origin = fmt::format("{}, \"{}\"", file.generic_string(), rule.match);
        object.finish();
        rules.push_back(std::move(rule));
      });
    root.finish();
    return rules;
  } catch (const JsonError& mistake) {
    fail(ExitCode::usage, "rules {}: {}", file.string(), mistake.what());
  }
}

std::vector<Rule> readRules(const fs::path& file) {
  return parseRules(readFile(file, "rules", std::size_t{16} << 20), file);
}

bool nameMatches(const std::string& glob, const std::string& picture) {
  const auto matches = [](const std::string& pattern, const std::string& name) {
    return ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
  };
  const std::string folder = glob.ends_with('/') ? glob.substr(0, glob.size() - 1) : glob;
  const fs::path path(picture);
  if (folder.size() == glob.size() &&
      (matches(glob, picture) || matches(glob, fs::path(path).replace_extension().generic_string()) ||
       matches(glob, path.filename().string())))
    return true;
  for (fs::path above = path.parent_path(); !above.empty(); above = above.parent_path())
    if (matches(folder, above.generic_string())) return true;
  return false;
}

Terms termsFor(const std::string& picture, const std::vector<Rule>& rules) {
  Terms terms;
  std::map<std::string, double> given;
  std::map<std::string, std::string> origins;
  for (const Rule& rule : rules) {
    if (!rule.match.empty() && !nameMatches(rule.match, picture)) continue;
    for (const auto& [field, value] : rule.tolerance) {
      given[field] = value;
      origins[field] = rule.origin;
    }
    terms.ignoreAntialiased = rule.ignoreAntialiased.value_or(terms.ignoreAntialiased);
    terms.searchRadius = rule.searchRadius.value_or(terms.searchRadius);
    terms.rectangles.insert(terms.rectangles.end(), rule.rectangles.begin(), rule.rectangles.end());
    terms.masks.insert(terms.masks.end(), rule.masks.begin(), rule.masks.end());
    if (!rule.xfail.empty()) terms.xfail = rule.xfail;
  }
  terms.tolerance = strictTolerance(given);
  for (const auto& [field, value] : boundsInForce(terms.tolerance))
    terms.bounds[field] = {value, origins.contains(field) ? origins[field] : "default"};
  return terms;
}

Allowance allowanceOf(const Terms& terms, int width, int height) {
  Allowance allowance;
  allowance.ignoreAntialiased = terms.ignoreAntialiased;
  allowance.searchRadius = terms.searchRadius;
  if (terms.rectangles.empty() && terms.masks.empty()) return allowance;
  allowance.mask.assign(std::size_t(width) * std::size_t(height), 0);
  const auto pixel = [&](int x, int y) -> std::uint8_t& {
    return allowance.mask[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  };
  for (const Rectangle& r : terms.rectangles) {
    if (r.x >= width || r.y >= height)
      fail(ExitCode::usage, "the mask [{}, {}, {}, {}] lies outside of the {}x{} pixels", r.x, r.y, r.width,
           r.height, width, height);
    for (int y = r.y; y < std::min(height, r.y + r.height); ++y)
      for (int x = r.x; x < std::min(width, r.x + r.width); ++x) pixel(x, y) = 1;
  }
  for (const fs::path& file : terms.masks) {
    const Picture mask = readPicture(file, "mask");
    const auto& image = mask.image;
    if (image.width != width || image.height != height)
      fail(ExitCode::usage, "the mask {} is {}x{}, the pictures that it masks {}x{}", file.string(),
           image.width, image.height, width, height);
    for (std::size_t i = 0; i < allowance.mask.size(); ++i) {
      const auto* rgba = &image.bytes[4 * i];
      if (rgba[3] > 0 && (rgba[0] > 0 || rgba[1] > 0 || rgba[2] > 0)) allowance.mask[i] = 1;
    }
  }
  return allowance;
}

}  // namespace simreel::golden
