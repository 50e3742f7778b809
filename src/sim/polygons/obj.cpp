#include "sim/polygons/obj.hpp"

#include "sim/polygons/cut.hpp"
#include "sim/polygons/problem.hpp"
#include "sim/polygons/words.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

template <std::size_t count>
bool isOneOf(std::string_view word, const std::array<std::string_view, count>& all) {
  return std::find(all.begin(), all.end(), word) != all.end();
}

constexpr std::array<std::string_view, 17> freeForm = {"vp",   "cstype", "deg",  "bmat", "step", "curv",
                                                       "parm", "curv2",  "surf", "trim", "hole", "scrv",
                                                       "sp",   "con",    "end",  "bzp",  "bsp"};
/// Keywords that are silently ignored: names and display hints for other programs.
constexpr std::array<std::string_view, 12> quiet = {
    "g", "o", "mg", "lod", "bevel", "c_interp", "d_interp", "ctech", "stech", "cdc", "cdp", "res"};

class ObjReader {
 public:
  ObjReader(std::string_view text, std::size_t maximum) : lines_(text), most_(maximum) {}

  ObjFile read() {
    if (lines_.rest().starts_with("\xFF\xFE") || lines_.rest().starts_with("\xFE\xFF"))
      throw PolygonProblem("is text of UTF-16; save it as UTF-8");
    for (std::string_view line; next(line);) {
      const std::string_view key = takeWord(line);
      if (!key.empty()) readStatement(key, line);
    }
    checkCorners();
    finishColors();
    for (const auto& [what, found] : left_)
      file_.notDrawn.push_back(found.count == 0 ? what : fmt::format("{} ({})", what, found.count));
    return std::move(file_);
  }

 private:
  [[noreturn]] void wrong(const std::string& why) const {
    throw PolygonProblem(fmt::format("has in line {} {}", first_, why));
  }

  /// Reads the next line together with its continuation lines, and removes comments.
  bool next(std::string_view& line) {
    if (!lines_.next(line)) return false;
    first_ = lines_.number();
    if (first_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    std::string_view words = line;
    const std::string_view key = takeWord(words);
    const bool ofNames = key == "usemtl" || key == "mtllib" || key == "g" || key == "o";
    line = withoutBlanks(withoutComment(line, ofNames));
    if (!line.ends_with('\\')) return true;
    joined_.clear();
    while (line.ends_with('\\')) {
      line.remove_suffix(1);
      joined_.append(line).append(" ");
      if (!lines_.next(line)) line = {};
      line = withoutBlanks(withoutComment(line, ofNames));
    }
    joined_.append(line);
    line = joined_;
    return true;
  }

  void readStatement(std::string_view key, std::string_view rest) {
    if (key == "v") {
      place(rest);
    } else if (key == "vt") {
      const auto values = numbers<3>(rest, 1);
      add(file_.uvs, glm::vec2(values[0], values[1]));
    } else if (key == "vn") {
      const auto values = numbers<3>(rest, 3);
      add(file_.normals, glm::vec3(values[0], values[1], values[2]));
    } else if (key == "f" || key == "fo") {
      face(rest);
    } else if (key == "s") {
      smooth(rest);
    } else if (key == "usemtl") {
      material(withoutBlanks(rest));
    } else if (key == "mtllib") {
      if (const auto names = withoutBlanks(rest); !names.empty()) file_.libraries.emplace_back(names);
    } else if (key == "l" || key == "p") {
      ++left_[key == "l" ? "lines" : "points"].count;
    } else if (isOneOf(key, freeForm)) {
      left_.try_emplace("curves and surfaces of free form");
    } else if (!isOneOf(key, quiet) && left_.size() < maxKinds) {
      ++left_[fmt::format("lines that begin with {}", inQuotes(key))].count;
    }
  }

  template <class T>
  void add(std::vector<T>& list, const T& item) const {
    if (list.size() >= most_) wrong(fmt::format("the {}th of its kind; simplify it", most_ + 1));
    list.push_back(item);
  }

  float number(std::string_view word) const {
    const auto value = floatIn(word);
    if (!value) wrong(fmt::format("{}, where a number is expected", inQuotes(word)));
    if (!std::isfinite(*value)) wrong(fmt::format("{}, which is not finite", inQuotes(word)));
    return *value;
  }

  /// Parses the numbers of a line, of which there must be at least `minimum`. Missing numbers are 0.
  template <std::size_t count>
  std::array<float, count> numbers(std::string_view rest, std::size_t minimum) const {
    std::array<float, count> values{};
    std::size_t found = 0;
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
      if (found == count) wrong(fmt::format("more than {} numbers", count));
      values[found++] = number(word);
    }
    if (found < minimum) wrong(fmt::format("{} numbers, and {} are expected", found, minimum));
    return values;
  }

