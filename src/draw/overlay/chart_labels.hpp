#pragma once
#include "sim/core/drawable.hpp"
#include "sim/text/letters/font.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Text of charts, in the font that ships with simreel, so that the pixels are the same on every machine.
class ChartLabels {
 public:
  explicit ChartLabels(glm::ivec2 picture) : picture_(picture) {}
  /// Returns the text of all charts that have room for letters, for WritingPass: the names in a row above
  /// the curves and the scales below. The result is valid until the next call.
  [[nodiscard]] std::vector<sim::Writing> of(const sim::Drawables& drawables);

 private:
  using Outlines = std::vector<std::vector<glm::vec2>>;
  /// Outlines and width of a text, relative to the height of a capital.
  struct Word {
    Outlines outlines;
    float width = 0;
  };
  const Word& word(const std::string& text);

  glm::ivec2 picture_;
  std::unique_ptr<sim::Font> font_;  ///< loaded on first use
  std::map<std::string, Word> words_;
};

}  // namespace simreel::draw
