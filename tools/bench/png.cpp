// Compares the speed and file size of encodePng with unmodified stb_image_write on the same images and one
// core. encodePng must be at least 10 times as fast, and its files at most 1.1 times as large.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include "frame/image.hpp"

#include <stb/stb_image_write.h>

namespace {

using simreel::frame::Image;

constexpr int width = 1280;
constexpr int height = 720;

/// Returns an integer hash (PCG) of a pixel's coordinates, scaled to 0 to 1.
double noise(int x, int y) {
  std::uint32_t state = std::uint32_t(y * width + x) * 747796405u + 2891336453u;
  state = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return double((state >> 22u) ^ state) / 4294967296.0;
}

struct Colour {
  double r, g, b;
};

Colour operator*(Colour c, double s) {
  return {c.r * s, c.g * s, c.b * s};
}

Colour sky(double u, double v) {
  return {0.25 + 0.35 * v + 0.05 * u, 0.35 + 0.35 * v, 0.55 + 0.3 * v};
}

/// Returns a pixel of a studio background with a shaded sphere and its soft shadow.
Colour ball(int x, int y) {
  const double u = double(x) / width, v = double(y) / height;
  const double dx = (u - 0.5) * 16 / 9, dy = v - 0.5, r2 = dx * dx + dy * dy;
  if (r2 < 0.09) {
    const double nz = std::sqrt(0.09 - r2) / 0.3;
    const double light = std::max(0.0, 0.5 * nz - 1.4 * dx - 1.6 * dy);
    const double shine = std::pow(std::max(0.0, nz * 0.8 - dx - dy), 24) * 0.3;
    return {0.7 * light + 0.1 + shine, 0.25 * light + 0.08 + shine, 0.2 * light + 0.08 + shine};
  }
  const double shadow = 1 - 0.5 * std::exp(-40 * (dx * dx * 0.3 + (dy - 0.33) * (dy - 0.33)));
  return sky(u, v) * shadow;
}

/// Returns a pixel of folded woven cloth with fine texture in front of the background.
Colour cloth(int x, int y) {
  const double u = double(x) / width, v = double(y) / height;
  const double edge = 0.03 * std::sin(9 * u);
  if (u < 0.12 || u > 0.88 || v < 0.15 + edge || v > 0.85 + edge) return sky(u, v);
  const double fold = 0.6 + 0.25 * std::sin(14 * u + 3 * v) + 0.15 * std::sin(31 * u - 8 * v);
  const double weave = 0.92 + 0.04 * std::sin(x * 0.9) + 0.04 * std::sin(y * 0.9);
  const double stripe = std::fmod(u * 12 + 0.2 * std::sin(6 * v), 1.0) < 0.5 ? 1.0 : 0.55;
  return Colour{0.8 * stripe, 0.3 + 0.1 * stripe, 0.25} * (fold * weave);
}

/// Returns a pixel of the sphere with noise, as from sampled shadows or a dithered tone map.
Colour grain(int x, int y) {
  const Colour c = ball(x, y);
  const double n = (noise(x, y) - 0.5) * 3 / 255;
  return {c.r + n, c.g + n, c.b + n};
}

/// Returns a pixel of some thousands of small lit spheres (particles, bodies) in front of a plain colour.
Colour particles(int x, int y) {
  const int cellX = x / 16, cellY = y / 16;
  if (noise(cellX + 7, cellY * 3 + 1) < 0.55) {
    const double dx = x % 16 - 4 - 8 * noise(cellX, cellY), dy = y % 16 - 4 - 8 * noise(cellX + 640, cellY);
    const double radius = 3 + noise(cellX, cellY + 360), r2 = (dx * dx + dy * dy) / (radius * radius);
    if (r2 < 1)
      return Colour{0.3, 0.6, 0.95} * (0.25 + 0.75 * std::max(0.0, std::sqrt(1 - r2) - 0.3 * dx / radius));
  }
  return {0.02, 0.02, 0.03};
}

/// Returns a pixel of cells of a field like Gray-Scott's, coloured by a colour map.
Colour field(int x, int y) {
  const double u = x * 0.05, v = y * 0.05;
  const double f = std::sin(u + 2 * std::sin(0.7 * v)) * std::cos(v + 1.5 * std::sin(0.6 * u));
  const double t = 1 / (1 + std::exp(-6 * f));
  return {0.1 + 0.8 * t * t, 0.15 + 0.6 * t, 0.4 - 0.2 * t};
}

Image render(Colour (*shade)(int, int)) {
  Image image{width, height, {}};
  image.bytes.reserve(std::size_t(width) * height * 4);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Colour c = shade(x, y);
      for (const double linear : {c.r, c.g, c.b})
        image.bytes.push_back(
            std::uint8_t(std::pow(std::min(1.0, std::max(0.0, linear)), 1 / 2.2) * 255 + 0.5));
      image.bytes.push_back(255);
    }
  return image;
}

