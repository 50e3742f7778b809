#pragma once
#include "sim/core/drawable.hpp"
#include "sim/text/letters/font.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// What is written on charts, in the font that ships with simreel, so that it has the same pixels
/// everywhere.
class ChartLabels {
 public:
  explicit ChartLabels(glm::ivec2 picture) : picture_(picture) {}
  /// Names in a row above the curves of each chart that has room for letters, and its scales below them,
  /// for WritingPass; live until the next call.
  [[nodiscard]] std::vector<sim::Writing> of(const sim::Drawables& drawables);

 private:
  using Outlines = std::vector<std::vector<glm::vec2>>;
  /// Some text's outlines and width, in heights of a capital.
  struct Word {
    Outlines outlines;
    float width = 0;
  };
  const Word& word(const std::string& text);

  glm::ivec2 picture_;
  std::unique_ptr<sim::Font> font_;  ///< read when it is first needed
  std::map<std::string, Word> words_;
};

}  // namespace simreel::draw
