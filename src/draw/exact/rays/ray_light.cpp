#include "draw/exact/rays/ray_light.hpp"

#include "draw/exact/rays/bindings.hpp"
#include "draw/exact/rays/ray_count.hpp"
#include "draw/exact/reserve.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>

namespace simreel::draw {

namespace {

/// glsl/draw/exact/rays/path_rays.glsl: rays of a path, and what it brings for certain.
constexpr int kinds = 5, sure = 2;
constexpr int onwardRays = 2, nextRays = 3;  // behind two kinds towards lights; two more of those
/// How often a path is mirrored by clear surfaces or goes through them at most.
constexpr int mostClear = 24;

/// Paths that are followed at once: dispatches of software drivers stay short; 740 MB of a card, which 2^18
/// leave idle for a third of the time.
int pathsAtOnce() {
  return gl::softwareDriver() ? 1 << 15 : 1 << 21;
}

}  // namespace

RayLight::RayLight(const Options& options, gl::Defines defines, std::size_t samples, RayLooks looks)
    : options_(options),
      defines_(std::move(defines)),
      scene_(options.ground, std::move(looks)),
      raySamples_(options.raySamples) {
  if (options.openSun) defines_.emplace_back("OPEN_SUN", "1");
  reserve(spots_, spotView_, "places to be lit", 64 * samples, GL_RGBA32UI, 16);
  reserve(spotLight_, spotLightView_, "light of places", 16 * samples, GL_RGBA32F, 16);
  reserve(list_, listView_, "list of places to be lit", 8 * samples, GL_RG32UI, 8);
  count_ = gl::Buffer("places to be lit", 16);
  const auto paths = std::min(static_cast<std::size_t>(pathsAtOnce()),
                              samples * static_cast<std::size_t>(options.raySamples));
  reserve(rays_, rayView_, "rays", kinds * paths * 32, GL_RGBA32F, 16);
  reserve(lightRays_, lightRayView_, "rays that light may take", 2 * paths * sizeof(GLuint), GL_R32UI,
          sizeof(GLuint));
  reserve(hits_, hitView_, "what rays meet", kinds * paths * 16, GL_RGBA32UI, 16);
  reserve(light_, lightView_, "light that rays bring", (kinds + sure) * paths * 16, GL_RGBA32F, 16);
  seeThrough(0, 1);
}

void RayLight::bind() const {
  spots_.bindStorage(outSpotBinding);
}

void RayLight::seeThrough(int point, int points) {
  raySamples_ = std::max(options_.raySamples / points, 1);
  const auto all = static_cast<unsigned>(raySamples_ * points);
  sampleMask_ = std::min(std::bit_ceil(all), 1024U) - 1U;
  samplesBefore_ = static_cast<unsigned>(point * raySamples_);
}

const gl::Program& RayLight::program(const char* path, bool listed) {
  const std::string key = path + std::to_string(scene_.features() << 1U | (listed ? 1U : 0U));
  const auto found = programs_.find(key);
  if (found != programs_.end()) return found->second;
  gl::Defines defines = defines_;
  for (auto& define : scene_.defines()) defines.push_back(std::move(define));
  if (listed) defines.emplace_back("GOES_ON", "1");
  addBallot(defines);
  return programs_.emplace(key, gl::Program::compute(path, defines)).first->second;
}

/// Of what the kernel before has listed.
void RayLight::clearCounts() {
  constexpr GLuint zero = 0;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glClearNamedBufferData(count_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
}

int RayLight::listSpots(const Visibility& visibility, int rows) {
  clearCounts();
  visibility.bind();
  list_.bindStorage(outListBinding);
  count_.bindStorage(outCountBinding);
  spotLight_.bindStorage(outSpotLightBinding);
  const gl::Program& kernel = program("draw/exact/rays/list_spots.comp");
  kernel.set("raySamples", raySamples_);
  kernel.dispatch(visibility.size().x, rows);
  gl::barrier();
  std::array<GLuint, 1> listed{};
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  count_.read(0, std::as_writable_bytes(std::span(listed)));
  return static_cast<int>(listed[0]);
}

const gl::Program& RayLight::prepared(const char* path, bool listed, int firstSpot, int spots,
                                      int firstSample, int paths) {
  const gl::Program& kernel = program(path, listed);
  scene_.bind(kernel);
  spotView_.bind(spotUnit);
  listView_.bind(spotListUnit);
  rayView_.bind(rayUnit);
  hitView_.bind(rayHitUnit);
  lightView_.bind(rayLightUnit);
  rays_.bindStorage(outRayBinding);
  light_.bindStorage(outRayLightBinding);
  lightRays_.bindStorage(outListBinding);
  count_.bindStorage(outCountBinding);
  kernel.set("paths", paths);
  kernel.set("firstSpot", firstSpot);
  kernel.set("spotCount", spots);
  kernel.set("firstRaySample", firstSample);
  kernel.set("sampleMask", sampleMask_);
  kernel.set("samplesBefore", samplesBefore_);
  return kernel;
}

/// The ways onwards of paths that meet clear surfaces, until they meet something else. In which order paths
/// are listed the device chooses; none knows of the others.
void RayLight::goOn(int firstSpot, int spots, int firstSample, int paths) {
  int going = paths;
  for (int round = 0; round < mostClear && going > 0; ++round) {
    const auto now = static_cast<std::size_t>(round % 2);
    reserve(goingOn_[now], goingOnView_[now], "paths that go on",
            static_cast<std::size_t>(pathsAtOnce()) * sizeof(GLuint), GL_R32UI, sizeof(GLuint));
    clearCounts();
    const gl::Program& kernel =
        prepared("draw/exact/rays/go_on.comp", round > 0, firstSpot, spots, firstSample, paths);
    if (round > 0) goingOnView_[1 - now].bind(rayListUnit);
    goingOn_[now].bindStorage(outListBinding);
    count_.bindStorage(outCountBinding);
    kernel.set("going", going);
    kernel.set("round_", round);
    dispatchRows(kernel, going);
    gl::barrier();
    std::array<GLuint, 1> listed{};
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    count_.read(0, std::as_writable_bytes(std::span(listed)));
    going = static_cast<int>(listed[0]);
    if (going == 0) break;
    scene_.traceListed(rayView_, hits_, onwardRays * paths, goingOnView_[now], going);
    gl::barrier();
  }
}

/// Rays of two kinds that the kernel before has listed.
void RayLight::traceLight(int firstKind, int paths) {
  if (RayCount* counted = RayCount::current()) counted->add(rayView_, firstKind * paths, 2 * paths);
  scene_.traceLight(rayView_, hits_, lightRayView_, count_, paths);
}

void RayLight::follow(int firstSpot, int spots, int firstSample, int samples, float white) {
  const int paths = spots * samples;
  const auto run = [&](const char* path) {
    clearCounts();
    dispatchRows(prepared(path, false, firstSpot, spots, firstSample, paths), paths);
    gl::barrier();
  };
  run("draw/exact/rays/start.comp");
  traceLight(0, paths);
  scene_.trace(rayView_, hits_, onwardRays * paths, paths);
  gl::barrier();
  if (looks().anyGlass()) goOn(firstSpot, spots, firstSample, paths);
  run("draw/exact/rays/bounce.comp");
  traceLight(nextRays, paths);
  gl::barrier();
  const gl::Program& kernel = program("draw/exact/rays/sum.comp");
  listView_.bind(spotListUnit);
  hitView_.bind(rayHitUnit);
  lightView_.bind(rayLightUnit);
  spotLight_.bindStorage(outSpotLightBinding);
  kernel.set("paths", paths);
  kernel.set("firstSpot", firstSpot);
  kernel.set("spotCount", spots);
  kernel.set("sampleCount", samples);
  kernel.set("most", mostOnward * white);
  dispatchRows(kernel, spots);
  gl::barrier();
  if (gl::softwareDriver()) glFinish();
}

void RayLight::add(const Visibility& visibility, const gl::Texture& sums, int rows, float white) {
  gl::barrier();
  const int spots = listSpots(visibility, rows);
  const int most = pathsAtOnce();
  for (int first = 0; first < spots; first += most) {
    const int count = std::min(most, spots - first);
    const int together = std::clamp(most / count, 1, raySamples_);
    for (int sample = 0; sample < raySamples_; sample += together)
      follow(first, count, sample, std::min(together, raySamples_ - sample), white);
  }
  visibility.bind();
  spotView_.bind(spotUnit);
  spotLightView_.bind(spotLightUnit);
  sums.bindImage(sumImage, GL_READ_WRITE);
  const gl::Program& kernel = program("draw/exact/rays/resolve.comp");
  kernel.set("raySamples", raySamples_);
  kernel.dispatch(visibility.size().x, rows);
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

}  // namespace simreel::draw
