// Tests fields drawn by kernels. Compares them with their CPU version bit by bit, with the driver's picture
// within its rounding, and with their equation in double precision.
#include "draw/overlay/field_kernel.hpp"
#include "gpu/draw/overlay_stage.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>

#include <doctest/doctest.h>

using namespace simreel;
using Cells = sim::Field::Cells;
using Layer = sim::FieldDisplay::Layer;
using Fit = sim::FieldDisplay::Fit;

namespace {

const std::vector<glm::vec3> someStops = {{0.02F, 0.1F, 0.9F}, {1, 0.5F, 0}, {0.2F, 1, 0.3F}};

double bump(int x, int y) {
  return 0.5 + 0.3 * std::sin(0.37 * x) * std::cos(0.21 * y) + 0.02 * ((x * 7 + y * 13) % 10);
}

/// Returns fields with all types of cells and all display options.
std::vector<std::unique_ptr<FieldStage>> allKinds() {
  std::vector<std::unique_ptr<FieldStage>> stages;
  int n = 0;
  for (const Cells cells : {Cells::bits, Cells::bytes, Cells::floats, Cells::colors})
    for (const bool categories : {false, true})
      for (const bool smooth : {false, true})
        for (const float zoom : {3.7F, 0.9F, 0.045F}) {
          if (categories && (cells == Cells::bits || cells == Cells::colors || smooth)) continue;
          const auto value = [&](int x, int y) {
            if (categories) return std::floor(4 * bump(x, y));
            return cells == Cells::bits    ? double((x * 7 + y * 13) % 3 == 0)
                   : cells == Cells::bytes ? std::floor(255 * std::min(bump(x, y), 1.0))
                                           : bump(x, y);
          };
          auto stage = std::make_unique<FieldStage>(cells, glm::ivec2(301, 203), value,
                                                    FieldStage::Memory(), someStops);
          stage->field.categories = categories;
          if (cells == Cells::bytes) stage->field.range = {10, 250};
          sim::FieldDisplay& display = stage->display;
          display.smooth = smooth;
          display.zoom = zoom;
          display.tiled = n % 3 == 1;
          display.opacity = n % 4 == 1 ? 0.37F : 1.0F;
          display.relief = n % 5 == 2 ? 1.3F : n % 5 == 4 ? -0.6F : 0.0F;
          display.center = glm::vec3(0.31F, 0.77F, 0);
          display.border = {0.1F, 0.02F, 0.3F};
          display.fit = n % 2 == 0 ? Fit::contain : Fit::stretch;
          if (n % 7 == 3) display.corner = {0.2F, 0.1F, 0};
          if (n % 7 == 3) display.extent = {0.5F, 0.7F, 0};
          stages.push_back(std::move(stage));
          ++n;
        }
  return stages;
}

const glm::ivec2 odd(83, 61);

OverlayPicture<OverlayBytes> over(const std::vector<sim::Field>& fields,
                                  const OverlayPicture<OverlayBytes>& below, draw::Rasterizer rasterizer) {
  const sim::Drawables drawables{.fields = fields};
  draw::FieldPass pass(below.size, rasterizer);
  const gl::Texture image = imageOf(below);
  pass.prepare(drawables, 0);
  if (rasterizer == draw::Rasterizer::exact) {
    pass.drawOver(drawables, 0, image);
  } else {
    const gl::Framebuffer target("picture", &image, nullptr);
    target.bind();
    pass.draw(drawables, Layer::over, 0);
  }
  return readBack<OverlayBytes>(image);
}

}  // namespace

