#include "sim/fluid/solids.hpp"

#include "sim/core/turn.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

namespace simreel::sim {

namespace {

constexpr double far = 8;  ///< Maximum distance in cells; larger distances are clamped to it.
constexpr double minOpening =
    1 / 16.0;  ///< Minimum open fraction of a face; a face with a smaller opening is closed.

/// Obstacle at its position at a given time.
class PlacedObstacle {
 public:
  PlacedObstacle(const FluidObstacle& what, const PictureDistances& picture, double time)
      : what_(what), picture_(picture) {
    const glm::vec3 center = what.center.at(time);
    center_ = {center.x, center.y};
    const glm::vec2 turn = cosineAndSine(what.turn.at(time));
    cos_ = turn.x;
    sin_ = turn.y;
    half_ = 0.5 * glm::max(glm::dvec2(what.extent), glm::dvec2(1));
    const glm::dvec2 pixels = 0.5 * double{what.scale} * glm::dvec2(picture.size());
    const glm::dvec2 corner = what.shape == FluidObstacle::Shape::image ? pixels : half_;
    reach_ = what.shape == FluidObstacle::Shape::circle
                 ? what.radius
                 : std::sqrt(corner.x * corner.x + corner.y * corner.y);
  }

  /// Returns the signed distance from a point to the obstacle, in cells.
  [[nodiscard]] double distance(glm::dvec2 p) const {
    const glm::dvec2 d = p - center_;
    if (what_.shape == FluidObstacle::Shape::circle) return std::sqrt(d.x * d.x + d.y * d.y) - what_.radius;
    const glm::dvec2 own(cos_ * d.x + sin_ * d.y, cos_ * d.y - sin_ * d.x);
    if (what_.shape == FluidObstacle::Shape::image) {
      const double scale = what_.scale;
      return scale * picture_.at(own / scale + 0.5 * glm::dvec2(picture_.size()));
    }
    const glm::dvec2 beyond = glm::abs(own) - half_;
    const glm::dvec2 out = glm::max(beyond, glm::dvec2(0));
    return std::min(std::max(beyond.x, beyond.y), 0.0) + std::sqrt(out.x * out.x + out.y * out.y);
  }
  [[nodiscard]] glm::dvec2 center() const { return center_; }
  [[nodiscard]] double reach() const { return reach_; }

 private:
  const FluidObstacle& what_;
  const PictureDistances& picture_;
  glm::dvec2 center_, half_;
  double cos_, sin_, reach_;
};

/// Returns the fraction of an edge that is outside obstacles, from the signed distances at the edge's ends.
double openShare(double a, double b) {
  if (a > 0 && b > 0) return 1;
  if (a <= 0 && b <= 0) return 0;
  const double share = std::max(a, b) / (std::max(a, b) - std::min(a, b));
  return share < minOpening ? 0 : share;
}

}  // namespace

/// Signed distances at cell corners and centres, and the index of the nearest obstacle.
struct FluidSolids::Nearest {
  glm::ivec2 size;
  std::vector<double> corners, middles;
  std::vector<std::uint8_t> which;

