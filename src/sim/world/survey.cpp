#include "sim/world/survey.hpp"

#include "base/clock.hpp"
#include "base/log.hpp"
#include "scene/haze_reach.hpp"
#include "scene/outline.hpp"
#include "scene/stage.hpp"
#include "scene/value/value_writer.hpp"
#include "sim/cloth/parameters.hpp"
#include "sim/core/kind.hpp"
#include "sim/particles/parameters.hpp"
#include "sim/world/setup.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>

namespace simreel::sim {

namespace {

constexpr int maxLooks = 48;
constexpr std::size_t maxPoints = 1 << 17;  // maximum number of points per object, summed over all sampled
                                            // frames
constexpr double strayParticles = 0.01;     // fraction that is ignored in each sampled frame and direction
constexpr double farParticles = 0.1;        // fraction of all samples up to which particles far from their
                                            // start belong to the swarm

const ParticleParameters* particlesOf(const scene::Object& object) {
  return dynamic_cast<const ParticleParameters*>(object.parameters.get());
}

bool goesItsWay(const scene::Object& object) {
  const auto* parameters = dynamic_cast<const ObjectParameters*>(object.parameters.get());
  return parameters != nullptr && parameters->motionIsUnpredictable();
}

/// Scope guard: computes the scene in exact mode and suppresses output, because the actual run repeats the
/// same messages.
class Quietly {
 public:
  explicit Quietly(scene::Scene& scene)
      : scene_(scene), numerics_(scene.numerics), verbosity_(verbosity()) {
    scene.numerics = scene::Numerics::exact;
    setVerbosity(Verbosity::quiet);
  }
  ~Quietly() {
    scene_.numerics = numerics_;
    setVerbosity(verbosity_);
  }
  Quietly(const Quietly&) = delete;
  Quietly& operator=(const Quietly&) = delete;

