// Measures rays per processor second through 320,000 triangles of a waving sheet, and through as many
// randomly placed triangles. Compares the kernel of render.quality "high", the same algorithm as a plain
// loop, and Embree if it is installed. All trace the same rays, which start on the sheet and point into the
// hemisphere above it, as for lighting. The rays are in the order of a picture's pixels.
#include "base/hash.hpp"
#include "draw/exact/rays/bindings.hpp"
#include "draw/exact/rays/hierarchy.hpp"
#include "draw/exact/visibility.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"
#include "reference/ray_twin.hpp"

#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <ctime>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#ifdef SIMREEL_BENCH_EMBREE
#include <embree3/rtcore.h>
#endif

using namespace simreel;

namespace {

struct Soup {
  const char* name;
  std::vector<glm::vec4> places;  ///< vertices, three per triangle
  std::vector<glm::vec4> rays;    ///< two vectors per ray: origin; unit direction and maximum distance
};

using Random = std::minstd_rand;
float unit(Random& random) {
  return static_cast<float>(random() % 1000003U) / 1000003.0F;
}
glm::vec3 inCube(Random& random) {
  const float x = unit(random) * 2 - 1, y = unit(random) * 2 - 1;
  return {x, y, unit(random) * 2 - 1};
}

void addRays(Soup& soup, Random& random, int count) {
  const std::size_t triangles = soup.places.size() / 3;
  for (int i = 0; i < count; ++i) {
    const std::size_t at = 3 * (static_cast<std::size_t>(i) * 7 / 8 % triangles);
    const glm::vec3 a(soup.places[at]), b(soup.places[at + 1]), c(soup.places[at + 2]);
    const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    glm::vec3 aside = inCube(random);
    while (glm::dot(aside, aside) > 1 || glm::dot(aside, aside) < 1e-4F) aside = inCube(random);
    const glm::vec3 along = glm::normalize(1.001F * normal + glm::normalize(aside));
    soup.rays.emplace_back((a + b + c) / 3.0F + 1e-4F * normal, 0);
    soup.rays.emplace_back(along, 1e9F);
  }
}

Soup sheet(int rays) {
  Soup soup{"waving sheet", {}, {}};
  constexpr int side = 400;
  const auto place = [](int x, int y) {
    const float u = static_cast<float>(x) * 0.01F, v = static_cast<float>(y) * 0.01F;
    return glm::vec4(u, 0.3F * std::sin(5 * u) * std::cos(4 * v + u), v, 1);
  };
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      for (const auto& [i, j] :
           {std::pair(x, y), {x, y + 1}, {x + 1, y}, {x + 1, y}, {x, y + 1}, {x + 1, y + 1}})
        soup.places.push_back(place(i, j));
    }
  Random random(1);
  addRays(soup, random, rays);
  return soup;
}

Soup strewn(int rays) {
  Soup soup{"strewn about", {}, {}};
  Random random(2);
  for (int i = 0; i < 320000; ++i) {
    const glm::vec3 middle = 2.0F * inCube(random);
    for (int k = 0; k < 3; ++k) soup.places.emplace_back(middle + 0.02F * inCube(random), 1);
  }
  addRays(soup, random, rays);
  return soup;
}

double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Runs `f` until a second of processor time has passed and prints rays per second. Returns rays per
/// processor second.
template <class F>
double measure(const char* name, std::size_t rays, const F& f) {
  f();
  int runs = 0;
  const double began = processorSeconds();
  const auto start = std::chrono::steady_clock::now();
  std::chrono::duration<double> wall{};
  do {
    f();
    ++runs;
    wall = std::chrono::steady_clock::now() - start;
  } while (wall.count() < 1);
  const double all = static_cast<double>(rays) * runs;
  const double each = all / (processorSeconds() - began);
  fmt::print("  {:<34} {:>10.3f} {:>10.3f}\n", name, 1e-6 * each, 1e-6 * all / wall.count());
  return each;
}