  /// Parses a position: x y z, optionally followed by a weight and a colour.
  void place(std::string_view rest) {
    std::array<float, 7> values{};
    std::size_t found = 0;
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
      if (found == values.size()) wrong("a vertex of more than 7 numbers");
      values[found++] = number(word);
    }
    if (found < 3 || found == 5)
      wrong(
          fmt::format("a vertex of {} numbers; there are 3, then a weight, a colour of 3, or both", found));
    add(file_.places, glm::vec3(values[0], values[1], values[2]));
    if (found < 6) return;
    file_.colors.resize(file_.places.size() - 1, glm::vec3(1));
    file_.colors.emplace_back(values[found - 3], values[found - 2], values[found - 1]);
  }

  /// Converts a corner's index into a list of `size` items, counted from 1, or backwards from the latest
  /// item if it is negative. Indices of items that follow later are checked at the end.
  int index(std::string_view digits, std::size_t size, const char* what) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || value == 0 ||
        std::abs(value) > std::numeric_limits<int>::max())
      wrong(fmt::format("{}, which is no number of a {}", inQuotes(digits), what));
    if (value < 0) value += static_cast<std::int64_t>(size) + 1;
    if (value < 1) wrong(fmt::format("{}, and there are {} before", inQuotes(digits), size));
    return static_cast<int>(value - 1);
  }

  /// Parses a corner: "1", "1/2", "1//3" or "1/2/3".
  ObjFile::Corner corner(std::string_view word) {
    std::array<std::string_view, 3> parts;
    std::string_view left = word;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t end = std::min(left.find('/'), left.size());
      parts[i] = left.substr(0, end);
      left.remove_prefix(std::min(end + 1, left.size()));
      if (i == 2 && (end < left.size() || !left.empty()))
        wrong(fmt::format("{}, which is no corner of a face", inQuotes(word)));
    }
    return {index(parts[0], file_.places.size(), "vertex"),
            parts[1].empty() ? -1 : index(parts[1], file_.uvs.size(), "texture coordinate"),
            parts[2].empty() ? -1 : index(parts[2], file_.normals.size(), "normal")};
  }

  void face(std::string_view rest) {
    ObjFile::Face face{file_.corners.size(), 0, material_, smooth_};
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
      file_.corners.push_back(corner(word));
      if (face.count++ < maxCorners) continue;
      while (!takeWord(rest).empty()) ++face.count;
      throw PolygonProblem(fmt::format("has a face of {} corners (line {}), more than {}; cut it up",
                                       face.count, first_, maxCorners));
    }
    if (face.count < 3) {
      file_.corners.resize(face.first);
      ++left_["faces of fewer than three corners"].count;
      return;
    }
    if (file_.corners.size() > 3 * most_) wrong(fmt::format("the {}th corner; simplify it", 3 * most_ + 1));
    for (std::size_t i = face.first; i < file_.corners.size(); ++i)
      if (const int place = file_.corners[i].place; place > farthest_.number) farthest_ = {place, first_};
    add(file_.faces, face);
  }

  void smooth(std::string_view rest) {
    const std::string_view word = takeWord(rest);
    smooth_ = 0;
    if (word.empty() || word == "off") return;
    if (word == "on") {
      smooth_ = 1;
      return;
    }
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), smooth_);
    if (error != std::errc() || end != word.data() + word.size())
      wrong(fmt::format("{}, which is no smoothing group", inQuotes(word)));
  }

  void material(std::string_view name) {
    material_ = -1;
    if (name.empty()) return;
    const auto [at, fresh] = numbers_.try_emplace(std::string(name), static_cast<int>(numbers_.size()));
    if (fresh) file_.materials.emplace_back(name);
    material_ = at->second;
  }

  /// Checks the indices of all corners. This happens at the end, because faces may precede the items that
  /// they refer to. Missing uvs and normals are only reported, because some programs write indices of
  /// normals but no normals.
  void checkCorners() {
    if (farthest_.number >= static_cast<int>(file_.places.size()))
      throw PolygonProblem(fmt::format("has in line {} a face with vertex {}, and there are {}",
                                       farthest_.line, farthest_.number + 1, file_.places.size()));
    const auto check = [&](int& number, std::size_t size, const char* what) {
      if (number < static_cast<int>(size)) return;
      number = -1;
      ++left_[what].count;
    };
    for (ObjFile::Corner& corner : file_.corners) {
      check(corner.uv, file_.uvs.size(), "texture coordinates that are named and missing");
      check(corner.normal, file_.normals.size(), "normals that are named and missing");
    }
  }

  void finishColors() {
    if (!file_.colors.empty()) file_.colors.resize(file_.places.size(), glm::vec3(1));
  }

  /// Maximum vertex index, and the first line that contains it.
  struct Farthest {
    int number = -1;
    std::size_t line = 0;
  };
  struct Left {
    std::size_t count = 0;
  };
  static constexpr std::size_t maxKinds = 12;

  TextLines lines_;
  std::size_t most_;
  std::size_t first_ = 0;  ///< number of the current line; if it has continuation lines, number of the
                           ///< first of them
  std::string joined_;
  ObjFile file_;
  int material_ = -1;
  unsigned smooth_ = 0;
  Farthest farthest_;
  std::map<std::string, int, std::less<>> numbers_;
  std::map<std::string, Left> left_;
};

}  // namespace

ObjFile parseObj(std::string_view text, std::size_t maximum) {
  return ObjReader(text, maximum).read();
}

}  // namespace simreel::sim
