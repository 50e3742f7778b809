#include "sim/particles/start.hpp"

#include "sim/core/collider.hpp"
#include "sim/core/shader_code.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace simreel::sim {

namespace {

// The functions below use only +, -, *, / and sqrt of doubles, which IEEE 754 defines exactly, so the
// initial state has the same bits on every machine.

/// Returns the natural logarithm. For x = m 2^e, ln m = 2 (z + z^3/3 + z^5/5 + ...) with z = (m-1)/(m+1).
double logarithm(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 0.70710678118654752) {
    m *= 2;
    --exponent;
  }
  const double z = (m - 1) / (m + 1);
  double sum = 0;
  for (int k = 23; k >= 1; k -= 2) sum = sum * z * z + 1.0 / k;
  return 2 * z * sum + exponent * std::numbers::ln2;
}

/// Returns e^x for |x| < 700. Divides the argument by 2^10, evaluates a short Taylor series and squares the
/// result ten times.
double exponential(double x) {
  double r = x / 1024;
  double sum = 1;
  for (int k = 8; k >= 1; --k) sum = 1 + r * sum / k;
  for (int i = 0; i < 10; ++i) sum *= sum;
  return sum;
}

/// Returns x^(1/3) by Newton's iteration, for x in (0, 1].
double cubeRoot(double x) {
  double y = 1;
  for (int i = 0; i < 64; ++i) y = (2 * y + x / (y * y)) / 3;
  return y;
}

/// Sequence of random numbers of one particle.
class Draws {
 public:
  Draws(int particle, int group, int seed)
      : particle_(static_cast<unsigned>(particle)),
        group_(static_cast<unsigned>(group)),
        seed_(static_cast<unsigned>(seed) * 0x9e3779b9U) {}

  /// Returns a number uniformly distributed in (0, 1).
  double unit() {
    const auto bits = shader::hash3({particle_, group_ * 65536U + draw_++, seed_ ^ 0x2545f491U});
    return ((bits.x >> 8U) + 0.5) / 16777216.0;
  }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// Returns a direction uniformly distributed on the unit sphere.
  glm::dvec3 direction() {
    const double y = between(-1, 1);
    const auto angle = static_cast<float>(between(0, 2 * std::numbers::pi));
    const double across = std::sqrt(1 - y * y);
    return {across * shader::exactCos(angle), y, across * shader::exactSin(angle)};
  }
  /// Returns a normally distributed number with mean 0 and variance 1 (Box and Muller).
  double normal() {
    const double radius = std::sqrt(-2 * logarithm(unit()));
    return radius * shader::exactCos(static_cast<float>(between(0, 2 * std::numbers::pi)));
  }

 private:
  unsigned particle_, group_, seed_;
  unsigned draw_ = 0;
};

struct Body {
  glm::dvec3 position{0};
  glm::dvec3 velocity{0};
};

/// Returns a particle of a uniform ball or cube that spins about y. A velocity of magnitude `speed` in a
/// random direction is added.
Body looseBody(const ParticleGroup& g, Draws& draws) {
  Body body;
  const double r = g.radius;
  if (g.shape == ParticleGroup::Shape::ball) {
    body.position = draws.direction() * (r * cubeRoot(draws.unit()));
  } else {
    const double x = draws.between(-r, r);
    const double y = draws.between(-r, r);
    body.position = {x, y, draws.between(-r, r)};
  }
  body.velocity = draws.direction() * static_cast<double>(g.speed);
  body.velocity += glm::dvec3(g.spin * body.position.z, 0, -g.spin * body.position.x);
  return body;
}

/// Returns a particle of Plummer's model (Aarseth, Henon and Wielen 1974). The radius is the inverse of the
/// cumulative mass M(r). The velocity, as a fraction q of the escape velocity, has the density q^2 (1 -
/// q^2)^(7/2), which is always below 0.1 and is sampled by rejection.
Body plummerBody(const ParticleGroup& g, double gm, Draws& draws) {
  const double fraction = draws.unit() * 0.999;  // limits the radius to 39 times the scale radius a
  const double root = cubeRoot(fraction);
  const double r = g.radius / std::sqrt(1 / (root * root) - 1);
  double q = 0;
  for (int i = 0; i < 1000; ++i) {
    q = draws.unit();
    const double y = draws.unit() * 0.1;
    const double rest = 1 - q * q;
    if (y < q * q * rest * rest * rest * std::sqrt(rest)) break;
  }
  const double a = g.radius;
  const double escape = std::sqrt(2 * gm / std::sqrt(r * r + a * a));
  Body body;
  body.position = draws.direction() * r;
  body.velocity = draws.direction() * (q * escape);
  return body;
}

/// Circular motion in an exponential disk around a softened central mass. Lengths are in metres.
struct DiskModel {
  double scale, gmDisk, gmCentre, softeningSquared;
  double gravity;
  std::span<const Companion> companions;

