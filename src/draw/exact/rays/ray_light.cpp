#include "draw/exact/rays/ray_light.hpp"

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

/// Uniforms, buffers and textures that spot_read.glsl and path_rays.glsl declare.
struct RayPaths {
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Ambient<"ViewBlock"> view = {};
  gl::In<"spots"> spots;
  gl::In<"spotList"> spotList;
  gl::Uniform<"firstSpot", int> firstSpot;
  gl::Uniform<"spotCount", int> spotCount;
  gl::Uniform<"firstRaySample", int> firstRaySample;
  gl::Uniform<"sampleMask", unsigned> sampleMask;
  gl::Uniform<"samplesBefore", unsigned> samplesBefore;
  gl::InOut<"RayBlock"> rays;
  gl::InOut<"RayLightBlock"> light;
  gl::InOut<"RayListBlock"> listed;
  gl::InOut<"RayListCountBlock"> counters;
  gl::Uniform<"paths", int> paths;
};
struct PathVariant {
  gl::Choice<"SAMPLES", 1, 2, 4, 8, 16> samples;
  gl::Flag<"PARALLEL"> parallel;
  gl::Flag<"FAST_NUMERICS"> fast;
  ListVariant list;
  gl::Flag<"LAID"> laid;
  gl::Flag<"FINISHED"> finished;
  gl::Flag<"EMITTERS"> emitters;
  gl::Range<"HAZE", 1, 2> haze;
};
/// Shader inputs of kernels that compute the light of paths, with the lamps and the environment.
struct PathLight {
  gl::Ambient<"environment"> environment;
  gl::Ambient<"LampBlock"> lampBlock;
  gl::Ambient<"lampMembers"> lamps;
  gl::Ambient<"lampCells"> lampCells;
};

struct ListSpots {
  static constexpr auto file = "draw/exact/rays/list_spots.comp";
  using Variant = SampleVariant;
  gl::Ambient<"ViewBlock"> view = {};
  SamplesRead samples;
  gl::Out<"ListBlock"> list;
  gl::InOut<"CountBlock"> count;
  gl::Out<"SpotLightBlock"> spotLight;
  gl::Uniform<"raySamples", int> raySamples;
};

struct StartPaths {
  static constexpr auto file = "draw/exact/rays/start.comp";
  struct Variant {
    PathVariant path;
    gl::Flag<"OPEN_SUN"> openSun;
  };
  RayPaths paths;
  PathLight light;
  RayLookFields materials;
  EmitterFields emitters;
};

struct GoOnPaths {
  static constexpr auto file = "draw/exact/rays/go_on.comp";
  struct Variant {
    PathVariant path;
    gl::Flag<"TRIANGLES"> triangles;
    gl::Flag<"BALLS"> balls;
    gl::Flag<"SKINS"> skins;
    gl::Flag<"RAISED"> raised;
    gl::Flag<"GOES_ON"> goesOn;
  };
  RayPaths paths;
  RayLookFields materials;
  SortedSolids solids;
  FoundFields found;
  gl::In<"rayHits"> hits;
  gl::In<"goingOn"> goingOn;
  gl::Out<"NextBlock"> next;
  gl::InOut<"CountBlock"> count;
  gl::Uniform<"going", int> going;
  gl::Uniform<"round_", int> round;
};

struct BouncePaths {
  static constexpr auto file = "draw/exact/rays/bounce.comp";
  struct Variant {
    PathVariant path;
    gl::Flag<"OPEN_SUN"> openSun;
    gl::Flag<"TRIANGLES"> triangles;
    gl::Flag<"BALLS"> balls;
    gl::Flag<"GROUND"> ground;
    gl::Flag<"SKINS"> skins;
    gl::Flag<"RAISED"> raised;
  };
  RayPaths paths;
  PathLight light;
  RayLookFields materials;
  SortedSolids solids;
  FoundFields found;
  EmitterFields emitters;
  gl::In<"rays"> rays;
  gl::In<"rayHits"> hits;
  gl::In<"onwardLight"> onwardLight;
};

struct SumPaths {
  static constexpr auto file = "draw/exact/rays/sum.comp";
  struct Variant {
    gl::Flag<"FAST_NUMERICS"> fast;
    gl::Flag<"PASSAGES"> passages;
  };
  gl::In<"spotList"> spotList;
  gl::In<"light"> light;
  gl::In<"rayHits"> hits;
  gl::InOut<"SpotLightBlock"> spotLight;
  gl::Uniform<"paths", int> paths;
  gl::Uniform<"firstSpot", int> firstSpot;
  gl::Uniform<"spotCount", int> spotCount;
  gl::Uniform<"sampleCount", int> sampleCount;
  gl::Uniform<"maximum", float> maximum;
};

