#pragma once
#include "draw/screen/readback.hpp"
#include "draw/screen/renderer.hpp"
#include "gl/buffer.hpp"
#include "gl/texture.hpp"
#include "gpu/context.hpp"
#include "sim/core/drawable.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// A grid of vertices, stored like a cloth that a simulation publishes. Rows run along x. Each row is below
/// the previous one (towards -y of the grid's plane).
struct GridStage {
  GridStage(glm::ivec2 size, glm::vec3 corner, glm::vec3 alongX, glm::vec3 alongY) {
    std::vector<glm::vec4> points;
    std::vector<unsigned> corners;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        points.emplace_back(corner + alongX * (static_cast<float>(x) / static_cast<float>(size.x - 1)) +
                                alongY * (static_cast<float>(y) / static_cast<float>(size.y - 1)),
                            1.0F);
    for (int y = 0; y + 1 < size.y; ++y)
      for (int x = 0; x + 1 < size.x; ++x) {
        const auto a = static_cast<unsigned>(y * size.x + x);
        const auto below = a + static_cast<unsigned>(size.x);
        corners.insert(corners.end(), {a, below, a + 1, a + 1, below, below + 1});
      }
    buffer = simreel::gl::Buffer::of<glm::vec4>("grid positions", points);
    indices = simreel::gl::Buffer::of<unsigned>("grid indices", corners);
    view = simreel::gl::Texture::view("grid positions", GL_RGBA32F, buffer);
    surface.positions = &view;
    surface.grid = size;
    surface.vertexCount = static_cast<int>(points.size());
    surface.indices = &indices;
    surface.indexCount = static_cast<int>(corners.size());
    surface.doubleSided = true;
    surface.material = &material;
  }
  GridStage(const GridStage&) = delete;
  GridStage& operator=(const GridStage&) = delete;
  GridStage(GridStage&&) = delete;
  GridStage& operator=(GridStage&&) = delete;
  ~GridStage() = default;

  /// Sets the linear RGB colour of each vertex, row by row.
  void tint(const std::vector<glm::vec4>& colors) {
    colorBuffer = simreel::gl::Buffer::of<glm::vec4>("grid colours", colors);
    colorView = simreel::gl::Texture::view("grid colours", GL_RGBA32F, colorBuffer);
    surface.colors = &colorView;
  }

  simreel::gl::Buffer buffer, indices, colorBuffer;
  simreel::gl::Texture view, colorView;
  simreel::scene::Material material;
  simreel::sim::Surface surface;
};

/// A finished picture. Row 0 is at the top.
struct Picture {
  glm::ivec2 size{0};
  std::vector<std::uint8_t> bytes;

  [[nodiscard]] glm::ivec3 at(int x, int y) const {
    const auto i = static_cast<std::size_t>(y * size.x + x) * 4;
    return {bytes[i], bytes[i + 1], bytes[i + 2]};
  }
  [[nodiscard]] int brightness(int x, int y) const {
    const glm::ivec3 c = at(x, y);
    return c.x + c.y + c.z;
  }
};

/// Returns the default renderer options of the tests. The environment variable SIMREEL_TEST_RASTERIZER
/// ("driver" or "exact") overrides the rasterizer of the scenes.
inline simreel::draw::RendererOptions testOptions() {
  const char* chosen = std::getenv("SIMREEL_TEST_RASTERIZER");
  if (chosen == nullptr) return {};
  return {.rasterizer = std::string(chosen) == "driver" ? simreel::scene::Rasterizer::driver
                                                        : simreel::scene::Rasterizer::exact};
}

inline Picture drawn(const simreel::scene::Scene& scene, const simreel::sim::Drawables& drawables,
                     glm::ivec2 size, int samples = 4,
                     const simreel::draw::RendererOptions& options = testOptions()) {
  simreel::draw::Renderer renderer(scene, size, samples, options);
  simreel::draw::Readback readback(size);
  renderer.draw(0, drawables);
  readback.start(renderer.target(), 7);
  auto taken = readback.nextPicture(true);
  testContext().check();
  return {size, std::move(taken.value().second)};
}

/// Returns a scene with a black sky and with the sun at the camera's position, so that only the objects of
/// the test are visible.
inline simreel::scene::Scene darkScene() {
  simreel::scene::Scene scene;
  scene.camera.position = glm::vec3(0, 0, 5);
  scene.sun.direction = glm::vec3(0, 0, 1);
  scene.sun.color = glm::vec3(1);
  scene.sun.intensity = 3.14159265F;
  scene.sky.zenith = glm::vec3(0);
  scene.sky.horizon = glm::vec3(0);
  scene.sky.ground = glm::vec3(0);
  return scene;
}

/// Returns the sRGB byte of linear light before dithering, computed like the tone map in
/// glsl/draw/screen/film.glsl but in double precision.
inline std::array<double, 3> filmByte(std::array<double, 3> light) {
  const double into[3][3] = {
      {0.59719, 0.35458, 0.04823}, {0.07600, 0.90834, 0.01566}, {0.02840, 0.13383, 0.83777}};
  const double out[3][3] = {
      {1.60475, -0.53108, -0.07367}, {-0.10208, 1.10813, -0.00605}, {-0.00327, -0.07276, 1.07602}};
  std::array<double, 3> v{};
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) v[i] += into[i][j] * 1.3 * light[j];
    v[i] = (v[i] * (v[i] + 0.0245786) - 0.000090537) / (v[i] * (0.983729 * v[i] + 0.4329510) + 0.238081);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    double x = 0;
    for (std::size_t j = 0; j < 3; ++j) x += out[i][j] * v[j];
    x = std::fmin(std::fmax(x, 0), 1);
    result[i] = 255 * (x < 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
  }
  return result;
}

/// True if each channel of `c` differs from the same channel of `wanted` by at most `tolerance`.
inline bool near(glm::ivec3 c, const std::array<double, 3>& wanted, double tolerance) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(c[i] - wanted[static_cast<std::size_t>(i)]) > tolerance) return false;
  return true;
}
