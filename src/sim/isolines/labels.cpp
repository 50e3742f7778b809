#include "sim/isolines/labels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

// Distances in units of the cap height: between a label and its line, and between a label and the lines
// above and below it.
constexpr double gap = 0.45, gapAbove = 0.25;
constexpr double stride = 5;        // distance in pixels between two candidate positions
constexpr double maxBend = 0.35;    // maximum bend of the line below a label, in units of the cap height
constexpr double apartOnLine = 40;  // distance between labels on one line, in units of the cap height
constexpr double cell = 3;          // width in pixels of a cell of LineMap

/// Line with the arc length at each point. A closed line ends with its first point.
class MeasuredLine {
 public:
  explicit MeasuredLine(const IsoLine& line) : points_(line.points), closed_(line.closed) {
    if (closed_) points_.push_back(points_.front());
    lengths_ = {0};
    for (std::size_t i = 1; i < points_.size(); ++i)
      lengths_.push_back(lengths_.back() + glm::distance(points_[i - 1], points_[i]));
  }
  [[nodiscard]] double length() const { return lengths_.back(); }
  [[nodiscard]] glm::dvec2 at(double way) const {
    if (closed_ && way < 0) way += length();
    if (closed_ && way > length()) way -= length();
    const std::size_t i = indexAt(way);
    const double part = (way - lengths_[i]) / std::max(lengths_[i + 1] - lengths_[i], 1e-12);
    return points_[i] + std::clamp(part, 0.0, 1.0) * (points_[i + 1] - points_[i]);
  }

 private:
  [[nodiscard]] std::size_t indexAt(double way) const {
    const auto above = std::upper_bound(lengths_.begin(), lengths_.end(), way);
    const auto i = static_cast<std::size_t>(above - lengths_.begin());
    return std::clamp<std::size_t>(i, 1, lengths_.size() - 1) - 1;
  }

  std::vector<glm::dvec2> points_;
  bool closed_;
  std::vector<double> lengths_;
};

/// Grid over the picture. Each cell stores the index of the only line near the cell, or `several` if there
/// are more lines.
class LineMap {
 public:
  explicit LineMap(const glm::dvec4& part)
      : corner_(part.x, part.y),
        size_(glm::max(glm::ivec2(glm::ceil((glm::dvec2(part.z, part.w) - corner_) / cell)), 1)),
        lines_(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y), none) {}

  void add(const MeasuredLine& line, int index) {
    for (double way = 0; way <= line.length(); way += 0.5 * cell) {
      int& there = lines_[indexOf(line.at(way))];
      there = there == none || there == index ? index : several;
    }
  }
  /// Returns true if a line other than `line` passes near a position.
  [[nodiscard]] bool hasOther(glm::dvec2 place, int line) const {
    const int found = lines_[indexOf(place)];
    return found != none && found != line;
  }

 private:
  static constexpr int none = -1, several = -2;

  [[nodiscard]] std::size_t indexOf(glm::dvec2 place) const {
    const glm::ivec2 in =
        glm::clamp(glm::ivec2(glm::floor((place - corner_) / cell)), glm::ivec2(0), size_ - 1);
    return static_cast<std::size_t>(in.y) * static_cast<std::size_t>(size_.x) +
           static_cast<std::size_t>(in.x);
  }

  glm::dvec2 corner_;
  glm::ivec2 size_;
  std::vector<int> lines_;
};