  explicit Nearest(glm::ivec2 cells)
      : size(cells), corners(count(cells + 1), far), middles(count(cells), far), which(count(cells)) {}
  static std::size_t count(glm::ivec2 n) {
    return static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y);
  }
  [[nodiscard]] double& corner(int x, int y) {
    return corners[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x + 1) +
                   static_cast<std::size_t>(x)];
  }

  void add(const PlacedObstacle& obstacle, std::uint8_t number) {
    const double reach = obstacle.reach() + far;
    const glm::dvec2 maximum = glm::dvec2(size);
    const glm::ivec2 from = glm::clamp(glm::floor(obstacle.center() - reach), glm::dvec2(0), maximum);
    const glm::ivec2 to = glm::clamp(glm::ceil(obstacle.center() + reach), glm::dvec2(0), maximum);
    for (int y = from.y; y <= to.y; ++y)
      for (int x = from.x; x <= to.x; ++x) {
        corner(x, y) = std::min(corner(x, y), obstacle.distance({x, y}));
        if (x == size.x || y == size.y) continue;
        const std::size_t cell =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
        const double middle = obstacle.distance({x + 0.5, y + 0.5});
        if (middle >= middles[cell]) continue;
        middles[cell] = middle;
        which[cell] = number;
      }
  }
  /// Returns the distance at a cell centre in the fixed-point units of the kernels.
  [[nodiscard]] int units(int x, int y) const {
    const int i = (x + size.x) % size.x, j = (y + size.y) % size.y;
    const double distance = middles[static_cast<std::size_t>(j) * static_cast<std::size_t>(size.x) +
                                    static_cast<std::size_t>(i)];
    return static_cast<int>(std::lround(std::clamp(distance, -far, far) * 2048));
  }
  /// Closes the faces of cells all of whose faces are held by a wall (heldU of glsl/fluid/walls.glsl).
  /// Pressure would not act on the flow in such cells, so the flow would never come to rest.
  void closeSlivers(glm::bvec2 wraps, std::vector<double>& left, std::vector<double>& top) const {
    const auto leftAt = [&](int x, int y) -> double& {
      return left[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x + 1) +
                  static_cast<std::size_t>(x)];
    };
    const auto topAt = [&](int x, int y) -> double& {
      return top[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                 static_cast<std::size_t>(x)];
    };
    const auto freeX = [&](int x, int y) {
      const bool border = !wraps.x && (x == 0 || x == size.x);
      return leftAt(x, y) > 0 &&
             (border || std::lround(leftAt(x, y) * 4096) >= 4096 || units(x - 1, y) + units(x, y) > 0);
    };
    const auto freeY = [&](int x, int y) {
      const bool border = !wraps.y && (y == 0 || y == size.y);
      return topAt(x, y) > 0 &&
             (border || std::lround(topAt(x, y) * 4096) >= 4096 || units(x, y - 1) + units(x, y) > 0);
    };
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const bool cut = leftAt(x, y) < 1 || leftAt(x + 1, y) < 1 || topAt(x, y) < 1 || topAt(x, y + 1) < 1;
        if (!cut || freeX(x, y) || freeX(x + 1, y) || freeY(x, y) || freeY(x, y + 1)) continue;
        leftAt(x, y) = leftAt(x + 1, y) = topAt(x, y) = topAt(x, y + 1) = 0;
        if (wraps.x && x == 0) leftAt(size.x, y) = 0;
        if (wraps.x && x + 1 == size.x) leftAt(0, y) = 0;
        if (wraps.y && y == 0) topAt(x, size.y) = 0;
        if (wraps.y && y + 1 == size.y) topAt(x, 0) = 0;
      }
  }
  /// Sets the first and the last corners on periodic axes, which are the same points, to the smaller of
  /// their distances.
  void join(glm::bvec2 wraps) {
    for (int y = 0; wraps.x && y <= size.y; ++y)
      corner(0, y) = corner(size.x, y) = std::min(corner(0, y), corner(size.x, y));
    for (int x = 0; wraps.y && x <= size.x; ++x)
      corner(x, 0) = corner(x, size.y) = std::min(corner(x, 0), corner(x, size.y));
  }
  [[nodiscard]] FluidLevels levels(const FluidParameters& p) {
    std::vector<double> left(count({size.x + 1, size.y})), top(count({size.x, size.y + 1}));
    const auto shut = [](const FluidSide& s) {
      return s.kind != FluidSide::Kind::open && s.kind != FluidSide::Kind::periodic;
    };
    std::size_t face = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x <= size.x; ++x, ++face)
        if (!(x == 0 && shut(p.left)) && !(x == size.x && shut(p.right)))
          left[face] = openShare(corner(x, y), corner(x, y + 1));
    face = 0;
    for (int y = 0; y <= size.y; ++y)
      for (int x = 0; x < size.x; ++x, ++face)
        if (!(y == 0 && shut(p.top)) && !(y == size.y && shut(p.bottom)))
          top[face] = openShare(corner(x, y), corner(x + 1, y));
    if (!p.obstaclesSlip) closeSlivers({p.wrapsX(), p.wrapsY()}, left, top);
    return {size, std::move(left), std::move(top), {p.wrapsX(), p.wrapsY()}};
  }
};

namespace {

template <class N>
N nearestObstacles(const FluidParameters& p, const std::vector<PictureDistances>& pictures, double time) {
  N nearest(p.size);
  for (std::size_t i = 0; i < p.obstacles.size(); ++i)
    nearest.add(PlacedObstacle(p.obstacles[i], pictures[i], time), static_cast<std::uint8_t>(i));
  nearest.join({p.wrapsX(), p.wrapsY()});
  return nearest;
}

}  // namespace

FluidSolids::FluidSolids(const FluidParameters& p, const std::vector<PictureDistances>& pictures,
                         double time, double dt, const shader::FluidStep& sides)
    : FluidSolids(p, nearestObstacles<Nearest>(p, pictures, time)) {
  for (std::size_t i = 0; i < p.obstacles.size(); ++i) {
    const FluidObstacle& o = p.obstacles[i];
    if (!o.moves()) continue;
    const glm::dvec3 now = o.center.at(time), before = o.center.at(time - dt);
    const double turned = double{o.turn.at(time)} - double{o.turn.at(time - dt)};
    shader::FluidSolid& solid = set_.solids[i];
    solid.place = {static_cast<float>(now.x), static_cast<float>(now.y),
                   static_cast<float>(turned * (std::numbers::pi / 180) / dt), 0};
    solid.velocity = {static_cast<float>((now.x - before.x) / dt),
                      static_cast<float>((now.y - before.y) / dt), 0, 0};
  }
  if (p.pocketsGrow()) balance(p, sides);
}

