// Tests marching cubes on the GPU. The surface must equal the CPU twin bit for bit, be closed, and have the
// area, volume and normals of a sphere.
#include "sim/volume/isosurface.hpp"

#include "gpu/context.hpp"
#include "reference/isosurface_twin.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <numbers>
#include <optional>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

using VolumeFunction = std::function<float(int, int, int)>;

/// Sampled values in a simulation's memory layout, and the isosurface through them.
struct SurfaceOnDevice {
  SurfaceOnDevice(const sim::IsosurfaceShape& shape, float level, const VolumeFunction& value,
                  const VolumeFunction& tint, glm::vec2 range) {
    testContext();
    const int columns = (shape.size.x + 3) / 4, plane = columns * shape.size.y * shape.size.z;
    std::vector<glm::vec4> cells(static_cast<std::size_t>(2 * plane), glm::vec4(0));
    for (int z = 0; z < shape.size.z; ++z)
      for (int y = 0; y < shape.size.y; ++y)
        for (int x = 0; x < shape.size.x; ++x) {
          const auto element = static_cast<std::size_t>((z * shape.size.y + y) * columns + x / 4);
          cells[element][x % 4] = value(x, y, z);
          cells[element + static_cast<std::size_t>(plane)][x % 4] = tint(x, y, z);
        }
    buffer = gl::Buffer::of<glm::vec4>("cells", cells);
    words = gl::Texture::view("cells", GL_RGBA32UI, buffer);
    surface.emplace("ball", shape, std::vector<glm::vec3>{{0, 0, 0}, {1, 1, 1}});
    surface->make({&words, 4 * columns, 0}, level, {{&words, 4 * columns, 4 * plane}, range});
    while (surface->grow()) ++settled;
  }
  gl::Buffer buffer;
  gl::Texture words;
  std::optional<sim::Isosurface> surface;
  int settled = 0;
};

float hashedValue(int x, int y, int z) {
  return shader::signedUnit(shader::hash3({unsigned(x), unsigned(y), unsigned(z)}).x);
}

template <class Item>
std::size_t differingItems(const std::vector<Item>& got, const std::vector<Item>& want) {
  REQUIRE(got.size() == want.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < got.size(); ++i)
    if (std::memcmp(&got[i], &want[i], sizeof(Item)) != 0) ++count;
  return count;
}

/// Returns the number of directed edges that do not occur as often as their reverse. `once`: true to count
/// edges that occur more than once as well. (If two sheets meet in a cube's face, both may have a diagonal
/// there.)
std::size_t unevenEdges(const sim::MeshTable& mesh, bool once) {
  std::map<std::pair<unsigned, unsigned>, int> passed;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    ++passed[{mesh.indices[i], mesh.indices[next]}];
  }
  std::size_t open = 0;
  for (const auto& [edge, times] : passed) {
    const auto back = passed.find({edge.second, edge.first});
    if (back == passed.end() || back->second != times || (once && times != 1)) ++open;
  }
  return open;
}

struct AreaAndVolume {
  double area = 0, volume = 0;
};
AreaAndVolume areaAndVolumeOf(const sim::MeshTable& mesh) {
  AreaAndVolume sum;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a(mesh.positions[mesh.indices[i]]), b(mesh.positions[mesh.indices[i + 1]]),
        c(mesh.positions[mesh.indices[i + 2]]);
    sum.area += glm::length(glm::cross(b - a, c - a)) / 2;
    sum.volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return sum;
}

}  // namespace

TEST_CASE("isosurface equals its twin bit for bit: noise, balls, odd sizes, open and closed") {
  const VolumeFunction ball = [](int x, int y, int z) {
    return 6 - std::sqrt(static_cast<float>((x - 7) * (x - 7) + (y - 5) * (y - 5) + (z - 6) * (z - 6)));
  };
  const VolumeFunction lost = [](int x, int y, int z) {
    return (x + y + z) % 7 == 0 ? std::nanf("") : hashedValue(x, y, z);
  };
  const VolumeFunction tint = [](int x, int y, int z) { return 0.03F * static_cast<float>(x + 2 * y - z); };
  for (const glm::ivec3 size : {glm::ivec3(15, 11, 13), glm::ivec3(4, 4, 2), glm::ivec3(32, 5, 7),
                                glm::ivec3(30, 6, 3), glm::ivec3(67, 9, 5)})
    for (const bool closed : {true, false})
      for (const VolumeFunction& value : {VolumeFunction(hashedValue), ball, lost}) {
        CAPTURE(size.x);
        CAPTURE(closed);
        const sim::IsosurfaceShape shape{size, 0.37F, {0.1F, -2, 5}, closed};
        const SurfaceOnDevice made(shape, 0.21F, value, tint, {-0.2F, 1.3F});
        const sim::MeshTable got = made.surface->mesh();
        const sim::MeshTable want = isosurfaceTwin(shape, 0.21F, value, tint, {-0.2F, 1.3F});
        CHECK(differingItems(got.positions, want.positions) == 0);
        CHECK(differingItems(got.normals, want.normals) == 0);
        CHECK(differingItems(got.indices, want.indices) == 0);
        const sim::Surface surface = made.surface->surface();
        REQUIRE(surface.palette != nullptr);
        if (closed) CHECK(unevenEdges(got, false) == 0);
      }
}