TEST_CASE(
    "exact fields: every kind has the bits of its twin over a picture, and the driver's within rounding") {
  testContext();
  const auto below = someBytes(odd), opaque = someBytes(odd, true);
  for (const auto& stage : allKinds()) {
    const FieldOnPicture there(*stage, odd);
    CAPTURE(there.inputs.cellKind);
    CAPTURE(there.inputs.colored);
    CAPTURE(there.inputs.reduces);
    CAPTURE(there.inputs.relief);
    CAPTURE(there.inputs.perPixel.x);
    auto wanted = below;
    there.twin().over(wanted, there.part);
    const auto exact = over({stage->field}, below, draw::Rasterizer::exact);
    CHECK(differing(exact, wanted) == 0);
    CHECK(differing(exact, below) > 0);
    auto wantedOpaque = opaque;
    there.twin().over(wantedOpaque, there.part);
    const auto exactOpaque = over({stage->field}, opaque, draw::Rasterizer::exact);
    CHECK(differing(exactOpaque, wantedOpaque) == 0);
    const Distance pixelDifference =
        distance(exactOpaque, over({stage->field}, opaque, draw::Rasterizer::driver));
    CHECK(pixelDifference.max <= 1);
    // The tolerance is needed because the software driver blends with 8 bits, with errors of half a step at
    // some pixels. A GPU rounds one byte in forty differently.
    CHECK(pixelDifference.mean < (there.inputs.opacity < 1 ? 0.3 : 0.03));
  }
}

TEST_CASE("exact fields: averaged texels have the bits of their twin, values and light") {
  testContext();
  for (const auto& stage : allKinds())
    for (const int reduction : {1, 3, 17}) {
      const FieldOnPicture there(*stage, odd);
      draw::FieldKernel kernel;
      draw::FieldColors colors;
      colors.update(stage->colors);
      const bool colored = there.inputs.colored;
      const gl::Texture texture = draw::FieldKernel::texture(stage->field, reduction, colored, 1);
      kernel.average(stage->field, colors, texture, colored);
      const auto found = readBack<glm::vec4>(texture);
      auto wanted = FieldTwin(there.inputs).averaged(found.size);
      if (!colored)
        for (glm::vec4& texel : wanted) texel = {texel.x, 0, 0, 1};
      CHECK(differing(found, {found.size, wanted}) == 0);
    }
}

TEST_CASE("exact fields: averaged light is of the nearest half floats, zero where those are subnormal") {
  testContext();
  // Relative values from 2^-16 to 4. These are powers of two, their neighbours, and values in between.
  const auto value = [](int x, int y) {
    const double power = std::exp2(y % 18 - 16);
    return x == 0   ? power
           : x == 1 ? power * (1 - 0x1p-13)
           : x == 2 ? power * (1 + 0x1p-13)
                    : power * (1 + 0.0173 * x);
  };
  const FieldStage stage(Cells::floats, {43, 37}, value, FieldStage::Memory(), someStops);
  draw::FieldKernel kernel;
  draw::FieldColors colors;
  colors.update(stage.colors);
  const gl::Texture texture = draw::FieldKernel::texture(stage.field, 1, true, 1);
  kernel.average(stage.field, colors, texture, true);
  const auto found = readBack<glm::vec4>(texture);
  REQUIRE(found.size == stage.field.size);
  int wrong = 0;
  for (int y = 0; y < 37; ++y)
    for (int x = 0; x < 43; ++x) {
      const auto place = static_cast<double>(static_cast<float>(value(x, y)));
      const double unit = std::exp2(std::floor(std::log2(place)) - 10);
      const double half = place < 0x1p-14 ? 0 : std::nearbyint(place / unit) * unit;
      wrong += static_cast<double>(found.pixels[static_cast<std::size_t>(43 * y + x)].w) != half ? 1 : 0;
    }
  CHECK(wrong == 0);
}

