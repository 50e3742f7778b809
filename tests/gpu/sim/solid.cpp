#include "sim/contour/solid.hpp"

#include "gpu/sim/solid_stage.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <tuple>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

template <class Item>
std::size_t differing(const std::vector<Item>& got, const std::vector<Item>& want) {
  REQUIRE(got.size() == want.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < got.size(); ++i)
    if (std::memcmp(&got[i], &want[i], sizeof(Item)) != 0) ++count;
  return count;
}

void checkSame(const sim::SolidShape& shape, const std::function<float(int, int)>& value, bool bits) {
  const FieldInMemory field(shape.size, value, bits);
  const SolidOnDevice made(shape, field);
  const SolidTwin twin(shape, value);
  const sim::MeshTable mesh = made.solid.mesh();
  CHECK(differing(mesh.positions, twin.mesh.positions) == 0);
  CHECK(differing(mesh.normals, twin.mesh.normals) == 0);
  CHECK(differing(mesh.indices, twin.mesh.indices) == 0);
  const sim::ContourLines lines = made.solid.lines();
  CHECK(differing(lines.points, twin.lines.points) == 0);
  CHECK(differing(lines.next, twin.lines.next) == 0);
  CHECK(differing(lines.levels, twin.lines.levels) == 0);
}

sim::SolidShape binary(int width, int height, bool ceiling = false) {
  sim::SolidShape shape;
  shape.size = {width, height};
  shape.heights = {0, 1.5F};
  shape.spacing = 0.5F;
  shape.outside = 1;
  shape.ceiling = ceiling;
  return shape;
}

/// Returns binary maps: all rock, all open, a checkerboard (all saddles), fine noise and coarse noise.
std::vector<std::function<float(int, int)>> binaryMaps() {
  return {[](int, int) { return 1.0F; }, [](int, int) { return 0.0F; },
          [](int x, int y) { return static_cast<float>((x + y) % 2); },
          [](int x, int y) { return chance(x, y, 3, 0.5) ? 1.0F : 0.0F; },
          [](int x, int y) { return chance(x / 3, y / 3, 9, 0.45) ? 1.0F : 0.0F; }};
}

const std::vector<glm::ivec2> oddSizes = {{1, 1},   {1, 37}, {43, 1}, {2, 2},
                                          {13, 14}, {15, 7}, {30, 5}, {129, 33}};

/// The edges and corners of a mesh after vertices at equal positions are merged.
struct Welded {
  explicit Welded(const sim::MeshTable& mesh) {
    std::map<std::tuple<float, float, float>, int> known;
    std::vector<int> corner;
    for (const glm::vec3& p : mesh.positions)
      corner.push_back(known.try_emplace({p.x, p.y, p.z}, static_cast<int>(known.size())).first->second);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const int t[] = {corner[mesh.indices[i]], corner[mesh.indices[i + 1]], corner[mesh.indices[i + 2]]};
      for (int k = 0; k < 3; ++k) {
        ++edges[{t[k], t[(k + 1) % 3]}];
        used.insert(t[k]);
      }
      ++faces;
    }
  }
  std::map<std::pair<int, int>, int> edges;  ///< number of uses of each directed edge
  std::set<int> used;
  int faces = 0;

  /// Returns the number of directed edges that are not used exactly once in each direction.
  [[nodiscard]] std::size_t openEdges() const {
    std::size_t open = 0;
    for (const auto& [edge, count] : edges) {
      const auto back = edges.find({edge.second, edge.first});
      if (count != 1 || back == edges.end() || back->second != 1) ++open;
    }
    return open;
  }
  [[nodiscard]] int eulerCharacteristic() const {
    return static_cast<int>(used.size()) - static_cast<int>(edges.size() / 2) + faces;
  }
};