 private:
  scene::Scene& scene_;
  scene::Numerics numerics_;
  Verbosity verbosity_;
};

/// Returns the measured cost of a byte of state per step, relative to a cloth of springs.
double weightOf(const scene::Object& object) {
  constexpr double tree = 40, contact = 8, ofMesh = 5, ofUser = 2;
  if (object.kind == "kernels") return ofUser;
  if (const ParticleParameters* particles = particlesOf(object))
    return particles->method == GravityMethod::tree ? tree : 1;
  const auto* cloth = dynamic_cast<const ClothParameters*>(object.parameters.get());
  if (cloth == nullptr) return 1;
  return cloth->contact ? contact : cloth->mesh ? ofMesh : 1;
}

/// Returns an estimate of the cost of simulating the scene: the bytes of state times the number of steps,
/// weighted by weightOf() and summed over all objects. If all n bodies of an object attract each other, n *
/// n / 10 bytes are added.
double countedWork(const scene::Scene& scene, const World& world) {
  double work = 0;
  for (std::size_t i = 0; i < world.objectCount(); ++i) {
    double bytes = 0;
    double elements = 0;
    for (const StateArray& array : world.object(i).state()) {
      bytes += 16.0 * static_cast<double>(array.elements());
      elements = std::max(elements, static_cast<double>(array.elements()));
    }
    bytes *= weightOf(scene.objects[i]);
    const ParticleParameters* particles = particlesOf(scene.objects[i]);
    if (particles != nullptr && particles->method == GravityMethod::allPairs && particles->gravity > 0)
      bytes += 0.1 * elements * elements;
    work += bytes * world.object(i).stepsPerFrame();
  }
  return work * static_cast<double>(scene.frameCount() - 1 - world.firstFrame());
}

/// Returns the finite positions of an object's points or mesh vertices in metres. w: mass of a point, 0 if
/// it has none.
std::vector<glm::vec4> placesOf(const Simulation& object) {
  std::vector<glm::vec4> places;
  const auto add = [&](const glm::vec3& at, float mass) {
    if (std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z)) places.emplace_back(at, mass);
  };
  const PointTable table = object.points();
  const std::size_t columns = table.columns.size();
  const bool weighs = columns > 3 && std::string_view(table.columns[3]) == "mass";
  for (std::size_t i = 0; columns >= 3 && i + columns <= table.values.size(); i += columns)
    add({table.values[i], table.values[i + 1], table.values[i + 2]}, weighs ? table.values[i + 3] : 0.0F);
  if (columns >= 3) return places;
  if (const auto surface = object.mesh())
    for (const glm::vec3& at : surface->positions) add(at, 0);
  return places;
}

/// Returns the outermost points of an object's positions. Particles whose size grows with mass are balls of
/// the sizes that are drawn.
std::vector<glm::vec3> outermostOf(const std::vector<glm::vec4>& places,
                                   const ParticleParameters* particles,
                                   const std::optional<ShownRadius>& shown) {
  const double stray = particles == nullptr ? 0 : strayParticles;
  if (shown) {
    std::vector<glm::vec4> balls;
    balls.reserve(places.size());
    for (const glm::vec4& at : places) balls.emplace_back(glm::vec3(at), shown->of(at.w));
    return scene::outermostOfBalls(balls, stray);
  }
  const std::vector<glm::vec3> points(places.begin(), places.end());
  return scene::outermost(points, stray, particles == nullptr ? 0 : 0.5F * particles->size);
}

/// Returns the frames to sample, which span the frames from 0 to the last.
std::vector<int> framesToSee(const scene::Scene& scene) {
  const int last = scene.frameCount() - 1;
  const int looks = std::min(last, maxLooks - 1);
  std::vector<int> frames = {0};
  for (int i = 1; i <= looks; ++i) frames.push_back(static_cast<int>(std::int64_t{last} * i / looks));
  return frames;
}

std::vector<int> allFrames(const scene::Scene& scene) {
  std::vector<int> frames(static_cast<std::size_t>(scene.frameCount()));
  std::iota(frames.begin(), frames.end(), 0);
  return frames;
}

bool isWithin(const scene::Box& room, const glm::vec3& at) {
  return glm::max(at, room.min) == at && glm::min(at, room.max) == at;
}

/// Object whose motion is sampled.
struct SampledObject {
  std::size_t object = 0;
  std::size_t place = 0;                  ///< index of the object in Survey::framed
  scene::Box near;                        ///< region outside of which points are far
  scene::Box wide;                        ///< region outside of which points are ignored
  std::vector<glm::vec3> seen = {};       ///< outermost points in `near` of all sampled frames
  std::vector<glm::vec3> seenWide = {};   ///< outermost points in `wide`
  std::optional<ShownRadius> shown = {};  ///< set for particles whose size grows with mass
  std::size_t samples = 0, far = 0;       ///< number of points in `wide`; number of them outside `near`
};

/// Returns the box enlarged on each side by `times` its size.
scene::Box roomAround(const scene::Box& box, float times) {
  const glm::vec3 extent = box.max - box.min;
  const float size = times * std::max({extent.x, extent.y, extent.z});
  return {box.min - size, box.max + size};
}

/// Returns true if the scene has its own ground and leaves the ground's height to the stage.
bool standsOnOwnGround(const scene::Scene& scene) {
  return scene.staged && scene.ground && scene.ground->solid && scene.ground->visible &&
         scene.stage.leaves("ground.height");
}

/// Samples an object's current positions: the outermost points. Of particles, takes an evenly spaced subset
/// and leaves out strays and particles that the ground hides.
void look(const World& world, const scene::Scene& scene, std::size_t looks, SampledObject& traveller) {
  std::vector<glm::vec4> places = placesOf(world.object(traveller.object));
  const ParticleParameters* particles = particlesOf(scene.objects[traveller.object]);
  const bool hides = particles != nullptr && !particles->collides && standsOnOwnGround(scene);
  std::erase_if(places, [&](const glm::vec4& at) {
    return !isWithin(traveller.wide, glm::vec3(at)) || (hides && at.y < scene.ground->height);
  });
  if (particles != nullptr) {
    const std::size_t stride = 1 + places.size() * looks / maxPoints;
    for (std::size_t i = 0; i * stride < places.size(); ++i) places[i] = places[i * stride];
    places.resize((places.size() + stride - 1) / stride);
  }
  std::vector<glm::vec4> near = places;
  std::erase_if(near, [&](const glm::vec4& at) { return !isWithin(traveller.near, glm::vec3(at)); });
  traveller.samples += places.size();
  traveller.far += places.size() - near.size();
  for (const glm::vec3& at : outermostOf(near, particles, traveller.shown)) traveller.seen.push_back(at);
  if (near.size() < places.size()) near = std::move(places);
  for (const glm::vec3& at : outermostOf(near, particles, traveller.shown))
    traveller.seenWide.push_back(at);
}

/// Replaces an object's extent by the extent of the sampled points. Keeps the extent given by the
/// parameters if no sampled point was inside the region.
void updateExtent(const SampledObject& traveller, scene::Framed& framed) {
  const bool wide =
      static_cast<double>(traveller.far) <= farParticles * static_cast<double>(traveller.samples);
  const std::vector<glm::vec3>& seen = wide ? traveller.seenWide : traveller.seen;
  if (seen.empty()) return;
  framed.points = scene::outermost(seen);
  std::optional<scene::Box> box;
  for (const glm::vec3& point : framed.points) scene::include(box, point);
  framed.box = *box;
}

}  // namespace