TEST_CASE(
    "exact fields: behind light, the later before the earlier, has the twin's bits and the driver's "
    "light") {
  testContext();
  const auto front = someLight(odd);
  auto stages = allKinds();
  for (std::size_t i = 0; i + 1 < stages.size(); i += 2) {
    std::vector<sim::Field> fields;
    for (const auto* stage : {stages[i].get(), stages[i + 1].get()}) {
      const_cast<FieldStage*>(stage)->display.layer = Layer::behind;
      fields.push_back(stage->field);
    }
    stages[i + 1]->display.opacity = 0.6F;
    const sim::Drawables drawables{.fields = fields};
    for (const bool topFirst : {false, true}) {
      draw::FieldPass pass(odd, draw::Rasterizer::exact);
      const auto flipped = [&](OverlayPicture<glm::vec4> picture) {
        if (!topFirst)
          for (int y = 0; y < odd.y / 2; ++y)
            for (int x = 0; x < odd.x; ++x) std::swap(picture.at(x, y), picture.at(x, odd.y - 1 - y));
        return picture;
      };
      const gl::Texture image = imageOf(flipped(front));
      pass.prepare(drawables, 0);
      pass.drawBehind(drawables, 0, image, topFirst);
      const auto found = flipped(readBack<glm::vec4>(image));
      auto wanted = front;
      for (const std::size_t k : {i + 1, i}) {
        const FieldOnPicture there(*stages[k], odd);
        there.twin().behind(wanted, there.part);
      }
      CHECK(differing(found, wanted) == 0);
    }
    // The driver first draws the fields behind the scene, in order, and then the other fields over them.
    draw::FieldPass pass(odd);
    const gl::Texture image = imageOf(OverlayPicture<glm::vec4>{
        odd, std::vector<glm::vec4>(static_cast<std::size_t>(odd.x * odd.y), glm::vec4(0))});
    const gl::Framebuffer target("light", &image, nullptr);
    pass.prepare(drawables, 0);
    target.bind();
    pass.draw(drawables, Layer::behind, 0);
    auto drawn = readBack<glm::vec4>(image);
    auto exact = front;
    for (const std::size_t k : {i + 1, i}) {
      const FieldOnPicture there(*stages[k], odd);
      there.twin().behind(exact, there.part);
    }
    float worst = 0;
    for (int y = 0; y < odd.y; ++y)
      for (int x = 0; x < odd.x; ++x) {
        auto light = front;
        const glm::vec4 before = light.at(x, y);
        const glm::vec4 sum = before + (1 - before.a) * drawn.at(x, odd.y - 1 - y);
        for (int k = 0; k < 4; ++k) worst = std::max(worst, std::abs(sum[k] - exact.at(x, y)[k]));
      }
    CHECK(worst < 2e-5F);
  }
}

TEST_CASE("exact fields: a pixel is the average of the light under it, in double precision") {
  testContext();
  const glm::ivec2 cells{32, 24};
  const auto bit = [](int x, int y) { return ((x * 7 + y * 13) ^ (x * y)) % 3 == 0 ? 1 : 0; };
  FieldStage stage(Cells::bits, cells, bit);
  stage.display.fit = Fit::stretch;
  for (const glm::ivec2 pixels : {glm::ivec2(17, 13), glm::ivec2(45, 31), glm::ivec2(131, 7)}) {
    const auto picture = over({stage.field}, someBytes(pixels), draw::Rasterizer::exact);
    double worst = 0;
    for (int py = 0; py < pixels.y; ++py)
      for (int px = 0; px < pixels.x; ++px) {
        const double x0 = double(px) * cells.x / pixels.x, x1 = double(px + 1) * cells.x / pixels.x;
        const double y0 = double(py) * cells.y / pixels.y, y1 = double(py + 1) * cells.y / pixels.y;
        double sum = 0;
        for (int y = 0; y < cells.y; ++y)
          for (int x = 0; x < cells.x; ++x)
            sum += bit(x, y) * std::max(0.0, std::min(x1, x + 1.0) - std::max(x0, double(x))) *
                   std::max(0.0, std::min(y1, y + 1.0) - std::max(y0, double(y)));
        const auto pixel = picture.pixels[static_cast<std::size_t>(py * pixels.x + px)];
        worst = std::max(worst, std::abs(pixel[0] - srgbByte(sum / ((x1 - x0) * (y1 - y0)))));
        CHECK(pixel[3] == 255);
      }
    CHECK(worst < 0.7);  // half a step of rounding, plus the error of the square root approximation
  }
}

