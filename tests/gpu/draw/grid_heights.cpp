// Tests grids that store only heights and the indices of one row, by comparison with equal grids that store
// full positions and all indices.
#include "gpu/draw/lamp_stage.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include <doctest/doctest.h>
#include <glm/gtc/packing.hpp>

using namespace simreel;

namespace {

constexpr glm::ivec2 hillSize(13, 9);
constexpr float hillCell = 0.25F, hillBase = 0.4F, hillRim = 0.3F;
constexpr glm::vec2 hillCorner(-1.5F, -1);

struct HillStage {
  /// `component`: component of the positions that holds the height; -1 to store full positions.
  explicit HillStage(int component) {
    std::vector<glm::vec4> points, colors;
    std::vector<std::uint16_t> numbers;
    std::vector<unsigned> corners;
    for (int y = 0; y < hillSize.y; ++y)
      for (int x = 0; x < hillSize.x; ++x) {
        const float bump = 0.5F * static_cast<float>((x * 5 + y * 3) % 7) / 7.0F;
        const bool walled = x == 0 || y == hillSize.y - 1;  // true for the vertices on the west and south
                                                            // sides
        const float height = walled ? std::max(bump, hillRim) : bump;
        const auto color = static_cast<float>((x + y) % 3);
        const glm::vec4 whole(hillCorner.x + static_cast<float>(x) * hillCell, hillBase + height,
                              hillCorner.y + static_cast<float>(y) * hillCell, color);
        // The other components hold arbitrary values that must be ignored.
        if (component < 0) points.push_back(whole);
        if (component == 1) points.emplace_back(77, bump, -3, color);
        if (component == 3) points.emplace_back(5, 6, 7, bump);
        numbers.push_back(glm::packHalf1x16(color));
      }
    const int rows = component < 0 ? hillSize.y - 1 : 1;
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x + 1 < hillSize.x; ++x) {
        const auto a = static_cast<unsigned>(y * hillSize.x + x), below = a + unsigned{hillSize.x};
        corners.insert(corners.end(), {a, below, a + 1, a + 1, below, below + 1});
      }
    numbers.push_back(0);
    buffer = gl::Buffer::of<glm::vec4>("hills", points);
    view = gl::Texture::view("hills", GL_RGBA32F, buffer);
    numberBuffer = gl::Buffer::of<std::uint16_t>("numbers", numbers);
    numberView = gl::Texture::view("numbers", GL_R16F, numberBuffer, 2);
    paletteBuffer = gl::Buffer::of<glm::vec4>(
        "palette",
        std::vector<glm::vec4>{{0.8F, 0.2F, 0.1F, 0}, {0.1F, 0.7F, 0.2F, 0}, {0.2F, 0.3F, 0.9F, 0}});
    palette = gl::Texture::view("palette", GL_RGBA32F, paletteBuffer);
    indices = gl::Buffer::of<unsigned>("indices", corners);
    heights.corner = hillCorner;
    heights.cell = hillCell;
    heights.base = hillBase;
    heights.component = component;
    heights.walls = 1 | 8;
    heights.rim = hillRim;
    if (component == 3) heights.colors = &numberView;
    surface.positions = &view;
    surface.grid = hillSize;
    surface.vertexCount = hillSize.x * hillSize.y;
    surface.indices = &indices;
    surface.indexCount = (hillSize.x - 1) * (hillSize.y - 1) * 6;
    surface.doubleSided = true;
    surface.palette = &palette;
    surface.material = &material;
    if (component < 0) return;
    surface.heights = &heights;
    surface.rowIndices = (hillSize.x - 1) * 6;
  }
  HillStage(const HillStage&) = delete;
  HillStage& operator=(const HillStage&) = delete;
  HillStage(HillStage&&) = delete;
  HillStage& operator=(HillStage&&) = delete;
  ~HillStage() = default;

  gl::Buffer buffer, numberBuffer, paletteBuffer, indices;
  gl::Texture view, numberView, palette;
  scene::Material material;
  sim::GridHeights heights;
  sim::Surface surface;
};

}  // namespace

TEST_CASE("surfaces: a heights-only grid with one row of indices is drawn like the full grid") {
  testContext();
  scene::Scene scene = darkScene();
  scene.camera.position = glm::vec3(1.5F, 3, 4);
  scene.camera.target = glm::vec3(0, 0.4F, 0);
  scene.sun.direction = glm::vec3(0.5F, 0.6F, 0.3F);
  scene.lights = {lampAt({-0.6F, 1.6F, 0.5F}, 12, true)};
  const HillStage whole(-1), plain(1), ground(3);
  GridStage roof({4, 4}, {-0.5F, 1.2F, -0.4F}, {0.8F, 0, 0}, {0, 0, 0.7F});
  const Picture want = drawn(scene, {.surfaces = {whole.surface, roof.surface}}, {97, 65});
  int lit = 0;
  for (int y = 0; y < 65; ++y)
    for (int x = 0; x < 97; ++x) lit += want.brightness(x, y) > 60 ? 1 : 0;
  CHECK(lit > 800);
  for (const HillStage* stage : {&plain, &ground}) {
    CAPTURE(stage->heights.component);
    const Picture got = drawn(scene, {.surfaces = {stage->surface, roof.surface}}, {97, 65});
    CHECK(got.bytes == want.bytes);
  }
}
