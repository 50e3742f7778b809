#include "draw/environment.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/ieee.hpp"
#include "draw/draw_state.hpp"
#include "sim/light/surroundings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <tbb/parallel_for.h>

namespace simreel::draw {

namespace {

using std::numbers::pi;
constexpr int finestSide = 1024, coarsestSide = 64;  // limits of the side of the finest map
constexpr int terms = 9;

/// An equirectangular image that is rotated around the vertical axis.
class Panorama {
 public:
  Panorama(const sim::LightFile& file, double strength, double turn)
      : size_(file.size), turned_(turn / 360) {
    for (std::size_t i = 0; i < file.values.size(); i += 4)
      pixels_.push_back(
          strength *
          glm::max(glm::dvec3(file.values[i], file.values[i + 1], file.values[i + 2]), glm::dvec3(0)));
  }

  [[nodiscard]] glm::ivec2 size() const { return size_; }
  [[nodiscard]] const glm::dvec3& pixel(int x, int y) const {
    return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) +
                   static_cast<std::size_t>(x)];
  }
  /// Returns the direction of a pixel's centre.
  [[nodiscard]] glm::dvec3 direction(int x, int y) const {
    const double u = (x + 0.5) / size_.x - 0.5 + turned_, v = (y + 0.5) / size_.y;
    const double round = ieee::sin(pi * v);
    return {round * ieee::sin(2 * pi * u), ieee::cos(pi * v), -round * ieee::cos(2 * pi * u)};
  }
  /// Returns the solid angle (steradians) of a pixel in row y. The sum over all pixels is exactly 4 pi.
  [[nodiscard]] double solidAngle(int y) const {
    return 2 * pi / size_.x * (ieee::cos(pi * y / size_.y) - ieee::cos(pi * (y + 1) / size_.y));
  }
  /// Returns the light from direction d by bilinear interpolation.
  [[nodiscard]] glm::dvec3 towards(const glm::dvec3& d) const {
    const double turn = ieee::atan2(d.x, -d.z) / (2 * pi) - turned_;
    const double u = (turn - std::floor(turn) + 0.5) * size_.x - 0.5;
    const double v = ieee::atan2(std::sqrt(d.x * d.x + d.z * d.z), d.y) / pi * size_.y - 0.5;
    const double left = std::floor(u), top = std::floor(v);
    const auto at = [&](int i, int j) {
      const int x = (static_cast<int>(left) + i + 2 * size_.x) % size_.x;
      return pixel(x, std::clamp(static_cast<int>(top) + j, 0, size_.y - 1));
    };
    const glm::dvec3 above = at(0, 0) + (at(1, 0) - at(0, 0)) * (u - left);
    const glm::dvec3 below = at(0, 1) + (at(1, 1) - at(0, 1)) * (u - left);
    return above + (below - above) * (v - top);
  }

 private:
  glm::ivec2 size_;
  double turned_;
  std::vector<glm::dvec3> pixels_;
};

/// Returns the direction of a position (-1 to 1) in an octahedral map. Inverse of octahedral() in
/// environment.glsl.
glm::dvec3 octahedralDirection(glm::dvec2 at) {
  glm::dvec3 d(at.x, 1 - std::fabs(at.x) - std::fabs(at.y), at.y);
  if (d.y < 0) {
    const double x = (1 - std::fabs(at.y)) * (at.x < 0 ? -1 : 1);
    d.z = (1 - std::fabs(at.x)) * (at.y < 0 ? -1 : 1);
    d.x = x;
  }
  return d / std::sqrt(glm::dot(d, d));
}

/// Light from one direction, multiplied by the solid angle that it represents.
struct Ray {
  glm::dvec3 from, light;
};

