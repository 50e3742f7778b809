// Measures the comparison of 1920x1080 pictures: pairs of encoded files, and the metrics of a pair that
// differs. A pair of files with identical pixels must take less than 5 ms.
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include "golden/compare/compare.hpp"

#include "frame/image.hpp"
#include "golden/compare/difference_image.hpp"
#include "golden/compare/flip.hpp"
#include "golden/compare/ssim.hpp"
#include "golden/files/png_check.hpp"
#include "golden/pictures/sequence_diff.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <benchmark/benchmark.h>
#include <stb/stb_image_write.h>

using namespace simreel;

namespace {

constexpr int width = 1920, height = 1080;

/// Returns an integer hash (PCG) of a pixel's coordinates, 0 to 255.
int noise(int x, int y) {
  std::uint32_t state = std::uint32_t(y * width + x) * 747796405u + 2891336453u;
  state = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return int(((state >> 22u) ^ state) & 255u);
}

/// Returns a picture of woven cloth with grain, which is hard to compress.
frame::Image picture(int shift) {
  frame::Image image{width, height, {}};
  image.bytes.reserve(std::size_t(width) * height * 4);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double fold = 0.6 + 0.3 * std::sin(0.01 * (x + shift) + 0.004 * y);
      const double weave = 0.92 + 0.04 * std::sin(x * 0.9) + 0.04 * std::sin(y * 0.9);
      const int light = int(200 * fold * weave) + noise(x, y) / 64;
      for (const int value : {light, light * 2 / 3, light / 2 + 20, 255})
        image.bytes.push_back(std::uint8_t(value));
    }
  return image;
}

const frame::Image& first() {
  static const frame::Image image = picture(0);
  return image;
}
/// Returns a picture that differs from first() in nearly every pixel.
const frame::Image& second() {
  static const frame::Image image = picture(3);
  return image;
}

/// Creates a folder with files and removes it in the destructor.
class Files {
 public:
  Files() : folder_(std::filesystem::temp_directory_path() / "simreel-bench-compare") {
    std::filesystem::create_directories(folder_);
  }
  ~Files() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;
  Files(Files&&) = delete;
  Files& operator=(Files&&) = delete;
  std::filesystem::path write(const char* name, const std::vector<std::byte>& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    return folder_ / name;
  }

 private:
  std::filesystem::path folder_;
};

/// Returns a PNG with the same pixels and an alpha channel, encoded by unmodified stb_image_write.
std::vector<std::byte> otherEncoder(const frame::Image& image) {
  int size = 0;
  unsigned char* png =
      stbi_write_png_to_mem(image.bytes.data(), image.width * 4, image.width, image.height, 4, &size);
  const auto* bytes = reinterpret_cast<const std::byte*>(png);
  std::vector<std::byte> file(bytes, bytes + size);
  std::free(png);
  return file;
}

scene::Tolerance exact() {
  scene::Tolerance tolerance;
  tolerance.maxChannelDiff = 0;
  tolerance.maxDiffRatio = 0;
  return tolerance;
}

void pairOfFiles(benchmark::State& state, const std::vector<std::byte>& a,
                 const std::vector<std::byte>& b) {
  const Files files;
  const golden::Pair pair{"pair", files.write("a.png", a), files.write("b.png", b)};
  for (auto _ : state) benchmark::DoNotOptimize(golden::comparePair(pair, {exact(), {}}, {}, false));
  state.counters["file_KiB"] = double(a.size()) / 1024;
}

void identicalFiles(benchmark::State& state) {
  pairOfFiles(state, frame::encodePng(first(), {{"Title", "one"}}),
              frame::encodePng(first(), {{"Title", "two"}}));
}

void equalPixelsOtherEncoder(benchmark::State& state) {
  pairOfFiles(state, frame::encodePng(first(), {}), otherEncoder(first()));
}

void measureEqual(benchmark::State& state) {
  const frame::Image copy = first();
  for (auto _ : state) benchmark::DoNotOptimize(golden::measure(first(), copy, exact()));
}

/// Measures a pair that differs in nearly every pixel.
void measureDiffering(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(golden::measure(first(), second(), exact()));
}

/// Measures a pair that differs in one small area, as after a small motion of an edge.
void measureSmallArea(benchmark::State& state) {
  frame::Image changed = first();
  for (int y = 500; y < 540; ++y)
    for (int x = 900; x < 940; ++x) changed.bytes[std::size_t(y * width + x) * 4] ^= 0x40;
  for (auto _ : state) benchmark::DoNotOptimize(golden::measure(first(), changed, exact()));
}

template <double (*metric)(const frame::Image&, const frame::Image&)>
void metricOf(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(metric(first(), second()));
}

void difference(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(golden::differenceImage(first(), second()));
}

}  // namespace

BENCHMARK(identicalFiles)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(equalPixelsOtherEncoder)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(measureEqual)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(measureSmallArea)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(measureDiffering)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(metricOf<golden::psnr>)->Name("  of it psnr")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(metricOf<golden::ssim>)->Name("  of it ssim")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(metricOf<golden::flipMean>)->Name("  of it flip")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(difference)->Name("differenceImage")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_MAIN();