std::vector<std::string> cameraOverrides(const scene::Camera& camera, const scene::Camera& before) {
  const auto value = [](float number) { return scene::shortest(number).dump(); };
  const auto vector = [&](const glm::vec3& v) {
    return fmt::format("[{},{},{}]", value(v.x), value(v.y), value(v.z));
  };
  std::vector<std::string> given;
  if (camera.orbit)
    given.push_back("camera.orbit.distance=" + value(camera.orbit->distance.at(0)));
  else
    given.push_back("camera.position=" + vector(camera.position.at(0)));
  if (!camera.track) given.push_back("camera.target=" + vector(camera.target.at(0)));
  if (camera.projection == scene::Projection::orthographic)
    given.push_back("camera.height=" + value(camera.height.at(0)));
  else if (!camera.fieldOfView.moves())
    given.push_back("camera.fieldOfView=" + value(camera.fieldOfView.at(0)));
  if (camera.near != before.near) given.push_back("camera.near=" + value(camera.near));
  if (camera.far != before.far) given.push_back("camera.far=" + value(camera.far));
  return given;
}

bool needsSurvey(const scene::Scene& scene) {
  return !scene.surveyed && (!scene.camera.placed || scene.staged) &&
         std::any_of(scene.objects.begin(), scene.objects.end(), goesItsWay);
}