TEST_CASE("isosurface: the surface of a ball has the area, volume and normals of a ball") {
  double errors[2][2];
  for (int fine = 0; fine < 2; ++fine) {
    const int side = fine == 0 ? 23 : 46;
    const double middle = (side - 1) / 2.0 + 0.13, spacing = 2.6 / side;
    // The function is quadratic, so that linear interpolation between samples misses the level slightly.
    const auto place = [&](int i) { return (i - middle) * spacing; };
    const VolumeFunction value = [&](int x, int y, int z) {
      return static_cast<float>(1 - place(x) * place(x) - place(y) * place(y) - place(z) * place(z));
    };
    const sim::IsosurfaceShape shape{glm::ivec3(side), static_cast<float>(spacing), {0, 0, 0}, true};
    const SurfaceOnDevice made(shape, 0, value, value, {0, 1});
    const sim::MeshTable mesh = made.surface->mesh();
    CHECK(unevenEdges(mesh, true) == 0);
    const AreaAndVolume found = areaAndVolumeOf(mesh);
    errors[fine][0] = std::abs(found.area / (4 * std::numbers::pi) - 1);
    errors[fine][1] = std::abs(found.volume / (4 * std::numbers::pi / 3) - 1);
    double worst = 0;
    const glm::dvec3 centre(0.13 * spacing);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      worst = std::max(worst, glm::length(glm::dvec3(mesh.normals[i]) -
                                          glm::normalize(glm::dvec3(mesh.positions[i]) - centre)));
    CHECK_MESSAGE(worst < 2e-3, (worst));
  }
  MESSAGE("area off by ", errors[0][0], " and ", errors[1][0], ", volume by ", errors[0][1], " and ",
          errors[1][1]);
  for (int i = 0; i < 2; ++i) {
    CHECK(errors[1][i] < 4e-3);
    CHECK(errors[1][i] < 0.4 * errors[0][i]);  // The errors show second-order convergence.
  }
}

TEST_CASE("cubes equal their twin bit for bit and enclose the volume of the living cells") {
  const VolumeFunction lost = [](int x, int y, int z) {
    return (x + y + z) % 7 == 0 ? std::nanf("") : hashedValue(x, y, z);
  };
  const VolumeFunction tint = [](int x, int y, int z) { return 0.03F * static_cast<float>(x + 2 * y - z); };
  for (const glm::ivec3 size : {glm::ivec3(15, 11, 13), glm::ivec3(4, 4, 2), glm::ivec3(32, 5, 7),
                                glm::ivec3(30, 6, 3), glm::ivec3(67, 9, 5)})
    for (const bool closed : {true, false})
      for (const VolumeFunction& value : {VolumeFunction(hashedValue), lost}) {
        CAPTURE(size.x);
        CAPTURE(closed);
        const sim::IsosurfaceShape shape{size, 0.375F, {0.1F, -2, 5}, closed, true};
        const SurfaceOnDevice made(shape, 0.21F, value, tint, {-0.2F, 1.3F});
        const sim::MeshTable got = made.surface->mesh();
        const sim::MeshTable want = cubesTwin(shape, 0.21F, value, tint, {-0.2F, 1.3F});
        CHECK(differingItems(got.positions, want.positions) == 0);
        CHECK(differingItems(got.normals, want.normals) == 0);
        CHECK(differingItems(got.indices, want.indices) == 0);
        if (!closed) continue;
        // By the divergence theorem, the flux of the position vector through the outward faces is three
        // times the volume.
        int living = 0, squares = 0;
        const auto lives = [&](int x, int y, int z) {
          return x >= 0 && y >= 0 && z >= 0 && x < size.x && y < size.y && z < size.z &&
                 value(x, y, z) >= 0.21F;
        };
        for (int z = 0; z < size.z; ++z)
          for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
              if (!lives(x, y, z)) continue;
              ++living;
              squares += !lives(x - 1, y, z) + !lives(x + 1, y, z) + !lives(x, y - 1, z) +
                         !lives(x, y + 1, z) + !lives(x, y, z - 1) + !lives(x, y, z + 1);
            }
        const AreaAndVolume found = areaAndVolumeOf(got);
        CHECK(found.volume == doctest::Approx(living * 0.375 * 0.375 * 0.375).epsilon(1e-4));
        CHECK(found.area == doctest::Approx(squares * 0.375 * 0.375).epsilon(1e-5));
        CHECK(got.indices.size() == static_cast<std::size_t>(6 * squares));
        for (std::size_t i = 0; i < got.indices.size(); i += 3) {
          const glm::vec3 a = got.positions[got.indices[i]], b = got.positions[got.indices[i + 1]],
                          c = got.positions[got.indices[i + 2]];
          CHECK(glm::dot(glm::cross(b - a, c - a), got.normals[got.indices[i]]) > 0.1F);
        }
      }
}

TEST_CASE("isosurface allocates the memory that it needs and reports it") {
  const sim::IsosurfaceShape shape{glm::ivec3(40), 1, {0, 0, 0}, true};
  const SurfaceOnDevice made(shape, 0, hashedValue, hashedValue, {0, 1});
  CHECK(made.settled == 1);
  CHECK(unevenEdges(made.surface->mesh(), false) == 0);
  CHECK(made.surface->mesh().indices.size() > 40 * 40 * 40);
}
