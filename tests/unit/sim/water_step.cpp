#include "reference/water_twin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

// Tests one step of the water by comparison with an independent implementation in double precision, in the
// notation of the papers. It uses hydrostatic reconstruction with source terms at both sides of each face
// and in the middle of the cell (Audusse et al. 2004, equations 2.16 to 4.7).

namespace {

struct Lake {
  int width, height;
  bool torus;
  double g, ratio, dry;
  std::vector<double> level, bed, qx, qy;

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// Depth h, velocities u and v, and bed height z. The water level is depth plus bed.
struct Primitive {
  double h, u, v, z;
};

Primitive operator+(const Primitive& a, const Primitive& b) {
  return {a.h + b.h, a.u + b.u, a.v + b.v, a.z + b.z};
}
Primitive operator*(double k, const Primitive& a) {
  return {k * a.h, k * a.u, k * a.v, k * a.z};
}

Primitive beyond(const Lake& lake, int x, int y) {
  bool acrossX = false;
  bool acrossY = false;
  const auto fold = [&](int i, int count, bool& mirrored) {
    if (lake.torus) return (i + count) % count;
    mirrored = i < 0 || i >= count;
    return i < 0 ? -i - 1 : i >= count ? 2 * count - i - 1 : i;
  };
  const std::size_t i = lake.index(fold(x, lake.width, acrossX), fold(y, lake.height, acrossY));
  const double h = lake.level[i] - lake.bed[i];
  const double u = h > 0 ? lake.qx[i] / h : 0;
  const double v = h > 0 ? lake.qy[i] / h : 0;
  return {h, acrossX ? -u : u, acrossY ? -v : v, lake.bed[i]};
}

double mc(double a, double b) {
  if (a * b <= 0) return 0;
  const double size = std::min({2 * std::abs(a), 2 * std::abs(b), 0.5 * std::abs(a + b)});
  return a > 0 ? size : -size;
}

/// Returns the limited slopes of h, u, v and of the level. The slope of the bed is the slope of the level
/// minus the slope of h.
Primitive slope(const Lake& lake, const Primitive& a, const Primitive& b, const Primitive& c) {
  if (std::min({a.h, b.h, c.h}) <= lake.dry) return {0, 0, 0, 0};
  const double h = mc(b.h - a.h, c.h - b.h);
  const double w = mc(b.h + b.z - a.h - a.z, c.h + c.z - b.h - b.z);
  return {h, mc(b.u - a.u, c.u - b.u), mc(b.v - a.v, c.v - b.v), w - h};
}

struct CellSides {
  Primitive middle, west, east, north, south;
};

CellSides sidesOf(const Lake& lake, int x, int y) {
  const Primitive c = beyond(lake, x, y);
  const Primitive sx = slope(lake, beyond(lake, x - 1, y), c, beyond(lake, x + 1, y));
  const Primitive sy = slope(lake, beyond(lake, x, y - 1), c, beyond(lake, x, y + 1));
  // `moved` is the state after half a step of the equations of h, u and v in non-conservative form.
  const double k = 0.5 * lake.ratio;
  const Primitive moved{-k * (c.u * sx.h + c.h * sx.u + c.v * sy.h + c.h * sy.v),
                        -k * (c.u * sx.u + lake.g * (sx.h + sx.z) + c.v * sy.u),
                        -k * (c.u * sx.v + c.v * sy.v + lake.g * (sy.h + sy.z)), 0};
  const Primitive m = c + moved;
  return {m, m + -0.5 * sx, m + 0.5 * sx, m + -0.5 * sy, m + 0.5 * sy};
}

using Conserved = std::array<double, 3>;  // Depth h, and momenta h u and h v. u is the speed through the
                                          // face.

Conserved hll(const Primitive& a, const Primitive& b, double g) {
  const double ca = std::sqrt(g * a.h);
  const double cb = std::sqrt(g * b.h);
  const double u = 0.5 * (a.u + b.u) + ca - cb;
  const double c = 0.5 * (ca + cb) + 0.25 * (a.u - b.u);
  double left = std::min(a.u - ca, u - c);
  double right = std::max(b.u + cb, u + c);
  if (a.h <= 0) left = b.u - 2 * cb, right = b.u + cb;
  if (b.h <= 0) left = a.u - ca, right = a.u + 2 * ca;
  const Conserved fa = {a.h * a.u, a.h * a.u * a.u + 0.5 * g * a.h * a.h, 0};
  const Conserved fb = {b.h * b.u, b.h * b.u * b.u + 0.5 * g * b.h * b.h, 0};
  const Conserved ua = {a.h, a.h * a.u, 0};
  const Conserved ub = {b.h, b.h * b.u, 0};
  Conserved f{};
  for (std::size_t i = 0; i < 2; ++i)
    f[i] = left >= 0    ? fa[i]
           : right <= 0 ? fb[i]
                        : (right * fa[i] - left * fb[i] + left * right * (ub[i] - ua[i])) / (right - left);
  f[2] = f[0] * (f[0] > 0 ? a.v : b.v);
  return f;
}

/// The flux out of the first cell and the flux into the second cell at one face. They differ by source
/// terms.
struct FacePair {
  Conserved out, in;
};

FacePair face(const Primitive& a, const Primitive& b, double g) {
  const double z = std::max(a.z, b.z);
  Primitive ra = a;
  Primitive rb = b;
  ra.h = std::max(0.0, a.h + a.z - z);
  rb.h = std::max(0.0, b.h + b.z - z);
  const Conserved f = hll(ra, rb, g);
  FacePair pair{f, f};
  pair.out[1] += 0.5 * g * (a.h * a.h - ra.h * ra.h);
  pair.in[1] += 0.5 * g * (b.h * b.h - rb.h * rb.h);
  return pair;
}

Primitive turned(const Primitive& p) {
  return {p.h, p.v, p.u, p.z};
}

void step(Lake& lake) {
  Lake next = lake;
  for (int y = 0; y < lake.height; ++y)
    for (int x = 0; x < lake.width; ++x) {
      const CellSides here = sidesOf(lake, x, y);
      const Conserved east = face(here.east, sidesOf(lake, x + 1, y).west, lake.g).out;
      const Conserved west = face(sidesOf(lake, x - 1, y).east, here.west, lake.g).in;
      const Conserved south = face(turned(here.south), turned(sidesOf(lake, x, y + 1).north), lake.g).out;
      const Conserved north = face(turned(sidesOf(lake, x, y - 1).south), turned(here.north), lake.g).in;
      const double bedX = 0.5 * lake.g * (here.west.h + here.east.h) * (here.east.z - here.west.z);
      const double bedY = 0.5 * lake.g * (here.north.h + here.south.h) * (here.south.z - here.north.z);
      const std::size_t i = lake.index(x, y);
      next.level[i] -= lake.ratio * (east[0] - west[0] + south[0] - north[0]);
      next.qx[i] -= lake.ratio * (east[1] - west[1] + south[2] - north[2] + bedX);
      next.qy[i] -= lake.ratio * (south[1] - north[1] + east[2] - west[2] + bedY);
    }
  lake = next;
}

double swing(int i, int seed) {
  return shader::signedUnit(shader::hash3({static_cast<unsigned>(i), static_cast<unsigned>(seed), 77U}).x);
}

}  // namespace

TEST_CASE("water: a step equals the papers' equations in double precision") {
  for (const bool torus : {false, true}) {
    sim::WaterParameters p;
    p.size = {19, 13};
    p.cell = 0.5F;
    p.bed = -1;
    p.level = 0;
    p.substeps = 12;
    if (torus) p.sides.fill(sim::WaterBorder::periodic);
    WaterTwin twin(sim::WaterPlan(p, "lake", 1, 1.0 / 10));
    const shader::WaterStep uniforms = twin.plan().stepAt(0);
    Lake lake{p.size.x, p.size.y, torus, uniforms.gravity, uniforms.ratio, uniforms.dry, {}, {}, {}, {}};
    int i = 0;
    for (glm::vec4& c : twin.cells) {
      // The state is rough, so that every limiter acts, and partly supercritical.
      const double bed = -1 + 0.3 * swing(i, 1);
      const double depth = 1 + 0.3 * swing(i, 2) - bed - 1;
      c = {static_cast<float>(bed + depth), static_cast<float>(depth * 4.5 * swing(i, 3)),
           static_cast<float>(depth * 2 * swing(i, 4)), static_cast<float>(bed)};
      lake.level.push_back(c.x);
      lake.qx.push_back(c.y);
      lake.qy.push_back(c.z);
      lake.bed.push_back(c.w);
      ++i;
    }
    step(lake);
    twin.advance(uniforms);
    double worst = 0;
    double maximum = 0;
    for (std::size_t k = 0; k < twin.cells.size(); ++k) {
      const glm::vec4& c = twin.cells[k];
      worst = std::max(
          {worst, std::abs(c.x - lake.level[k]), std::abs(c.y - lake.qx[k]), std::abs(c.z - lake.qy[k])});
      maximum = std::max(maximum, std::abs(lake.qx[k]));
    }
    CHECK(maximum > 1);
    CHECK(worst < 2e-5);
  }
}