/// Returns the number of connected regions of the map, found by flood fill. Open cells connect across
/// edges, and rock connects across edges and corners. The outside of the map counts as rock.
int regionCount(glm::ivec2 size, const std::function<float(int, int)>& value, bool rock) {
  const glm::ivec2 all = size + 2;
  const auto isRock = [&](int x, int y) {
    return x == 0 || y == 0 || x == all.x - 1 || y == all.y - 1 || value(x - 1, y - 1) >= 0.5F;
  };
  std::set<std::pair<int, int>> left;
  for (int y = 0; y < all.y; ++y)
    for (int x = 0; x < all.x; ++x)
      if (isRock(x, y) == rock) left.insert({x, y});
  int count = 0;
  for (; !left.empty(); ++count) {
    std::vector<std::pair<int, int>> queue = {*left.begin()};
    left.erase(left.begin());
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          if (!rock && dx != 0 && dy != 0) continue;
          const auto found = left.find({queue[i].first + dx, queue[i].second + dy});
          if (found == left.end()) continue;
          queue.push_back(*found);
          left.erase(found);
        }
  }
  return count;
}

double volumeOf(const sim::MeshTable& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
    const glm::dvec3 b(mesh.positions[mesh.indices[i + 1]]);
    const glm::dvec3 c(mesh.positions[mesh.indices[i + 2]]);
    sum += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return sum;
}

/// Returns the total area of the upward faces at this height.
double areaAt(const sim::MeshTable& mesh, float height) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
    const glm::dvec3 b(mesh.positions[mesh.indices[i + 1]]);
    const glm::dvec3 c(mesh.positions[mesh.indices[i + 2]]);
    const glm::dvec3 twice = glm::cross(b - a, c - a);
    if (a.y == height && b.y == height && c.y == height && twice.y > 0) sum += twice.y / 2;
  }
  return sum;
}

double lengthOf(const sim::ContourLines& lines) {
  double sum = 0;
  for (std::size_t i = 0; i < lines.points.size(); ++i)
    sum += glm::length(glm::dvec2(lines.points[lines.next[i]]) - glm::dvec2(lines.points[i]));
  return sum;
}

/// Returns the signed area enclosed by the contours (shoelace formula).
double enclosed(const sim::ContourLines& lines) {
  double sum = 0;
  for (std::size_t i = 0; i < lines.points.size(); ++i) {
    const glm::dvec2 a(lines.points[i]);
    const glm::dvec2 b(lines.points[lines.next[i]]);
    sum += (a.x * b.y - a.y * b.x) / 2;
  }
  return sum;
}

}  // namespace

TEST_CASE("the solid of a map equals its twin in every bit") {
  testContext();
  for (const glm::ivec2 size : oddSizes)
    for (const auto& map : binaryMaps())
      for (const bool ceiling : {false, true}) {
        CAPTURE(size.x);
        CAPTURE(size.y);
        CAPTURE(ceiling);
        checkSame(binary(size.x, size.y, ceiling), map, true);
      }
}

TEST_CASE("the solid of a smooth field with many levels equals its twin in every bit") {
  testContext();
  const auto hills = [](int x, int y) {
    return std::sin(0.31F * static_cast<float>(x)) * std::cos(0.23F * static_cast<float>(y)) +
           0.2F * static_cast<float>(chance(x, y, 1, 0.5));
  };
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(3, 17), glm::ivec2(129, 33)})
    for (const int count : {1, 2, 16})
      for (const int outside : {0, 1}) {
        sim::SolidShape shape;
        shape.size = size;
        shape.levels.clear();
        shape.heights = {0};
        for (int i = 0; i < count; ++i) {
          shape.levels.push_back(-0.8F + 1.7F * (static_cast<float>(i) + 0.5F) / static_cast<float>(count));
          shape.heights.push_back(0.3F * static_cast<float>(i + 1));
        }
        shape.spacing = 0.13F;
        shape.outside = outside;
        CAPTURE(size.x);
        CAPTURE(size.y);
        CAPTURE(count);
        checkSame(shape, hills, false);
      }
  sim::SolidShape lost;
  lost.size = {9, 7};
  checkSame(
      lost, [](int x, int y) { return x == y  ? NAN
                                      : x > 4 ? INFINITY
                                              : 0.9F; }, false);
}