FluidSolids::FluidSolids(const FluidParameters& p, Nearest nearest)
    : size_(p.size), levels_(nearest.levels(p)) {
  findSolid();
  words_ = levels_.weights();
  if (!p.obstacles.empty()) addDistances(p, nearest);
  tilesStart_ = static_cast<int>(words_.size());
  const std::vector<glm::uvec4> tiles = levels_.tileLists(tileGroups_);
  words_.insert(words_.end(), tiles.begin(), tiles.end());
}

void FluidSolids::addDistances(const FluidParameters& p, const Nearest& nearest) {
  findPockets({p.wrapsX(), p.wrapsY()});
  words_.resize(words_.size() + static_cast<std::size_t>(levels_.levels().front().elements()),
                glm::uvec4(0));
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; ++x) {
      const auto units = static_cast<std::uint32_t>(nearest.units(x, y) + 32768);
      wordOf(x, y) = units | static_cast<std::uint32_t>(nearest.which[cell(x, y)]) << 16U;
    }
}

std::uint32_t& FluidSolids::wordOf(int x, int y) {
  const int block = solidsStart() + y / 2 * (size_.x / 2 + 1) + x / 2;
  return words_[static_cast<std::size_t>(block)][y % 2 * 2 + x % 2];
}

std::uint32_t FluidSolids::wordAt(int x, int y) const {
  const int block = solidsStart() + y / 2 * (size_.x / 2 + 1) + x / 2;
  return words_[static_cast<std::size_t>(block)][y % 2 * 2 + x % 2];
}

glm::vec2 FluidSolids::face(int x, int y) const {
  const int block = y / 2 * (size_.x / 2 + 1) + x / 2;
  return shader::faceWeights(levels_.weights()[static_cast<std::size_t>(block)][y % 2 * 2 + x % 2]);
}

glm::dvec4 FluidSolids::closedAt(int x, int y) const {
  const glm::dvec2 here = face(x, y);
  const auto closed = [](bool border, double open) { return border ? 0 : 1 - open; };
  return {closed(x == 0, here.x), closed(x + 1 == size_.x, face(x + 1, y).x), closed(y == 0, here.y),
          closed(y + 1 == size_.y, face(x, y + 1).y)};
}

glm::dvec2 FluidSolids::velocityAt(glm::ivec2 cell, glm::dvec2 point) const {
  const shader::FluidSolid& s = set_.solids[wordAt(cell.x, cell.y) >> 16U & 255U];
  return {s.velocity.x - double{s.place.z} * (point.y - s.place.y),
          s.velocity.y + double{s.place.z} * (point.x - s.place.x)};
}

void FluidSolids::findSolid() {
  solid_.resize(Nearest::count(size_));
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; ++x) {
      const glm::vec2 here = face(x, y);
      const bool open = here.x > 0 || here.y > 0 || face(x + 1, y).x > 0 || face(x, y + 1).y > 0;
      solid_[cell(x, y)] = open ? 0 : 1;
    }
}

// Finds connected regions by union-find over open cells. Each cell is joined to its left and upper
// neighbours; the root of a region is its first cell.
void FluidSolids::findPockets(glm::bvec2 wraps) {
  pocketOf_.resize(solid_.size());
  for (std::size_t i = 0; i < pocketOf_.size(); ++i) pocketOf_[i] = static_cast<int>(i);
  const auto root = [&](int i) {
    while (pocketOf_[static_cast<std::size_t>(i)] != i) {
      int& up = pocketOf_[static_cast<std::size_t>(i)];
      up = pocketOf_[static_cast<std::size_t>(up)];
      i = up;
    }
    return i;
  };
  const auto join = [&](std::size_t a, std::size_t b) {
    const int one = root(static_cast<int>(a)), other = root(static_cast<int>(b));
    pocketOf_[static_cast<std::size_t>(std::max(one, other))] = std::min(one, other);
  };
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; ++x) {
      const glm::vec2 open = face(x, y);
      if (open.x > 0 && (x > 0 || wraps.x)) join(cell(x, y), cell(x > 0 ? x - 1 : size_.x - 1, y));
      if (open.y > 0 && (y > 0 || wraps.y)) join(cell(x, y), cell(x, y > 0 ? y - 1 : size_.y - 1));
    }
  for (std::size_t i = 0; i < pocketOf_.size(); ++i) {
    if (solid_[i] != 0)
      pocketOf_[i] = -1;
    else if (pocketOf_[i] == static_cast<int>(i))
      pocketOf_[i] = pockets_++;
    else
      pocketOf_[i] = pocketOf_[static_cast<std::size_t>(
          pocketOf_[i])];  // The root precedes this cell, so the root's pocket number is already assigned.
  }
}