struct ResolveSpots {
  static constexpr auto file = "draw/exact/rays/resolve.comp";
  struct Variant {
    SampleVariant samples;
    gl::Flag<"FAST_NUMERICS"> fast;
    gl::Flag<"PARALLEL"> parallel;
    gl::Flag<"HAZE"> haze;
  };
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Ambient<"ViewBlock"> view = {};
  SamplesRead samples;
  gl::In<"spots"> spots;
  gl::In<"spotLight"> spotLight;
  gl::InOut<"sums"> sums;
  gl::Uniform<"raySamples", int> raySamples;
  gl::Uniform<"linear", int> linear;
};

namespace {

/// Constants of glsl/draw/exact/rays/path_rays.glsl. kinds: number of ray kinds per path. sure: number of
/// light entries that need no ray.
constexpr int kinds = 5, sure = 2;
constexpr int onwardRays = 2, nextRays = 3;  // onwardRays: kind of the ray that continues the path.
                                             // nextRays: first of the two kinds of rays that start where
                                             // that ray hits. Kinds 0 and 1 are the shadow rays that start
                                             // at the spot.
/// Max number of successive reflections and refractions at clear surfaces per path.
constexpr int maxClear = 24;

/// Returns the number of paths that are traced together. On software drivers the number is small, so that
/// dispatches are short. On GPUs the paths take 740 MB. With only 2^18 paths, a large GPU would be idle for
/// a third of the time.
int pathsAtOnce() {
  return gl::softwareDriver() ? 1 << 15 : 1 << 21;
}

}  // namespace

RayLight::RayLight(const Options& options, const Lighting& lighting, std::size_t samples,
                   RayMaterials materials)
    : options_(options),
      shade_(lighting.variant.shade),
      start_(lighting.lights),
      bounce_(lighting.lights),
      scene_(options.ground, std::move(materials)),
      raySamples_(options.raySamples) {
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
  selectLensPoint(0, 1);
}

void RayLight::selectLensPoint(int point, int points) {
  raySamples_ = std::max(options_.raySamples / points, 1);
  const auto all = static_cast<unsigned>(raySamples_ * points);
  sampleMask_ = std::min(std::bit_ceil(all), 1024U) - 1U;
  samplesBefore_ = static_cast<unsigned>(point * raySamples_);
}