Survey surveyMotion(scene::Scene& scene, const SurveyWatch& watch, double maximum) {
  Survey survey;
  std::vector<SampledObject> travellers;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    std::optional<scene::Framed> one = scene::framedOf(scene.objects[i], scene.objects);
    if (!one) continue;
    if (goesItsWay(scene.objects[i])) {
      // Pieces of cloth that leave their place fall for ever, so only particles count far from their start.
      const ParticleParameters* particles = particlesOf(scene.objects[i]);
      const float far = particles != nullptr ? 2 : 1;
      travellers.push_back({i, survey.framed.size(), roomAround(one->box, 1), roomAround(one->box, far)});
      if (particles != nullptr && particles->massExponent > 0)
        travellers.back().shown = particles->shownRadius();
    }
    survey.framed.push_back(std::move(*one));
  }
  survey.ranges = rangesToSee(scene);
  const bool measures = !survey.ranges.empty();
  if (measures && !needsSurvey(scene)) travellers.clear();
  if (travellers.empty() && !measures) return survey;
  const Quietly quietly(scene);
  World world(scene);
  survey.work = countedWork(scene, world);
  if (survey.work > maximum) travellers.clear();
  if (travellers.empty() && !measures) return survey;
  const std::vector<int> looks = framesToSee(scene);
  for (const int frame : measures ? allFrames(scene) : looks) {
    while (world.frame() < frame - 1) {
      if (watch) watch();
      world.advanceUndrawn(world.frame() + 1);
    }
    world.advanceTo(frame);
    seeValues(world, survey.ranges);
    if (std::binary_search(looks.begin(), looks.end(), frame))
      for (SampledObject& one : travellers) look(world, scene, looks.size(), one);
    if (watch) watch();
  }
  if (travellers.empty()) return survey;
  for (const SampledObject& one : travellers) updateExtent(one, survey.framed[one.place]);
  survey.frames = looks.back() + 1 - world.firstFrame();
  return survey;
}

bool coversRanges(const Survey& survey, scene::Scene& scene) {
  const std::vector<SeenRange> wanted = rangesToSee(scene);
  return std::equal(
      wanted.begin(), wanted.end(), survey.ranges.begin(), survey.ranges.end(),
      [](const SeenRange& a, const SeenRange& b) { return a.object == b.object && a.range == b.range; });
}

void frameSurvey(scene::Scene& scene, const Survey& survey) {
  static_cast<void>(setRanges(scene, survey.ranges));
  if (survey.frames == 0 || survey.framed.empty()) return;
  if (scene.staged) scene::moveStage(scene, survey.framed);
  scene::frameObjects(scene, survey.framed);
  scene::openFloor(scene);
  scene::extendGroundIntoHaze(scene);
  scene.camera.placed = true;
  scene.surveyed = true;
}

namespace {

/// Places the camera and the stage according to the survey, and writes the overrides and the remark.
void placeByMotion(scene::Scene& scene, const Survey& survey, Clock::time_point began,
                   MotionFraming& framing) {
  if (survey.framed.empty()) return;
  const scene::Camera before = scene.camera;
  const bool placed = before.placed;
  if (survey.frames == 0) {
    scene.camera.placed = true;
    scene.surveyed = true;
    framing.remark = placed ? "simreel: the stage is placed by the initial positions of the objects, not "
                              "by their motion: a first run to measure the motion would take too long"
                            : "simreel: the camera is placed by the initial positions of the objects, not "
                              "by their motion: a first run to measure the motion would take too long; "
                              "give \"camera\" a \"position\" and a \"target\"";
    return;
  }
  frameSurvey(scene, survey);
  detail("simreel: the first run stepped through {:.1f} MiB of state in {:.2f} s", survey.work / (1 << 20),
         secondsSince(began));
  if (placed) return;
  framing.camera = cameraOverrides(scene.camera, before);
  framing.remark = fmt::format("simreel: a first run of {} frames placed the camera; to keep it there: {}",
                               survey.frames, scene::asArguments(framing.camera));
}

}  // namespace

MotionFraming frameMotion(scene::Scene& scene, const SurveyWatch& watch) {
  const bool moves = needsSurvey(scene);
  if (!moves && !needsRanges(scene)) return {};
  const auto began = Clock::now();
  const Survey survey = surveyMotion(scene, watch);
  MotionFraming framing;
  framing.ranges = setRanges(scene, survey.ranges);
  if (!framing.ranges.empty())
    framing.rangeRemark =
        fmt::format("simreel: a first run of {} frames measured the ranges of colours; to keep them: {}",
                    scene.frameCount(), scene::asArguments(framing.ranges));
  if (moves) placeByMotion(scene, survey, began, framing);
  return framing;
}

}  // namespace simreel::sim
