#include "sim/text/letters/font.hpp"

#include "base/error.hpp"
#include "base/file.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <ft2build.h>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include FT_FREETYPE_H
#include FT_MODULE_H
#include FT_OUTLINE_H

namespace simreel::sim {

namespace {

constexpr double tolerance = 1e-3;  // maximum deviation of polygons from curves, in units of the cap height
constexpr int maxPieces = 64;

/// Collects the polygons of an outline from FreeType's callbacks.
struct Pen {
  double perUnit;
  TextOutlines outlines;

  [[nodiscard]] glm::dvec2 place(const FT_Vector* at) const {
    return perUnit * glm::dvec2(static_cast<double>(at->x), static_cast<double>(at->y));
  }
  /// Returns the number n of line segments for a curve whose deviation from its chords is at most `bend` /
  /// (8 n^2).
  static int pieces(double bend) {
    return std::clamp(static_cast<int>(std::ceil(std::sqrt(bend / (8 * tolerance)))), 1, maxPieces);
  }
  static int move(const FT_Vector* to, void* user) {
    auto& pen = *static_cast<Pen*>(user);
    pen.outlines.push_back({pen.place(to)});
    return 0;
  }
  static int line(const FT_Vector* to, void* user) {
    auto& pen = *static_cast<Pen*>(user);
    pen.outlines.back().push_back(pen.place(to));
    return 0;
  }
  // Adds a conic (quadratic) curve B. The deviation from its n chords is at most max |B''| / (8 n^2), where
  // B'' is 2 (a - 2 b + c) for the points a, b and c.
  static int conic(const FT_Vector* control, const FT_Vector* to, void* user) {
    auto& pen = *static_cast<Pen*>(user);
    const glm::dvec2 a = pen.outlines.back().back(), b = pen.place(control), c = pen.place(to);
    const int count = pieces(2 * glm::length(a - 2.0 * b + c));
    for (int i = 1; i <= count; ++i) {
      const double u = static_cast<double>(i) / count, v = 1 - u;
      pen.outlines.back().push_back(i == count ? c : v * v * a + 2 * u * v * b + u * u * c);
    }
    return 0;
  }
  static int cubic(const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* user) {
    auto& pen = *static_cast<Pen*>(user);
    const glm::dvec2 a = pen.outlines.back().back(), b = pen.place(first), c = pen.place(second),
                     d = pen.place(to);
    const double bend = std::max(glm::length(a - 2.0 * b + c), glm::length(b - 2.0 * c + d));
    const int count = pieces(6 * bend);
    for (int i = 1; i <= count; ++i) {
      const double u = static_cast<double>(i) / count, v = 1 - u;
      pen.outlines.back().push_back(
          i == count ? d : v * v * v * a + 3 * u * v * v * b + 3 * u * u * v * c + u * u * u * d);
    }
    return 0;
  }
};

/// Removes repeated points, and then polygons with fewer than three points.
void clean(TextOutlines& outlines) {
  for (auto& polygon : outlines) {
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    while (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
  }
  std::erase_if(outlines, [](const auto& polygon) { return polygon.size() < 3; });
}

}  // namespace

struct Font::Library {
  Library() {
    if (FT_New_Library(&memory, &library) != 0) fail(ExitCode::device, "FreeType cannot start");
    FT_Add_Default_Modules(library);
    FT_Set_Default_Properties(library);
  }
  ~Library() {
    if (face != nullptr) FT_Done_Face(face);
    FT_Done_Library(library);
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  Library(Library&&) = delete;
  Library& operator=(Library&&) = delete;

  /// Maximum memory of FreeType in bytes, because glyphs nested in composite glyphs could allocate
  /// gigabytes.
  static constexpr std::size_t maxMemory = std::size_t{64} << 20;
  std::size_t taken = 0;
  FT_MemoryRec_ memory{this, allocate, giveBack, resize};
  std::string bytes;  ///< font data that FreeType reads
  FT_Library library = nullptr;
  FT_Face face = nullptr;

 private:
  static void* allocate(FT_Memory memory, long size) { return resize(memory, 0, size, nullptr); }
  static void giveBack(FT_Memory memory, void* block) {
    if (block == nullptr) return;
    auto* start = static_cast<std::max_align_t*>(block) - 1;
    std::size_t size = 0;
    std::memcpy(&size, start, sizeof size);
    static_cast<Library*>(memory->user)->taken -= size;
    std::free(start);
  }
  // Reallocates a block. The size of each block is stored before it.
  static void* resize(FT_Memory memory, long before, long size, void* block) {
    auto& library = *static_cast<Library*>(memory->user);
    const auto wanted = static_cast<std::size_t>(size);
    const auto had = static_cast<std::size_t>(before);
    if (library.taken - had + wanted > maxMemory) return nullptr;
    auto* old = block == nullptr ? nullptr : static_cast<std::max_align_t*>(block) - 1;
    auto* start = static_cast<std::max_align_t*>(std::realloc(old, sizeof(std::max_align_t) + wanted));
    if (start == nullptr) return nullptr;
    std::memcpy(start, &wanted, sizeof wanted);
    library.taken += wanted - had;
    return start + 1;
  }
};

Font::Font(std::filesystem::path file) : file_(std::move(file)), library_(std::make_unique<Library>()) {
  constexpr std::size_t byteLimit = std::size_t{64} << 20;
  Library& l = *library_;
  l.bytes = readFile(file_, "font", byteLimit);
  if (FT_New_Memory_Face(l.library, reinterpret_cast<const FT_Byte*>(l.bytes.data()),
                         static_cast<FT_Long>(l.bytes.size()), 0, &l.face) != 0)
    fail(ExitCode::inputOutput, "cannot read font {}: it is no TrueType or OpenType file", file_.string());
  if ((l.face->face_flags & FT_FACE_FLAG_SCALABLE) == 0 || l.face->units_per_EM == 0)
    fail(ExitCode::inputOutput, "cannot use font {}: it has no outlines", file_.string());
  perUnit_ = 1.0 / static_cast<double>(l.face->units_per_EM);
  double height = 0;
  if (has(U'H'))
    for (const auto& polygon : glyph(U'H').outlines)
      for (const glm::dvec2& point : polygon) height = std::max(height, point.y);
  if (!(height > 0)) height = 0.7;  // Typical cap height, as a fraction of the em.
  perUnit_ /= height;
  glyphs_.clear();
}
Font::~Font() = default;

bool Font::has(char32_t character) const {
  return FT_Get_Char_Index(library_->face, character) != 0;
}

const Font::Glyph& Font::glyph(char32_t character) {
  const auto known = glyphs_.find(character);
  if (known != glyphs_.end()) return known->second;
  FT_Face face = library_->face;
  if (FT_Load_Glyph(face, FT_Get_Char_Index(face, character), FT_LOAD_NO_SCALE) != 0)
    fail(ExitCode::inputOutput, "cannot read font {}: the outline of U+{:04X} is damaged", file_.string(),
         static_cast<unsigned>(character));
  Pen pen{perUnit_, {}};
  FT_Outline_Funcs calls{};
  calls.move_to = Pen::move;
  calls.line_to = Pen::line;
  calls.conic_to = Pen::conic;
  calls.cubic_to = Pen::cubic;
  if (face->glyph->format == FT_GLYPH_FORMAT_OUTLINE &&
      FT_Outline_Decompose(&face->glyph->outline, &calls, &pen) != 0)
    fail(ExitCode::inputOutput, "cannot read font {}: the outline of U+{:04X} is damaged", file_.string(),
         static_cast<unsigned>(character));
  clean(pen.outlines);
  Glyph glyph{std::move(pen.outlines), perUnit_ * static_cast<double>(face->glyph->metrics.horiAdvance)};
  return glyphs_.emplace(character, std::move(glyph)).first->second;
}

double Font::kerning(char32_t first, char32_t second) const {
  FT_Face face = library_->face;
  if (!FT_HAS_KERNING(face)) return 0;
  FT_Vector kerningVector{};
  if (FT_Get_Kerning(face, FT_Get_Char_Index(face, first), FT_Get_Char_Index(face, second),
                     FT_KERNING_UNSCALED, &kerningVector) != 0)
    return 0;
  return perUnit_ * static_cast<double>(kerningVector.x);
}

double Font::lineHeight() const {
  return perUnit_ * static_cast<double>(library_->face->height);
}

}  // namespace simreel::sim
