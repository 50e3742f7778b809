#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Closed polygons, y up. What they go round is filled, whichever way they go (not zero times).
using TextOutlines = std::vector<std::vector<glm::dvec2>>;

/// The outlines of a font file, without hints, so they are those of the file on every machine. Lengths are
/// in heights of its capital H.
class Font {
 public:
  struct Glyph {
    TextOutlines outlines;  ///< from where it is written
    double advance = 0;
  };

  /// Reads TrueType or OpenType. Throws UserError(inputOutput) for other files, and the errors of readFile.
  explicit Font(std::filesystem::path file);
  ~Font();
  Font(Font&&) = delete;
  Font& operator=(Font&&) = delete;
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  [[nodiscard]] bool has(char32_t character) const;
  /// Of one that it has, or of what stands for those it has not. Curves are polygons that lie within a
  /// thousandth of a capital's height of them.
  [[nodiscard]] const Glyph& glyph(char32_t character);
  /// By how much two characters are moved apart.
  [[nodiscard]] double kerning(char32_t first, char32_t second) const;
  /// From one baseline to the next.
  [[nodiscard]] double lineHeight() const;

 private:
  struct Library;
  std::filesystem::path file_;
  std::unique_ptr<Library> library_;
  double perUnit_ = 0;  ///< heights of H
  std::map<char32_t, Glyph> glyphs_;
};

}  // namespace simreel::sim