TEST_CASE("a solid is closed and has as many parts as the map has regions") {
  testContext();
  for (const glm::ivec2 size : oddSizes)
    for (const auto& map : binaryMaps())
      for (const bool ceiling : {false, true}) {
        CAPTURE(size.x);
        CAPTURE(size.y);
        const sim::SolidShape shape = binary(size.x, size.y, ceiling);
        const FieldInMemory field(size, map, true);
        const SolidOnDevice made(shape, field);
        const sim::MeshTable mesh = made.solid.mesh();
        const Welded welded(mesh);
        CHECK(welded.openEdges() == 0);
        const int rooms = regionCount(size, map, false);
        // Rock that is not connected to the outside is an island in a room. Each island adds a handle to
        // the surface of the room.
        const int islands = regionCount(size, map, true) - 1;
        CHECK(welded.eulerCharacteristic() == (ceiling ? 2 + 2 * rooms - 2 * islands : 2));
        // The expected volume is the volume of the whole block minus the open space above the floor.
        const double cells = (size.x + 1.0) * (size.y + 1.0) * 0.25;
        const double floor = areaAt(mesh, 0);
        const double full = cells * (1.5 + shape.base + (ceiling ? shape.roof : 0.0F));
        CHECK(volumeOf(mesh) == doctest::Approx(full - 1.5 * floor).epsilon(1e-5));
      }
}

TEST_CASE("the floor's area is the sum over the sixteen marching squares cases") {
  testContext();
  // Returns the area, in eighths of a cell, that low corners cover. Two opposite low corners cover only
  // triangles at these corners.
  const auto eighths = [](bool a, bool b, bool c, bool d) {
    const int low = int(!a) + int(!b) + int(!c) + int(!d);
    return low == 0 ? 0 : low == 1 ? 1 : low == 3 ? 7 : low == 4 ? 8 : a == c ? 2 : 4;
  };
  for (const glm::ivec2 size : oddSizes)
    for (const auto& map : binaryMaps()) {
      const auto isRock = [&](int x, int y) {
        return x < 0 || y < 0 || x >= size.x || y >= size.y || map(x, y) != 0;
      };
      long sum = 0;
      for (int y = -1; y < size.y; ++y)
        for (int x = -1; x < size.x; ++x)
          sum += eighths(isRock(x, y), isRock(x + 1, y), isRock(x + 1, y + 1), isRock(x, y + 1));
      sim::SolidShape shape = binary(size.x, size.y);
      shape.spacing = 1;
      const FieldInMemory field(size, map, true);
      const SolidOnDevice made(shape, field);
      CHECK(areaAt(made.solid.mesh(), 0) == static_cast<double>(sum) / 8);
      CHECK(std::abs(enclosed(made.solid.lines())) == static_cast<double>(sum) / 8);
    }
}

TEST_CASE("contours of a cone converge to circles at second order") {
  testContext();
  const double radius = 0.3;
  double before[2] = {0, 0};
  for (const int n : {64, 128, 256}) {
    sim::SolidShape shape;
    shape.size = {n, n};
    shape.levels = {0};
    const double middle = 0.5 * (n - 1) + 0.137;
    const FieldInMemory field(shape.size, [&](int x, int y) {
      return static_cast<float>(radius * n - std::hypot(x - middle, y - middle));
    });
    const SolidOnDevice made(shape, field);
    const sim::ContourLines lines = made.solid.lines();
    const double pi = 3.14159265358979;
    const double length = std::abs(lengthOf(lines) / n / (2 * pi * radius) - 1);
    const double area = std::abs(std::abs(enclosed(lines)) / n / n / (pi * radius * radius) - 1);
    CHECK(length < 3e-3 * 64 * 64 / n / n);
    CHECK(area < 3e-3 * 64 * 64 / n / n);
    if (before[0] > 0) {
      CHECK(before[0] / length > 3);
      CHECK(before[1] / area > 3);
    }
    before[0] = length;
    before[1] = area;
  }
}

TEST_CASE("contours are closed loops with the high side always on the same side") {
  testContext();
  const glm::ivec2 size(57, 39);
  const FieldInMemory field(size, binaryMaps()[4], true);
  const SolidOnDevice made(binary(size.x, size.y), field);
  const sim::ContourLines lines = made.solid.lines();
  REQUIRE(!lines.points.empty());
  std::vector<int> entered(lines.points.size(), 0);
  for (const unsigned next : lines.next) ++entered.at(next);
  CHECK(std::all_of(entered.begin(), entered.end(), [](int n) { return n == 1; }));
  for (std::size_t i = 0; i < lines.points.size(); ++i) {
    const glm::vec2 step = lines.points[lines.next[i]] - lines.points[i];
    CHECK(std::max(std::abs(step.x), std::abs(step.y)) <= 1);
  }
}