namespace exact_fields {

/// Returns the max difference (in bytes) between a magnified smooth field and its quadratic spline in
/// double precision.
double fromSpline(Cells kind) {
  const glm::ivec2 cells{7, 5};
  const auto value = [](int x, int y) { return 0.1 + 0.05 * ((3 * x + 5 * y) % 11); };
  FieldStage stage(kind, cells, value, FieldStage::Memory(), {glm::vec3(0), glm::vec3(1)});
  stage.display.fit = Fit::stretch;
  stage.display.smooth = true;
  const glm::ivec2 pixels(91, 55);
  const FieldOnPicture there(stage, pixels);
  const auto light = [&](int x, int y) {
    const int i = std::clamp(x, 0, cells.x - 1), j = std::clamp(y, 0, cells.y - 1);
    const auto& memory = there.inputs;
    const int word = memory.firstWord + j * memory.rowWords + i * memory.cellWords;
    return static_cast<double>(
        std::bit_cast<float>(memory.words[static_cast<std::size_t>(word / 4)][word % 4]));
  };
  // Returns the integral of a tent of width 2 over a box of width 1.
  const auto share = [](double pixelDifference) {
    const double d = std::abs(pixelDifference);
    return d < 0.5 ? 0.75 - d * d : d < 1.5 ? 0.5 * (1.5 - d) * (1.5 - d) : 0.0;
  };
  const auto picture = over({stage.field}, someBytes(pixels), draw::Rasterizer::exact);
  double worst = 0;
  for (int py = 0; py < pixels.y; ++py)
    for (int px = 0; px < pixels.x; ++px) {
      const double x = (px + 0.5) * cells.x / pixels.x, y = (py + 0.5) * cells.y / pixels.y;
      double sum = 0;
      for (int j = -2; j < cells.y + 2; ++j)
        for (int i = -2; i < cells.x + 2; ++i) sum += light(i, j) * share(x - i - 0.5) * share(y - j - 0.5);
      const auto pixel = picture.pixels[static_cast<std::size_t>(py * pixels.x + px)];
      worst = std::max(worst, std::abs(pixel[0] - srgbByte(sum)));
    }
  return worst;
}

}  // namespace exact_fields

TEST_CASE("exact fields: magnified colours and smooth values are quadratic splines, in double precision") {
  testContext();
  CHECK(exact_fields::fromSpline(Cells::colors) < 0.8);
  CHECK(exact_fields::fromSpline(Cells::floats) < 0.8);
}

TEST_CASE("exact fields: relief in double precision") {
  testContext();
  // A ramp has the same slope everywhere except at its ends.
  const double step = 0.02;
  for (const double sign : {1.0, -1.0}) {
    const float relief = 0.9F;
    FieldStage stage(Cells::floats, {40, 30}, [&](int x, int y) { return 0.1 + step * x + 0.5 * step * y; },
                     {3, 5, 2}, {glm::vec3(0.3F), glm::vec3(0.3F)});
    stage.display.smooth = true;
    stage.display.relief = relief * static_cast<float>(sign);
    const auto picture = over({stage.field}, someBytes({120, 90}), draw::Rasterizer::exact);
    const double nx = -sign * 7 * relief * step, ny = 0.5 * nx, n = std::sqrt(nx * nx + ny * ny + 1);
    const double l[] = {-0.55, -0.65, 0.75};
    const double length = std::sqrt(l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);
    const double h[] = {l[0] / length, l[1] / length, l[2] / length + 1};
    const double half = std::sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
    const double facing = (nx * l[0] + ny * l[1] + l[2]) / (n * l[2]);
    const double diffuse = facing > 1 ? 1 + 0.45 * (1 - std::exp(1 - facing))
                                      : std::max(0.16 + 0.84 * facing, 0.16 * std::exp(facing));
    const double shine =
        std::pow((nx * h[0] + ny * h[1] + h[2]) / (n * half), 24) - std::pow(h[2] / half, 24);
    const double tint[] = {1.0, 0.97, 0.92};
    for (std::size_t k = 0; k < 3; ++k) {
      const double light = 0.3 * diffuse + std::max(shine, 0.0) * (0.02 + 0.3 * std::sqrt(0.3) * tint[k]);
      CHECK(std::abs(picture.pixels[45 * 120 + 60][k] - srgbByte(light)) < 0.8);
    }
  }
}