/// Clears the counter that kernels use to append to lists.
void RayLight::clearCounts() {
  constexpr GLuint zero = 0;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glClearNamedBufferData(count_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
}

int RayLight::listSpots(const Visibility& visibility, int rows) {
  clearCounts();
  listSpots_.of(visibility.variant())
      .dispatch({visibility.size().x, rows}, {.samples = visibility.read(),
                                              .list = list_,
                                              .count = count_,
                                              .spotLight = spotLight_,
                                              .raySamples = raySamples_});
  return counted();
}

/// Returns the length of the list that the last kernel wrote. Waits for the GPU.
int RayLight::counted() const {
  std::array<GLuint, 1> listed{};
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  count_.read(0, std::as_writable_bytes(std::span(listed)));
  return static_cast<int>(listed[0]);
}

PathVariant RayLight::pathVariant(const RayFeatures& all) const {
  return {.samples = shade_.samples.samples,
          .parallel = shade_.parallel,
          .fast = shade_.fast,
          .list = listVariant(),
          .laid = all.laid,
          .finished = all.finished,
          .emitters = all.emitters,
          .haze = shade_.haze};
}

RayPaths RayLight::pathsOf(int firstSpot, int spots, int firstSample, int paths) const {
  return {.spots = spotView_,
          .spotList = listView_,
          .firstSpot = firstSpot,
          .spotCount = spots,
          .firstRaySample = firstSample,
          .sampleMask = sampleMask_,
          .samplesBefore = samplesBefore_,
          .rays = rays_,
          .light = light_,
          .listed = lightRays_,
          .counters = count_,
          .paths = paths};
}

/// Continues paths at clear surfaces until they hit another kind of surface. The order of the list depends
/// on the device, but the result does not, because paths are independent.
void RayLight::continuePaths(int firstSpot, int spots, int firstSample, int paths) {
  int going = paths;
  for (int round = 0; round < maxClear && going > 0; ++round) {
    const auto now = static_cast<std::size_t>(round % 2);
    reserve(goingOn_[now], goingOnView_[now], "paths that go on",
            static_cast<std::size_t>(pathsAtOnce()) * sizeof(GLuint), GL_R32UI, sizeof(GLuint));
    clearCounts();
    const RayFeatures all = scene_.features();
    goOn_
        .of({.path = pathVariant(all),
             .triangles = all.triangles,
             .balls = all.balls,
             .skins = all.skins,
             .raised = all.raised,
             .goesOn = round > 0})
        .dispatch(inRows(going), {.paths = pathsOf(firstSpot, spots, firstSample, paths),
                                  .materials = scene_.lookFields(),
                                  .solids = scene_.sorted(),
                                  .found = scene_.found(),
                                  .hits = hitView_,
                                  .goingOn = goingOnView_[1 - now],
                                  .next = goingOn_[now],
                                  .count = count_,
                                  .going = going,
                                  .round = round});
    going = counted();
    if (going == 0) break;
    scene_.traceListed(rayView_, hits_, onwardRays * paths, goingOnView_[now], going);
  }
}

/// Traces the shadow rays in the lists that the last kernel wrote.
void RayLight::traceLight(int firstKind, int paths) {
  if (RayCount* counted = RayCount::current()) counted->add(rayView_, firstKind * paths, 2 * paths);
  scene_.traceLight(rayView_, hits_, lightRayView_, count_, paths);
}

void RayLight::follow(int firstSpot, int spots, int firstSample, int samples, float white) {
  const int paths = spots * samples;
  const RayFeatures all = scene_.features();
  const RayPaths here = pathsOf(firstSpot, spots, firstSample, paths);
  clearCounts();
  start_.of({.path = pathVariant(all), .openSun = options_.openSun})
      .dispatch(
          inRows(paths),
          {.paths = here, .light = {}, .materials = scene_.lookFields(), .emitters = scene_.emitters()});
  traceLight(0, paths);
  scene_.trace(rayView_, hits_, onwardRays * paths, paths);
  if (materials().anyGlass()) continuePaths(firstSpot, spots, firstSample, paths);
  clearCounts();
  bounce_
      .of({.path = pathVariant(all),
           .openSun = options_.openSun,
           .triangles = all.triangles,
           .balls = all.balls,
           .ground = all.ground,
           .skins = all.skins,
           .raised = all.raised})
      .dispatch(inRows(paths), {.paths = here,
                                .light = {},
                                .materials = scene_.lookFields(),
                                .solids = scene_.sorted(),
                                .found = scene_.found(),
                                .emitters = scene_.emitters(),
                                .rays = rayView_,
                                .hits = hitView_,
                                .onwardLight = lightView_});
  traceLight(nextRays, paths);
  sum_.of({.fast = shade_.fast, .passages = all.passages})
      .dispatch(inRows(spots), {.spotList = listView_,
                                .light = lightView_,
                                .hits = hitView_,
                                .spotLight = spotLight_,
                                .paths = paths,
                                .firstSpot = firstSpot,
                                .spotCount = spots,
                                .sampleCount = samples,
                                .maximum = maxIndirect * white});
  if (gl::softwareDriver()) glFinish();
}

void RayLight::add(const Visibility& visibility, const gl::Texture& sums, bool linear, int rows,
                   float white) {
  gl::barrier();
  const int spots = listSpots(visibility, rows);
  const int maximum = pathsAtOnce();
  for (int first = 0; first < spots; first += maximum) {
    const int count = std::min(maximum, spots - first);
    const int together = std::clamp(maximum / count, 1, raySamples_);
    for (int sample = 0; sample < raySamples_; sample += together)
      follow(first, count, sample, std::min(together, raySamples_ - sample), white);
  }
  resolve_
      .of({.samples = visibility.variant(),
           .fast = shade_.fast,
           .parallel = shade_.parallel,
           .haze = shade_.haze.defined})
      .dispatch({visibility.size().x, rows}, {.samples = visibility.read(),
                                              .spots = spotView_,
                                              .spotLight = spotLightView_,
                                              .sums = sums,
                                              .raySamples = raySamples_,
                                              .linear = linear ? 1 : 0});
  gl::barrier();
}

}  // namespace simreel::draw