std::size_t encodeStock(const Image& image) {
  std::vector<std::uint8_t> rgb(std::size_t(width) * height * 3);
  for (std::size_t from = 0, to = 0; to < rgb.size(); from += 4, to += 3) {
    rgb[to] = image.bytes[from];
    rgb[to + 1] = image.bytes[from + 1];
    rgb[to + 2] = image.bytes[from + 2];
  }
  int size = 0;
  std::free(stbi_write_png_to_mem(rgb.data(), image.width * 3, image.width, image.height, 3, &size));
  return std::size_t(size);
}

std::size_t encodeOurs(const Image& image) {
  return simreel::frame::encodePng(image, {{"Software", "simreel"}}).size();
}

/// Returns the seconds of the fastest of several runs, and the size of the encoded file.
template <class Encode>
std::pair<double, std::size_t> best(const Encode& encode, const Image& image, int runs) {
  double shortest = 1e9;
  std::size_t size = 0;
  for (int run = 0; run < runs; ++run) {
    const auto begin = std::chrono::steady_clock::now();
    size = encode(image);
    shortest =
        std::min(shortest, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return {shortest, size};
}

void measure(benchmark::State& state, std::size_t (*encode)(const Image&), const Image& image) {
  std::size_t size = 0;
  for (auto _ : state) size = encode(image);
  state.SetBytesProcessed(state.iterations() * std::int64_t(width) * height * 3);
  state.counters["file_KiB"] = double(size) / 1024;
}

}  // namespace

int main(int argc, char** argv) {
  const std::pair<const char*, Image> images[] = {{"ball", render(ball)},
                                                  {"cloth", render(cloth)},
                                                  {"grain", render(grain)},
                                                  {"field", render(field)},
                                                  {"particles", render(particles)}};
  for (const auto& [name, image] : images) {
    benchmark::RegisterBenchmark(fmt::format("stock/{}", name).c_str(), measure, encodeStock, image)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(fmt::format("simreel/{}", name).c_str(), measure, encodeOurs, image)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();

  fmt::print("\n{}x{}, best of several runs, stock stb / simreel\n", width, height);
  fmt::print("{:10} {:>9} {:>9} {:>8} {:>12}\n", "image", "stock ms", "ours ms", "speed", "size ratio");
  bool passed = true;
  for (const auto& [name, image] : images) {
    const auto [stockSeconds, stockSize] = best(encodeStock, image, 3);
    const auto [ourSeconds, ourSize] = best(encodeOurs, image, 15);
    const double speed = stockSeconds / ourSeconds, size = double(ourSize) / double(stockSize);
    fmt::print("{:10} {:9.1f} {:9.2f} {:7.1f}x {:12.3f}\n", name, stockSeconds * 1e3, ourSeconds * 1e3,
               speed, size);
    passed = passed && speed >= 10 && size <= 1.1;
  }
  fmt::print("bar (10x as fast, 1.1x the size): {}\n", passed ? "met" : "MISSED");
  return passed ? 0 : 1;
}
