#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::sim {

/// Number type of a PLY file.
struct PlyType {
  unsigned bytes = 4;
  char kind = 'f';  ///< kind of number: f for float, i for signed integer, u for unsigned integer
};

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> counts;  ///< if the property is a list: type of the list's length
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Returns the index of the first property with one of the names, or -1 if none exists.
  [[nodiscard]] int find(std::initializer_list<std::string_view> names, bool list = false) const;
};

/// Values of one item of an element.
class PlyItem {
 public:
  /// Returns all values of a list, or the single value of a scalar property.
  [[nodiscard]] std::span<const double> list(std::size_t property) const {
    const std::size_t from = property == 0 ? 0 : ends_[property - 1];
    return std::span<const double>(values_).subspan(from, ends_[property] - from);
  }
  [[nodiscard]] double operator[](std::size_t property) const { return list(property)[0]; }

 private:
  friend class PlyFile;
  std::vector<double> values_;
  std::vector<std::size_t> ends_;  ///< end index of each property's values
};

/// Reader of PLY files, either as text or as binary in either byte order (Greg Turk, The PLY Polygon File
/// Format, 1994). Text is read number by number; the last number of an item must end its line. Throws
/// PolygonProblem.
class PlyFile {
 public:
  /// Reads the header. Throws for an invalid line and for a count that is too large for the file's size.
  explicit PlyFile(std::string_view text);

  [[nodiscard]] const std::vector<PlyElement>& elements() const { return elements_; }
  [[nodiscard]] const std::vector<std::string>& comments() const { return comments_; }

  /// Callback for each item: the element's index, the item's index, its values.
  using Visit = std::function<void(std::size_t element, std::uint64_t item, const PlyItem& values)>;
  /// Reads the items in file order. Returns the number of bytes after the last item, not counting blanks.
  std::size_t read(const Visit& visit) const;

 private:
  void takeHeaderLine(std::string_view line, std::size_t number);
  void readText(const Visit& visit, std::string_view& rest) const;
  void readBinary(const Visit& visit, std::string_view& rest) const;

  std::vector<PlyElement> elements_;
  std::vector<std::string> comments_;
  bool binary_ = false, bigEndian_ = false;
  bool hasFormat_ = false;
  std::size_t bytes_;      ///< size of the whole file in bytes
  std::size_t lines_ = 0;  ///< number of header lines
  std::string_view body_;
};

}  // namespace simreel::sim