/// Returns some thousand rays that represent the image. Each ray is the mean of a block of pixels.
std::vector<Ray> raysOf(const Panorama& picture) {
  constexpr int maximum = 64;  // max number of rows of rays
  const int step = (picture.size().y + maximum - 1) / maximum;
  std::vector<Ray> rays;
  for (int y = 0; y < picture.size().y; y += step)
    for (int x = 0; x < picture.size().x; x += step) {
      Ray ray{glm::dvec3(0), glm::dvec3(0)};
      for (int j = y; j < std::min(y + step, picture.size().y); ++j)
        for (int i = x; i < std::min(x + step, picture.size().x); ++i) {
          ray.from += picture.direction(i, j) * picture.solidAngle(j);
          ray.light += picture.pixel(i, j) * picture.solidAngle(j);
        }
      ray.from /= std::sqrt(std::max(glm::dot(ray.from, ray.from), 1e-30));
      rays.push_back(ray);
    }
  return rays;
}

/// Returns the spherical harmonics coefficients of the image's light. They include the factors of the
/// cosine lobe divided by pi (1, 2/3, 1/4) and the squared constants of the basis functions. The sum of the
/// coefficients times the monomials of environmentAmbient() is therefore irradiance / pi.
std::array<glm::dvec3, terms> harmonicsOf(const Panorama& picture) {
  std::array<glm::dvec3, terms> sums{};
  for (int y = 0; y < picture.size().y; ++y)
    for (int x = 0; x < picture.size().x; ++x) {
      const glm::dvec3 n = picture.direction(x, y);
      const glm::dvec3 light = picture.pixel(x, y) * picture.solidAngle(y);
      const std::array<double, terms> of = {
          1, n.x, n.y, n.z, n.x * n.y, n.y * n.z, n.z * n.x, n.x * n.x - n.z * n.z, 3 * n.y * n.y - 1};
      for (std::size_t i = 0; i < terms; ++i) sums.at(i) += light * of.at(i);
    }
  // Squared constants of the real spherical harmonics: 1 / (4 pi), 3 / (4 pi), 15 / (4 pi), 15 / (16 pi), 5
  // / (16 pi).
  constexpr std::array<double, terms> factors = {
      0.25 / pi,          3 * 0.25 / pi * 2 / 3, 3 * 0.25 / pi * 2 / 3, 3 * 0.25 / pi * 2 / 3,
      15 * 0.25 / pi / 4, 15 * 0.25 / pi / 4,    15 * 0.25 / pi / 4,    15 * 0.0625 / pi / 4,
      5 * 0.0625 / pi / 4};
  for (std::size_t i = 0; i < terms; ++i) sums.at(i) *= factors.at(i);
  return sums;
}

/// Returns the light that a surface with the given roughness and the normal d reflects towards a viewer in
/// direction d: a GGX-weighted mean of the rays (Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013).
glm::dvec3 mirrored(const std::vector<Ray>& rays, const std::vector<double>& angles, const glm::dvec3& d,
                    double roughness) {
  const double alpha = roughness * roughness, square = alpha * alpha;
  glm::dvec3 sum(0);
  double weights = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double cosine = glm::dot(rays[i].from, d);
    if (cosine <= 0) continue;
    const double under = 0.5 * (1 + cosine) * (square - 1) + 1;
    const double weight = cosine / (under * under);
    sum += rays[i].light * weight;
    weights += angles[i] * weight;
  }
  return sum / weights;
}

