#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Closed polygons with y up. The nonzero winding rule determines the interior.
using TextOutlines = std::vector<std::vector<glm::dvec2>>;

/// Outlines of the glyphs in a font file, without hinting, so that they are the same on every machine. The
/// unit of length is the height of the capital H.
class Font {
 public:
  struct Glyph {
    TextOutlines outlines;  ///< polygons relative to the pen position
    double advance = 0;
  };

  /// Reads a TrueType or OpenType font. Throws UserError(inputOutput) for other files, and the errors of
  /// readFile().
  explicit Font(std::filesystem::path file);
  ~Font();
  Font(Font&&) = delete;
  Font& operator=(Font&&) = delete;
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  [[nodiscard]] bool has(char32_t character) const;
  /// Returns the glyph of a character, or the font's replacement glyph if the font does not have the
  /// character. Curves are approximated by polygons to within a thousandth of the cap height.
  [[nodiscard]] const Glyph& glyph(char32_t character);
  /// Returns the kerning distance between two characters.
  [[nodiscard]] double kerning(char32_t first, char32_t second) const;
  /// Returns the distance between baselines.
  [[nodiscard]] double lineHeight() const;

 private:
  struct Library;
  std::filesystem::path file_;
  std::unique_ptr<Library> library_;
  double perUnit_ = 0;  ///< scale from font units to units of the cap height
  std::map<char32_t, Glyph> glyphs_;
};

}  // namespace simreel::sim