// Computes the divergence that compensates the net flux of moving obstacles and of the grid's sides into
// each pocket without an open side. It is equal per fluid area in the whole pocket. The net flux is summed
// over the closed parts of all cell faces; faces between two cells of the pocket cancel.
void FluidSolids::balance(const FluidParameters& p, const shader::FluidStep& sides) {
  const glm::bvec2 wraps(p.wrapsX(), p.wrapsY());
  const auto solidAt = [&](int x, int y) {
    return wordAt((x + size_.x) % size_.x, (y + size_.y) % size_.y);
  };
  const auto speed = [&](bool alongX, std::uint32_t a, std::uint32_t b, double x, double y) {
    const std::uint32_t word = (b & 0xffffU) < (a & 0xffffU) ? b : a;
    const shader::FluidSolid& s = set_.solids[word >> 16U & 255U];
    return alongX ? s.velocity.x - double{s.place.z} * (y - s.place.y)
                  : s.velocity.y + double{s.place.z} * (x - s.place.x);
  };
  std::vector<double> out(static_cast<std::size_t>(pockets_));
  std::vector<double> area(out.size());
  std::vector<bool> open(out.size());
  const auto through = [&](bool border, bool periodic, double weight, double side, double solid) {
    if (border && !periodic) return weight > 0 ? 0.0 : side;
    return weight < 1 ? (1 - weight) * solid : 0.0;
  };
  const auto acrossX = [&](int x, int y) {
    const bool border = x == 0 || x == size_.x;
    const double weight = face(x, y).x;
    if (weight >= 1) return 0.0;
    const double side = shader::sideSpeed(y, size_.y, x == 0 ? sides.leftRight.x : sides.leftRight.z,
                                          x == 0 ? sides.parabolas.x : sides.parabolas.y);
    return through(border, wraps.x, weight, side,
                   speed(true, solidAt(x - 1, y), solidAt(x, y), x, y + 0.5));
  };
  const auto acrossY = [&](int x, int y) {
    const bool border = y == 0 || y == size_.y;
    const double weight = face(x, y).y;
    if (weight >= 1) return 0.0;
    const double side = shader::sideSpeed(x, size_.x, y == 0 ? sides.topBottom.y : sides.topBottom.w,
                                          y == 0 ? sides.parabolas.z : sides.parabolas.w);
    return through(border, wraps.y, weight, side,
                   speed(false, solidAt(x, y - 1), solidAt(x, y), x + 0.5, y));
  };
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; ++x) {
      const int pocket = pocketOf_[cell(x, y)];
      if (pocket < 0) continue;
      const auto i = static_cast<std::size_t>(pocket);
      out[i] += acrossX(x + 1, y) - acrossX(x, y) + acrossY(x, y + 1) - acrossY(x, y);
      area[i] += std::clamp(0.5 + distanceAt(x, y), 0.0,
                            1.0);  // Open fraction of the cell, computed like openPart of
                                   // glsl/fluid/projected.glsl.
      const bool lets = (x == 0 && !wraps.x && face(0, y).x > 0) ||
                        (x + 1 == size_.x && !wraps.x && face(size_.x, y).x > 0) ||
                        (y == 0 && !wraps.y && face(x, 0).y > 0) ||
                        (y + 1 == size_.y && !wraps.y && face(x, size_.y).y > 0);
      if (lets) open[i] = true;
    }
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = open[i] || area[i] <= 0 ? 0 : out[i] / area[i];
  growPockets(out);
}

// Assigns a number to each pocket that absorbs volume, and stores it in the words of the pocket's cells.
void FluidSolids::growPockets(const std::vector<double>& each) {
  std::vector<std::uint32_t> number(each.size());
  std::uint32_t used = 0;
  for (std::size_t i = 0; i < each.size(); ++i) {
    if (std::abs(each[i]) < 1e-9 || used == shader::maxPockets) continue;
    number[i] = ++used;
    set_.growth[used / 4][static_cast<int>(used % 4)] = static_cast<float>(each[i]);
  }
  grows_ = used > 0;
  if (!grows_) return;
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; ++x) {
      const int pocket = pocketOf_[cell(x, y)];
      if (pocket >= 0) wordOf(x, y) |= number[static_cast<std::size_t>(pocket)] << 24U;
    }
}

}  // namespace simreel::sim
