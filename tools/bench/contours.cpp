// Measures marching squares for the floor and the walls of a cave, which is rebuilt in every frame. Prints
// milliseconds on the device, memory size and memory rate. The cave is noise that is smoothed five times.
// Each process measures one size: bench_contours [SIDE [FRAMES]].
#include "gl/context.hpp"
#include "gl/texture.hpp"
#include "sim/cave/growth.hpp"
#include "sim/cave/parameters.hpp"
#include "sim/contour/solid.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include <fmt/format.h>

using namespace simreel;

namespace {

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const int side = argc > 1 ? std::stoi(argv[1]) : 1024;
  const int frames = argc > 2 ? std::stoi(argv[2]) : 30;
  const gl::Context context;
  sim::CaveParameters p;
  p.size = {side, side};
  p.connect = false;
  p.ceiling = false;
  sim::CaveGrowth growth("cave", p, 1);
  growth.advance(p.lastStage());
  sim::Solid solid("cave", p.shape(0));
  sim::Field field;
  field.words = &growth.cells().view();
  field.cells = sim::Field::Cells::bits;
  field.size = p.size;
  field.rowWords = growth.grid().rowWords();
  const auto make = [&](float height) {
    solid.make(field, {0.0F, height});
    return solid.settle();
  };
  while (make(0.1F)) {  // The loop repeats until the buffers are large enough.
  }
  std::vector<double> took;
  for (int frame = 0; frame < frames; ++frame) {
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    gl::TimerQuery timer;
    timer.begin();
    solid.make(field, {0.0F, 0.2F + 0.01F * static_cast<float>(frame)});
    timer.end();
    glFinish();
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
    took.push_back(gl::softwareDriver() ? wall.count() : timer.nanoseconds() * 1e-6);
  }
  const sim::Surface surface = solid.surface();
  // The kernel reads the positions of the samples and writes six indices per square.
  const double bytes = double(side) * side * (16 + 24);
  const double milliseconds = median(took);
  fmt::print("device: {}\n", context.device().name);
  fmt::print("{}x{}: floor and walls {:.3f} ms (median of {}), {} indices at most\n", side, side,
             milliseconds, frames, surface.indexCount);
  fmt::print("limit: vertices and indices of the samples alone are {:.0f} MB, written at {:.0f} GB/s\n",
             bytes * 1e-6, bytes / milliseconds * 1e-6);
  return 0;
}