/// Appends a map and its border. `make(x, y)` returns the light of cell (x, y).
template <class Make>
void addMap(std::vector<glm::vec4>& texels, int side, Make make) {
  const std::size_t row = static_cast<std::size_t>(side) + 2, start = texels.size();
  texels.resize(start + row * row);
  tbb::parallel_for(0, side, [&](int y) {
    for (int x = 0; x < side; ++x)
      texels[start + (static_cast<std::size_t>(y) + 1) * row + static_cast<std::size_t>(x) + 1] =
          glm::vec4(glm::vec3(make(x, y)), 1);
  });
  // Beyond an edge, an octahedral map continues with the cells along the same edge in reverse order.
  const auto at = [&](int x, int y) -> glm::vec4& {
    return texels[start + (static_cast<std::size_t>(y + 1)) * row + static_cast<std::size_t>(x + 1)];
  };
  for (int i = 0; i < side; ++i) {
    at(-1, i) = at(0, side - 1 - i);
    at(side, i) = at(side - 1, side - 1 - i);
    at(i, -1) = at(side - 1 - i, 0);
    at(i, side) = at(side - 1 - i, side - 1);
  }
  at(-1, -1) = at(side - 1, side - 1);
  at(side, -1) = at(0, side - 1);
  at(-1, side) = at(side - 1, 0);
  at(side, side) = at(0, 0);
}

}  // namespace

EnvironmentTexels environmentOf(const sim::LightFile& picture, double strength, double turn,
                                const std::string& label) {
  sim::checkSurroundings(picture, label);
  const Panorama panorama(picture, strength, turn);
  EnvironmentTexels made;
  made.side = std::clamp(picture.size.y, coarsestSide, finestSide);
  for (const glm::dvec3& term : harmonicsOf(panorama)) made.texels.emplace_back(glm::vec3(term), 0);
  const auto placeOf = [](int x, int y, double inX, double inY, int side) {
    return octahedralDirection({2 * (x + inX) / side - 1, 2 * (y + inY) / side - 1});
  };
  addMap(made.texels, made.side, [&](int x, int y) {
    constexpr int each = 4;
    glm::dvec3 sum(0);
    for (int i = 0; i < each * each; ++i)
      sum += panorama.towards(
          placeOf(x, y, (i % each + 0.5) / each, (i / each + 0.5) / each, made.side));  // NOLINT
    return sum / static_cast<double>(each * each);
  });
  const std::vector<Ray> rays = raysOf(panorama);
  sim::LightFile white = picture;
  std::fill(white.values.begin(), white.values.end(), 1.0F);
  std::vector<double> angles;
  for (const Ray& ray : raysOf(Panorama(white, 1, turn))) angles.push_back(ray.light.x);
  for (int level = 1; level < 5; ++level) {
    const int side = 256 >> level;
    addMap(made.texels, side, [&](int x, int y) {
      return mirrored(rays, angles, placeOf(x, y, 0.5, 0.5, side), 0.25 * level);
    });
  }
  return made;
}

Environment::Environment(const scene::Sky& sky) : side_(0) {
  const EnvironmentTexels made =
      environmentOf(sim::readSurroundings(sky.picture), static_cast<double>(sky.strength),
                    static_cast<double>(sky.turn), sim::surroundingsLabel(sky.picture));
  side_ = made.side;
  buffer_ = gl::Buffer::ofTexels("environment", std::span<const glm::vec4>(made.texels));
  view_ = gl::Texture::view("environment", GL_RGBA32F, buffer_);
  const auto term = [&](int i) { return glm::vec3(made.texels[static_cast<std::size_t>(i)]); };
  up_ = glm::max(term(0) + term(2) + 2.0F * term(8), glm::vec3(0));
  down_ = glm::max(term(0) - term(2) + 2.0F * term(8), glm::vec3(0));
  around_ = glm::max(term(0) - term(8), glm::vec3(0));
}

gl::Defines Environment::defines() const {
  return {{"ENVIRONMENT", std::to_string(side_)}};
}

void Environment::bind() const {
  view_.bind(environmentUnit);
}

void Environment::setGradient(shader::Frame& frame, float ambient) const {
  frame.zenith = glm::vec4(up_, 0);
  frame.horizon = glm::vec4(around_, 0);
  frame.nadir = glm::vec4(down_, 0);
  frame.ambientUp = glm::vec4(ambient * up_, 0);
  frame.ambientSide = glm::vec4(ambient * around_, 0);
  frame.ambientDown = glm::vec4(ambient * down_, 0);
}

}  // namespace simreel::draw