  /// Returns the squared circular speed v^2 = G M(<R) R^2 / (R^2 + eps^2)^(3/2) at the radius R, where
  /// M(<R) is the central mass plus the disk's mass within R, which is treated as spherical. Each companion
  /// of mass M and scale radius a adds G M R^2 / (R^2 + a^2 + eps^2)^(3/2).
  [[nodiscard]] double speedSquared(double radius) const {
    const double x = radius / scale;
    const double within = gmDisk * (1 - (1 + x) * exponential(-x)) + gmCentre;
    const double squared = radius * radius + softeningSquared;
    double sum = within * radius * radius / (squared * std::sqrt(squared));
    for (const Companion& c : companions) {
      const double wide = squared + double(c.radius) * c.radius;
      sum += gravity * c.mass * radius * radius / (wide * std::sqrt(wide));
    }
    return sum;
  }
  /// Returns the squared epicyclic frequency kappa^2 = R^-3 d(R^2 v^2)/dR at the radius R.
  [[nodiscard]] double epicyclicSquared(double radius) const {
    const double h = 1e-3 * radius;
    const double above = (radius + h) * (radius + h) * speedSquared(radius + h);
    const double below = (radius - h) * (radius - h) * speedSquared(radius - h);
    return (above - below) / (2 * h * radius * radius * radius);
  }
};

/// Returns a particle of a disk with the surface density exp(-R/Rd) and the vertical profile sech^2(z/z0),
/// where Rd is the scale length and z0 the scale height. The velocity dispersion is chosen such that
/// Toomre's Q is 1.2, but at most 0.3 times the circular speed. The mean rotation is reduced by the
/// asymmetric drift (Binney and Tremaine 2008, 4.228).
Body diskBody(const ParticleGroup& g, const DiskModel& disk, double gravity, Draws& draws) {
  double radius = 0;
  do {
    radius = -disk.scale * logarithm(draws.unit() * draws.unit());
  } while (radius > 6 * disk.scale || radius < 1e-3 * disk.scale);
  const double height = disk.scale * g.thickness;
  const double u = draws.between(-0.999, 0.999);
  const double z = 0.5 * height * logarithm((1 + u) / (1 - u));
  const double circular = std::sqrt(disk.speedSquared(radius));
  const double density = disk.gmDisk / gravity * exponential(-radius / disk.scale) /
                         (2 * std::numbers::pi * disk.scale * disk.scale);
  const double kappa = std::sqrt(std::max(disk.epicyclicSquared(radius), 1e-30));
  const double toomre = kappa > 0 ? 1.2 * 3.36 * gravity * density / kappa : 0.0;
  const double radial = std::min(toomre, 0.3 * circular);
  const double ratio = radius > 0 && circular > 0 ? kappa * radius / (2 * circular) : 1.0;
  const double vertical =
      std::min(std::sqrt(std::numbers::pi * gravity * density * height), 0.3 * circular);
  const double drift = radial * radial * (ratio * ratio - 1 + 2 * radius / disk.scale);
  const double rotation = std::sqrt(std::max(circular * circular - drift, 0.0));
  const auto angle = static_cast<float>(draws.between(0, 2 * std::numbers::pi));
  const double c = shader::exactCos(angle);
  const double s = shader::exactSin(angle);
  const double outward = radial * draws.normal();
  const double around = rotation + radial * ratio * draws.normal();
  Body body;
  body.position = {radius * c, z, -radius * s};
  body.velocity = {outward * c - around * s, vertical * draws.normal(), -outward * s - around * c};
  return body;
}

}  // namespace

ParticleCloud startGroup(const ParticleGroup& g, int groupIndex, int seed, float gravity, float softening,
                         std::span<const Companion> companions) {
  const double gm = static_cast<double>(gravity) * g.totalMass;
  const DiskModel disk{g.radius,
                       gm,
                       static_cast<double>(gravity) * g.centralMass,
                       static_cast<double>(softening) * softening,
                       gravity,
                       companions};
  std::vector<Body> bodies;
  bodies.reserve(static_cast<std::size_t>(g.count));
  for (int i = 0; i < g.count; ++i) {
    Draws draws(i, groupIndex, seed);
    if (g.shape == ParticleGroup::Shape::plummer)
      bodies.push_back(plummerBody(g, gm, draws));
    else if (g.shape == ParticleGroup::Shape::disk)
      bodies.push_back(diskBody(g, disk, gravity, draws));
    else
      bodies.push_back(looseBody(g, draws));
  }
  Body mean;
  if (g.shape == ParticleGroup::Shape::plummer) {
    for (const Body& body : bodies) {
      mean.position += body.position;
      mean.velocity += body.velocity;
    }
    mean.position /= static_cast<double>(g.count);
    mean.velocity /= static_cast<double>(g.count);
  }
  ParticleCloud cloud;
  const float mass = g.totalMass / static_cast<float>(g.count);
  for (const Body& body : bodies) {
    cloud.positions.emplace_back(glm::vec3(body.position - mean.position), mass);
    cloud.velocities.emplace_back(glm::vec3(body.velocity - mean.velocity), 0.0F);
  }
  if (g.centralMass > 0) {
    cloud.positions.emplace_back(0, 0, 0, g.centralMass);
    cloud.velocities.emplace_back(0, 0, 0, 0);
  }
  return cloud;
}

void placeGroup(ParticleCloud& cloud, const ParticleGroup& group) {
  // exactCos(0) is 1 - 1.2e-7, so a group without rotation skips this step to keep its bits.
  const bool turned = group.rotation != glm::vec3(0);
  const glm::mat3 turn = turned ? glm::mat3(rotationMatrix(group.rotation)) : glm::mat3(1.0F);
  for (glm::vec4& p : cloud.positions) p = glm::vec4(turn * glm::vec3(p) + group.position, p.w);
  for (glm::vec4& v : cloud.velocities) v = glm::vec4(turn * glm::vec3(v) + group.velocity, v.w);
}

}  // namespace simreel::sim