TEST_CASE("a solid's memory grows to what a frame needs and is kept") {
  testContext();
  const glm::ivec2 size(121, 67);
  const auto empty = [](int, int) { return 0.0F; };
  const auto saddles = [](int x, int y) { return static_cast<float>((x + y) % 2); };
  const FieldInMemory quiet(size, empty, true), busy(size, saddles, true);
  const sim::SolidShape shape = binary(size.x, size.y);
  SolidOnDevice made(shape, quiet);
  CHECK(made.growths == 0);
  const auto countOf = [](const sim::Surface& surface) {
    unsigned count = 0;
    surface.arguments->read(0, std::as_writable_bytes(std::span(&count, 1)));
    return count;
  };
  made.solid.make(busy.field, shape.heights);
  // The solid must draw nothing until there is enough memory, instead of undefined triangles.
  CHECK(countOf(made.solid.surface()) == 0);
  CHECK(made.solid.grow());
  CHECK(!made.solid.grow());
  CHECK(countOf(made.solid.surface()) == made.solid.mesh().indices.size());
  CHECK(differing(made.solid.mesh().positions, SolidTwin(shape, saddles).mesh.positions) == 0);
  made.solid.make(quiet.field, shape.heights);
  CHECK(!made.solid.grow());
  made.solid.make(busy.field, shape.heights);
  CHECK(!made.solid.grow());
}

TEST_CASE("strips of 65,535 cells have solids: memory is buffers, not textures") {
  testContext();
  for (const glm::ivec2 size : {glm::ivec2(65535, 3), glm::ivec2(3, 65535)}) {
    const auto map = [](int x, int y) { return chance(x, y, 4, 0.4) ? 1.0F : 0.0F; };
    checkSame(binary(size.x, size.y), map, true);
  }
}

TEST_CASE("solids for files: uvs are neither stretched nor mirrored") {
  testContext();
  for (const bool ceiling : {false, true}) {
    sim::SolidShape shape = binary(31, 22, ceiling);
    if (!ceiling) {
      shape.levels = {0.3F, 0.5F, 0.8F};
      shape.heights = {0, 0.4F, 1, 1.5F};
      shape.outside = 0;
    }
    const FieldInMemory field(shape.size, [&](int x, int y) {
      const float noise = chance(x / 2, y / 2, 4, 0.5) ? 0.9F : 0.1F;
      return ceiling ? (noise > 0.5F ? 1.0F : 0.0F)
                     : 0.5F * noise + 0.25F + 0.25F * std::sin(0.9F * float(x));
    });
    const SolidOnDevice made(shape, field);
    const sim::MeshTable mesh = made.solid.unwrapped();
    const sim::MeshTable plain = made.solid.mesh();
    const double metre = shape.spacing * static_cast<float>(shape.size.x + 1);
    REQUIRE(mesh.uvs.size() == mesh.positions.size());
    REQUIRE(mesh.indices.size() == plain.indices.size());
    int seams = 0;
    int sloping = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      glm::dvec3 p[3];
      glm::dvec2 t[3];
      for (std::size_t k = 0; k < 3; ++k) {
        const unsigned vertex = mesh.indices[i + k];
        p[k] = mesh.positions[vertex];
        t[k] = metre * glm::dvec2(mesh.uvs[vertex]);
        CHECK(glm::vec3(p[k]) == plain.positions[plain.indices[i + k]]);
        seams += vertex >= plain.positions.size() ? 1 : 0;
      }
      for (int k = 0; k < 3; ++k) {
        const glm::dvec3 side = p[(k + 1) % 3] - p[k];
        REQUIRE(glm::length(t[(k + 1) % 3] - t[k]) == doctest::Approx(glm::length(side)).epsilon(1e-4));
        sloping += side.x != 0 && side.z != 0 && side.y != 0 ? 1 : 0;
      }
      const glm::dvec2 a = t[1] - t[0];
      const glm::dvec2 b = t[2] - t[0];
      const glm::dvec3 face = glm::cross(p[1] - p[0], p[2] - p[0]);
      if (glm::length(face) > 1e-6)
        CHECK(a.x * b.y - a.y * b.x < 0);  // The sign is negative, because v
                                           // grows downwards.
    }
    CHECK(seams > 20);
    CHECK(sloping > 100);
  }
}