TEST_CASE("exact fields: cells that are no numbers have the first colour, infinite ones the last") {
  testContext();
  const double lost = std::numeric_limits<double>::quiet_NaN();
  const double huge = std::numeric_limits<double>::infinity();
  FieldStage stage(Cells::floats, {7, 3},
                   [&](int x, int) {
                     return x == 1 ? lost : x == 2 ? huge : x == 3 ? -huge : 0.5;
                   },
                   {3, 5, 2}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  for (const bool smooth : {false, true}) {
    stage.display.smooth = smooth;
    for (const auto rasterizer : {draw::Rasterizer::exact, draw::Rasterizer::driver}) {
      const auto picture = over({stage.field}, someBytes({77, 33}), rasterizer);
      const auto at = [&](int x) { return picture.pixels[static_cast<std::size_t>(77 * 16 + x)]; };
      CHECK(at(16) == OverlayBytes{255, 0, 0, 255});
      CHECK(at(38) == OverlayBytes{255, 0, 0, 255});
      if (!smooth) CHECK(at(27) == OverlayBytes{0, 0, 255, 255});
      CHECK(at(60)[1] == 255);  // the cells on both sides of this one are numbers
    }
  }
}

TEST_CASE("exact fields: what is beyond 1e18 is 1e18, and no number is the least") {
  testContext();
  for (const double sign : {1.0, -1.0}) {
    const auto value = [&](int x, int) {
      constexpr std::array<double, 5> factors = {0.995, 1, 1.015, 2,
                                                 std::numeric_limits<double>::infinity()};
      return x == 5 ? std::numeric_limits<double>::quiet_NaN()
                    : sign * factors[static_cast<std::size_t>(x)] * 1e18;
    };
    FieldStage stage(Cells::floats, {6, 1}, value, {3, 5, 2}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    stage.display.fit = Fit::stretch;
    const auto last = sign < 0 ? 6U : 5U;  // index after the last cell whose displayed value is the limit,
                                           // 1e18 or -1e18
    stage.field.range = sign < 0 ? glm::vec2(-1.02e18F, -0.98e18F) : glm::vec2(0.98e18F, 1.02e18F);
    const auto picture = over({stage.field}, someBytes({60, 7}), draw::Rasterizer::exact);
    const auto at = [&](std::size_t x) { return picture.pixels[180 + 10 * x + 5]; };
    CHECK(at(0) != at(1));
    CHECK(at(1) == OverlayBytes{0, 255, 0, 255});
    for (std::size_t x = 2; x < last; ++x) CHECK(at(x) == at(1));
    if (sign > 0) CHECK(at(5) == OverlayBytes{255, 0, 0, 255});
  }
}

TEST_CASE("exact fields: repeated many times in a pixel, or without end") {
  testContext();
  FieldStage stage(Cells::bits, {5, 3}, [](int x, int) { return x < 2 ? 1 : 0; });
  for (const float zoom : {1e-3F, 1e-12F}) {
    stage.display.zoom = zoom;
    stage.display.tiled = true;
    const auto below = someBytes({33, 17});
    const FieldOnPicture there(stage, {33, 17});
    auto wanted = below;
    there.twin().over(wanted, there.part);
    const auto picture = over({stage.field}, below, draw::Rasterizer::exact);
    CHECK(differing(picture, wanted) == 0);
    if (zoom > 1e-4F) CHECK(std::abs(picture.pixels[200][0] - srgbByte(0.4)) < 3);
  }
}
