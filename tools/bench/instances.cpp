// Measures the drawing of crowds at 640x360 with 4 samples, and of a million instances at 1280x720. The
// time includes shadow, culling, drawing and tone mapping, but no simulation or readback. One item is one
// instance.
#include "draw/screen/renderer.hpp"
#include "gl/buffer.hpp"
#include "gl/context.hpp"
#include "sim/grid/color_map.hpp"

#include <cmath>
#include <random>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

struct Crowd {
  explicit Crowd(int count) {
    std::mt19937 dice(1);
    std::vector<glm::vec4> places;
    std::vector<glm::vec4> speeds;
    const auto number = [&] { return static_cast<float>(dice() >> 8U) / 8388608.0F - 1.0F; };
    while (static_cast<int>(places.size()) < count) {
      const glm::vec3 p(number(), number(), number());
      if (glm::dot(p, p) > 1) continue;
      places.emplace_back(p + glm::vec3(0, 1.2F, 0), 1.0F);
      speeds.emplace_back(glm::cross(p, glm::vec3(0, 1, 0)), 0.5F);
    }
    positions = gl::Buffer::of<glm::vec4>("positions", places);
    velocities = gl::Buffer::of<glm::vec4>("velocities", speeds);
    positionView = gl::Texture::view("positions", GL_RGBA32F, positions);
    velocityView = gl::Texture::view("velocities", GL_RGBA32F, velocities);
    instances.positions = &positionView;
    instances.velocities = &velocityView;
    instances.capacity = count;
    instances.material = &material;
    instances.colors = &stops;
    instances.colorBy = sim::Instances::ColorBy::speed;
    instances.size = 1.0F / std::cbrt(static_cast<float>(count));
  }
  gl::Buffer positions, velocities;
  gl::Texture positionView, velocityView;
  std::vector<glm::vec3> stops = sim::colorMapStops("viridis");
  scene::Material material;
  sim::Instances instances;
};

void frame(benchmark::State& state, sim::Instances::Shape shape, bool additive, float bloom,
           glm::ivec2 size = {640, 360}, int samples = 4, bool shadow = true) {
  Crowd crowd(static_cast<int>(state.range(0)));
  crowd.instances.shape = shape;
  crowd.instances.additive = additive;
  scene::Scene scene;
  scene.camera.position = glm::vec3(0, 2.2F, 5);
  scene.camera.target = glm::vec3(0, 1, 0);
  scene.hasGround = true;
  scene.ground.height = 0;
  scene.render.bloom.strength = bloom;
  scene.sun.shadow = shadow;
  draw::Renderer renderer(scene, size, samples);
  const sim::Drawables drawables = {.instances = {crowd.instances}};
  renderer.draw(0, drawables);
  glFinish();
  int drawn = 0;
  for (auto _ : state) {
    renderer.draw(0, drawables);
    if (++drawn % 8 == 0)
      glFinish();  // Up to 8 frames are in flight, because a real sequence also has
                   // several.
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.counters["frames/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const gl::Context context;
  fmt::print("device: {}\n", context.device().name);
  const bool software = context.device().software;
  using Shape = sim::Instances::Shape;
  const auto addFor = [](int count, const char* name, auto... args) {
    benchmark::RegisterBenchmark(name, [=](benchmark::State& state) { frame(state, args...); })
        ->Arg(count)
        ->MeasureProcessCPUTime()
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  };
  if (!software) {
    const glm::ivec2 hd(1280, 720);
    addFor(1000000, "hd/sprites", Shape::sprite, false, 0.0F, hd, 4, true);
    addFor(1000000, "hd/sprites-unshadowed", Shape::sprite, false, 0.0F, hd, 4, false);
    addFor(1000000, "hd/sprites-unshadowed-1-sample", Shape::sprite, false, 0.0F, hd, 1, false);
    addFor(1000000, "hd/glows", Shape::sprite, true, 0.0F, hd, 4, false);
    addFor(1000000, "hd/glows-1-sample", Shape::sprite, true, 0.0F, hd, 1, false);
  }
  for (const int count : {1024, 131072, 1 << 20}) {
    if (software && count > 131072) continue;
    const auto add = [&](const char* name, auto... args) {
      addFor(count, name, args..., glm::ivec2(640, 360), 4, true);
    };
    add("instances/sprites", Shape::sprite, false, 0.0F);
    add("instances/spheres", Shape::sphere, false, 0.0F);
    add("instances/glows", Shape::sprite, true, 0.0F);
    add("instances/glows-bloom", Shape::sprite, true, 0.5F);
  }
  benchmark::RunSpecifiedBenchmarks();
}