class Placement {
 public:
  Placement(std::span<const IsoLine> lines, const IsoLabelSizes& sizes, const glm::dvec4& part)
      : lines_(lines), sizes_(sizes), part_(part), all_(part), numbered_(part) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const MeasuredLine line(lines[i]);
      all_.add(line, static_cast<int>(i));
      if (widthOf(i) > 0) numbered_.add(line, static_cast<int>(i));
    }
  }

  [[nodiscard]] std::vector<IsoLabel> place() {
    for (const LineMap* avoided : {&all_, &numbered_})
      for (std::size_t i = 0; i < lines_.size(); ++i)
        if (widthOf(i) > 0) placeOn(i, *avoided);
    return placed_;
  }

 private:
  [[nodiscard]] double widthOf(std::size_t line) const {
    return sizes_.widths[static_cast<std::size_t>(lines_[line].level)];
  }

  /// Places labels on a line, until it has as many as its length allows or until no position is left.
  void placeOn(std::size_t index, const LineMap& avoided) {
    const MeasuredLine line(lines_[index]);
    const auto count = std::count_if(placed_.begin(), placed_.end(),
                                     [&](const IsoLabel& label) { return label.line == index; });
    const int maximum = 1 + static_cast<int>(line.length() / (apartOnLine * sizes_.capital));
    // If lines are crowded, one label is enough.
    if (&avoided == &numbered_ && count > 0) return;
    for (auto k = static_cast<int>(count); k < maximum; ++k) {
      const std::optional<IsoLabel> label = best(line, index, avoided);
      if (!label) return;
      placed_.push_back(*label);
    }
  }

  [[nodiscard]] std::optional<IsoLabel> best(const MeasuredLine& line, std::size_t index,
                                             const LineMap& avoided) const {
    const double half = 0.5 * widthOf(index) + gap * sizes_.capital;
    const double margin = lines_[index].closed ? 0 : half + sizes_.capital;
    constexpr double minRemainder = 2.5;  // minimum length of a line, in units of the label's width
    if (line.length() < minRemainder * 2 * half) return std::nullopt;
    std::optional<IsoLabel> found;
    double minimum = maxBend * sizes_.capital;
    for (double way = margin; way <= line.length() - margin; way += stride) {
      const glm::dvec2 from = line.at(way - half), to = line.at(way + half);
      const double chord = glm::distance(from, to);
      if (chord < 1.8 * half) continue;
      IsoLabel label{index, {}, (to - from) / chord, widthOf(index)};
      const glm::dvec2 normal(-label.along.y, label.along.x);
      double bent = 0, mean = 0;
      for (int i = 0; i <= 8; ++i) {
        const double beside = glm::dot(line.at(way + half * (i - 4) / 4) - from, normal);
        bent = std::max(bent, std::abs(beside));
        mean += beside / 9;
      }
      label.middle = 0.5 * (from + to) + mean * normal;
      if (label.along.x < 0 || (label.along.x == 0 && label.along.y > 0)) label.along = -label.along;
      // Horizontal text is easier to read than steep text.
      const double cost = bent + 0.1 * sizes_.capital * std::abs(label.along.y);
      if (cost >= minimum || !fits(label, avoided)) continue;
      minimum = cost;
      found = label;
    }
    return found;
  }

  /// Returns true if the label is in the field's part of the picture, does not cover a line in `avoided`,
  /// and is far enough from other labels.
  [[nodiscard]] bool fits(const IsoLabel& label, const LineMap& avoided) const {
    const double u = sizes_.capital;
    for (const IsoLabel& other : placed_) {
      const double minDistance =
          other.line == label.line ? apartOnLine * u : 0.5 * (label.width + other.width) + u;
      if (glm::distance(other.middle, label.middle) < minDistance) return false;
    }
    const glm::dvec2 up(label.along.y, -label.along.x);
    const double half = 0.5 * label.width + 0.5 * u;
    for (double x = -half; x <= half; x += cell)
      for (const double y : {-u, -0.5 * u, 0.0, 0.5 * u, u}) {
        const glm::dvec2 place = label.middle + x * label.along + y * up;
        if (place.x < part_.x + u || place.y < part_.y + u || place.x > part_.z - u ||
            place.y > part_.w - u)
          return false;
        if (avoided.hasOther(place, static_cast<int>(label.line))) return false;
      }
    return true;
  }

  std::span<const IsoLine> lines_;
  const IsoLabelSizes& sizes_;
  glm::dvec4 part_;
  LineMap all_, numbered_;
  std::vector<IsoLabel> placed_;
};

/// Removes those parts of a line's pieces that are inside a label's box.
std::vector<IsoLine> withoutBox(const std::vector<IsoLine>& parts, const IsoLabel& label, double capital) {
  const glm::dvec2 half(0.5 * label.width + gap * capital, (0.5 + gapAbove) * capital);
  const glm::dvec2 up(label.along.y, -label.along.x);
  const glm::dvec4 box(-half, half);
  std::vector<IsoLine> rest;
  for (const IsoLine& part : parts) {
    std::vector<glm::dvec2> places = part.points;
    if (part.closed) places.push_back(places.front());
    std::vector<IsoLine> pieces(1, IsoLine{{places.front()}, false, part.level});
    bool cut = false;
    for (std::size_t i = 1; i < places.size(); ++i) {
      const glm::dvec2 a = places[i - 1], b = places[i];
      const glm::dvec2 share =
          shareWithin({glm::dot(a - label.middle, label.along), glm::dot(a - label.middle, up)},
                      {glm::dot(b - label.middle, label.along), glm::dot(b - label.middle, up)}, box);
      if (share.x < share.y) {
        cut = true;
        pieces.back().points.push_back(a + share.x * (b - a));
        pieces.push_back({{a + share.y * (b - a)}, false, part.level});
      }
      pieces.back().points.push_back(b);
    }
    if (!cut) {
      rest.push_back(part);
      continue;
    }
    // The last piece of a closed line continues in the first piece.
    if (part.closed && pieces.size() > 1) {
      auto& first = pieces.front().points;
      pieces.back().points.insert(pieces.back().points.end(), first.begin() + 1, first.end());
      pieces.erase(pieces.begin());
    }
    for (IsoLine& piece : pieces) {
      double length = 0;
      for (std::size_t i = 1; i < piece.points.size(); ++i)
        length += glm::distance(piece.points[i - 1], piece.points[i]);
      if (length > 0.5) rest.push_back(std::move(piece));
    }
  }
  return rest;
}

}  // namespace

std::vector<IsoLabel> placeLabels(std::span<const IsoLine> lines, const IsoLabelSizes& sizes,
                                  const glm::dvec4& part) {
  return Placement(lines, sizes, part).place();
}

std::vector<IsoLine> withoutLabels(const IsoLine& line, std::span<const IsoLabel> labels, double capital) {
  std::vector<IsoLine> parts = {line};
  for (const IsoLabel& label : labels) parts = withoutBox(parts, label, capital);
  return parts;
}

}  // namespace simreel::sim