/// The triangles on the device, with their bounding volume hierarchy.
struct Stage {
  explicit Stage(const Soup& soup) {
    places = gl::Buffer::of<glm::vec4>("places", soup.places);
    std::vector<unsigned> numbers(soup.places.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<unsigned>(i);
    corners = gl::Buffer::of<unsigned>("corners", numbers);
    words = gl::Buffer("words", 16 * soup.places.size());
    const std::array<glm::vec4, 1> look = {glm::vec4(1)};
    materials = gl::Buffer::of<glm::vec4>("looks", look);
    placeView = gl::Texture::view("places", GL_RGBA32F, places);
    cornerView = gl::Texture::view("corners", GL_R32UI, corners, 4);
    wordView = gl::Texture::view("words", GL_RGBA32UI, words);
    lookView = gl::Texture::view("looks", GL_RGBA32F, materials);
    solids = {.count = static_cast<int>(soup.places.size() / 3),
              .places = &placeView,
              .corners = &cornerView,
              .words = &wordView,
              .materials = &lookView};
    build();
    rays = gl::Buffer::of<glm::vec4>("rays", soup.rays);
    rayView = gl::Texture::view("rays", GL_RGBA32F, rays);
    hits = gl::Buffer("hits", 8 * soup.rays.size());
  }
  void build() {
    const std::array<GLuint, 8> none = {~0U, ~0U, ~0U, 0, 0, 0, 0, 0};
    bounds = gl::Buffer::of<GLuint>("bounds", none);
    hierarchy.growBounds(solids, bounds);
    gl::barrier();
    hierarchy.build(solids, bounds);
  }
  void trace(const gl::Program& kernel, int count) {
    hierarchy.bind(kernel);
    bounds.bindStorage(draw::rayBoundsBinding);
    rayView.bind(draw::rayUnit);
    hits.bindStorage(draw::outHitBinding);
    constexpr int atOnce = 1 << 16;
    const int each = gl::softwareDriver() ? atOnce : count;
    for (int first = 0; first < count; first += each) {
      kernel.set("firstRay", first);
      kernel.set("rayCount", std::min(each, count - first));
      draw::dispatchRows(kernel, std::min(each, count - first));
    }
    glFinish();
  }
  draw::Hierarchy hierarchy{draw::Hierarchy::Of::triangles};
  draw::Hierarchy::Solids solids;
  gl::Buffer places, corners, words, materials, bounds, rays, hits;
  gl::Texture placeView, cornerView, wordView, lookView, rayView;
};

#ifdef SIMREEL_BENCH_EMBREE
class Embree {
 public:
  explicit Embree(const Soup& soup) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    const std::size_t count = soup.places.size();
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, count));
    auto* numbers = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, count / 3));
    for (std::size_t i = 0; i < count; ++i) {
      for (int axis = 0; axis < 3; ++axis)
        vertices[3 * i + static_cast<std::size_t>(axis)] = soup.places[i][axis];
      numbers[i] = static_cast<unsigned>(i);
    }
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
  Embree(Embree&&) = delete;
  Embree& operator=(Embree&&) = delete;
  ~Embree() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  [[nodiscard]] float far(glm::vec4 origin, glm::vec4 along) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit ray{};
    ray.ray.org_x = origin.x, ray.ray.org_y = origin.y, ray.ray.org_z = origin.z;
    ray.ray.dir_x = along.x, ray.ray.dir_y = along.y, ray.ray.dir_z = along.z;
    ray.ray.tfar = along.w;
    ray.ray.mask = ~0U;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &ray);
    return ray.ray.tfar;
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};
#endif

void compare(const Soup& soup) {
  const std::size_t count = soup.rays.size() / 2;
  Stage stage(soup);
  const gl::Program kernel = gl::Program::compute("draw/exact/rays/trace.comp", {{"TRIANGLES", "1"}});
  fmt::print("{}, {} triangles, {} rays\n", soup.name, soup.places.size() / 3, count);
  measure("build, triangles", soup.places.size() / 3, [&] {
    stage.build();
    glFinish();
  });
  const double ours = measure("kernel", count, [&] { stage.trace(kernel, static_cast<int>(count)); });
  const auto hits = stage.hits.readAll<glm::uvec4>();
  RayTwin twin;
  const auto sorted = stage.hierarchy.sorted().readAll<glm::uvec4>(),
             nodes = stage.hierarchy.nodes().readAll<glm::uvec4>();
  twin.sorted = std::span(sorted).first(soup.places.size());
  const auto keys = stage.bounds.readAll<GLuint>();
  for (int axis = 0; axis < 3; ++axis) {
    const auto value = [](GLuint key) {
      return std::bit_cast<float>(key ^ ((key >> 31U) != 0 ? 0x80000000U : 0xffffffffU));
    };
    twin.low[axis] = value(keys[static_cast<std::size_t>(axis)]);
    twin.high[axis] = value(keys[static_cast<std::size_t>(axis) + 3]);
  }
  std::size_t wrong = 0, met = 0;
  const std::size_t some = count / 8;
  const double plain = measure("the same as a plain loop", some, [&] {
    wrong = met = 0;
    for (std::size_t i = 0; i < some; ++i) {
      const auto hit = twin.walked(nodes, stage.hierarchy.leaves(), soup.rays[2 * i], soup.rays[2 * i + 1],
                                   soup.rays[2 * i + 1].w);
      wrong += hit.at == static_cast<int>(hits[i].y) && std::bit_cast<GLuint>(hit.t) == hits[i].x ? 0U : 1U;
      met += hit.at >= 0 ? 1U : 0U;
    }
  });
  fmt::print("  {} of {} hit something; {} differ from the plain loop's\n", met, some, wrong);
  fmt::print("  kernel: {:.2f} of the plain loop's rays a processor second\n", ours / plain);
#ifdef SIMREEL_BENCH_EMBREE
  const Embree embree(soup);
  std::size_t unlike = 0;
  const double other = measure("Embree, a ray at a time", count, [&] {
    unlike = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const float t = embree.far(soup.rays[2 * i], soup.rays[2 * i + 1]);
      unlike += std::abs(t - std::bit_cast<float>(hits[i].x)) > 1e-4F * (1 + t) ? 1U : 0U;
    }
  });
  fmt::print("  {} of {} are elsewhere by more than 1e-4\n", unlike, count);
  fmt::print("  kernel: {:.2f} of Embree's rays a processor second\n", ours / other);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  const int rays = argc > 1 ? std::stoi(argv[1]) : 1 << 17;
  const gl::Context context;
  fmt::print("device: {}; millions a processor second, and a second\n", context.device().name);
  compare(sheet(rays));
  compare(strewn(rays));
}
