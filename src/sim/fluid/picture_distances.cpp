// Computes distances to the bright area of an image. Near the edge the distances are exact; from there they
// are propagated outwards by sweeps (Zhao 2005, "A fast sweeping method for Eikonal equations").
#include "base/error.hpp"
#include "sim/fluid/solids.hpp"
#include "sim/grid/picture_file.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simreel::sim {

namespace {

constexpr int maxObstacleSide = 8192;
constexpr double unknown = 1e9;

std::vector<double> levelsOf(const Picture& picture) {
  std::vector<double> levels;
  levels.reserve(picture.rgba.size() / 4);
  for (int y = 0; y < picture.size.y; ++y)
    for (int x = 0; x < picture.size.x; ++x) levels.push_back(picture.level(x, y) / 255.0);
  return levels;
}

/// Solves |grad d| = 1 for d at a pixel. a and b are the smaller neighbour values along x and along y.
double eikonal(double a, double b) {
  const double low = std::min(a, b), high = std::max(a, b);
  if (high - low >= 1) return low + 1;
  return 0.5 * (a + b + std::sqrt(2 - (a - b) * (a - b)));
}

}  // namespace

PictureDistances::PictureDistances(const std::filesystem::path& file, double threshold) {
  const Picture picture = loadPicture(file, "obstacle image", maxObstacleSide);
  *this = PictureDistances(picture.size, levelsOf(picture), threshold);
}

PictureDistances::PictureDistances(glm::ivec2 size, const std::vector<double>& levels, double threshold)
    : size_(size + 2 * margin) {
  std::vector<double> field(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y),
                            threshold);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      field[static_cast<std::size_t>(y + margin) * static_cast<std::size_t>(size_.x) +
            static_cast<std::size_t>(x + margin)] -=
          levels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                 static_cast<std::size_t>(x)];
  measure(std::move(field));
}

// Computes signed distances. `field` is given at pixel centres, is negative inside, and crosses 0 linearly
// between pixels.
void PictureDistances::measure(std::vector<double> field) {
  const int w = size_.x, h = size_.y;
  const auto index = [w](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(w) + static_cast<std::size_t>(x);
  };
  std::vector<double>& d = distances_;
  d.assign(field.size(), unknown);
  std::vector<bool> known(field.size());
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      const double here = field[index(x, y)];
      const auto crossing = [&](int i, int j) {
        if (i < 0 || j < 0 || i >= w || j >= h) return unknown;
        const double there = field[index(i, j)];
        return (here < 0) == (there < 0) ? unknown : here / (here - there);
      };
      const double a = std::min(crossing(x - 1, y), crossing(x + 1, y));
      const double b = std::min(crossing(x, y - 1), crossing(x, y + 1));
      if (a >= unknown && b >= unknown) continue;
      known[index(x, y)] = true;
      const double minimum = std::min(a, b);
      d[index(x, y)] =
          a >= unknown || b >= unknown || minimum == 0 ? minimum : a * b / std::sqrt(a * a + b * b);
    }
  const auto visit = [&](int x, int y) {
    if (known[index(x, y)]) return;
    const double a =
        std::min(x > 0 ? d[index(x - 1, y)] : unknown, x + 1 < w ? d[index(x + 1, y)] : unknown);
    const double b =
        std::min(y > 0 ? d[index(x, y - 1)] : unknown, y + 1 < h ? d[index(x, y + 1)] : unknown);
    d[index(x, y)] = std::min(d[index(x, y)], eikonal(a, b));
  };
  for (int sweep = 0; sweep < 8; ++sweep)
    for (int j = 0; j < h; ++j)
      for (int i = 0; i < w; ++i) visit(sweep & 1 ? w - 1 - i : i, sweep & 2 ? h - 1 - j : j);
  for (std::size_t i = 0; i < d.size(); ++i)
    if (field[i] < 0) d[i] = -d[i];
}

double PictureDistances::at(glm::dvec2 p) const {
  if (size_.x == 0) return unknown;
  const glm::dvec2 node = p + (margin - 0.5);
  const glm::dvec2 held = glm::clamp(node, glm::dvec2(0), glm::dvec2(size_ - 1));
  const int x = std::min(static_cast<int>(held.x), size_.x - 2);
  const int y = std::min(static_cast<int>(held.y), size_.y - 2);
  const auto value = [&](int i, int j) {
    return distances_[static_cast<std::size_t>(j) * static_cast<std::size_t>(size_.x) +
                      static_cast<std::size_t>(i)];
  };
  const double s = held.x - x, t = held.y - y;
  const double upper = value(x, y) + (value(x + 1, y) - value(x, y)) * s;
  const double lower = value(x, y + 1) + (value(x + 1, y + 1) - value(x, y + 1)) * s;
  const glm::dvec2 off = node - held;
  return upper + (lower - upper) * t + std::sqrt(off.x * off.x + off.y * off.y);
}

}  // namespace simreel::sim
