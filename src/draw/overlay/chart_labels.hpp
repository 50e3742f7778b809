#pragma once
#include "sim/core/drawable.hpp"
#include "sim/text/letters/font.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Outlines and width of a text, relative to the height of a capital; y points up from the baseline.
struct LabelWord {
  std::vector<std::vector<glm::vec2>> outlines;
  float width = 0;
};

/// Caches the outlines of label texts, in the font that ships with simreel, so that pixels are the same
/// everywhere.
class LabelWords {
 public:
  /// Throws UserError(usage) if the font lacks a character of the text.
  void require(const std::string& text);
  /// Returns the outlines of the first 64 bytes of a text. The result is valid until forget().
  const LabelWord& of(const std::string& text);
  /// Empties the cache if it is large.
  void forget();

 private:
  [[nodiscard]] sim::Font& font();

  std::unique_ptr<sim::Font> font_;  ///< loaded on first use
  std::map<std::string, LabelWord> words_;
};

/// Text of charts, in the font that ships with simreel, so that pixels are the same everywhere.
class ChartLabels {
 public:
  explicit ChartLabels(glm::ivec2 picture) : picture_(picture) {}
  /// Returns the text of all charts that are large enough for letters, for TextPass. The names are in a
  /// line above the curves, and the numbers of the scales are below. The result is valid until the next
  /// call.
  [[nodiscard]] std::vector<sim::Writing> of(const sim::Drawables& drawables);

 private:
  glm::ivec2 picture_;
  LabelWords words_;
};

}  // namespace simreel::draw
