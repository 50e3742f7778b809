#include "reference/particles_twin.hpp"

#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace {

using namespace simreel::shader;

#define FUNCTION inline
#define precise
#include "glsl/particles/pace.glsl"
#include "glsl/particles/pairs.glsl"
#define ROLLS  // BallConstants::rolls selects
/// Provides the globals that model.glsl reads in a kernel, and includes the model files.
struct Kernel : WindKernel {
  const ParticleStep& stepData;
  MeshColliders meshData{};
  const uvec4* fieldCells = nullptr;
  HeightGrid heightGrid{};
  const vec4* heights = nullptr;
  WallGrid wallGrid{};
  const WallsTwin* walls = nullptr;
  [[nodiscard]] vec4 loadHeights(int i) const { return heights[i]; }
  [[nodiscard]] uvec4 loadFieldCell(int i) const { return fieldCells[i]; }
  [[nodiscard]] int loadWallClass(int x, int y) const { return walls->classAt(x, y); }
  [[nodiscard]] float loadWallValue(int x, int y) const { return walls->valueAt(x, y); }
#include "glsl/contour/model.glsl"
// BRANCHES selects the variant for graphics cards. The twin of cloth uses the variant for software drivers.
#define BRANCHES
#include "glsl/contour/wall_model.glsl"
#undef BRANCHES
#include "glsl/fluid/wind_model.glsl"
#include "glsl/mesh/height_model.glsl"
#include "glsl/particles/contact/impact.glsl"
#include "glsl/particles/contact/leave.glsl"
#include "glsl/particles/contact/model.glsl"
#include "glsl/particles/contact/push.glsl"
#include "glsl/particles/contact/scale.glsl"
#include "glsl/particles/model.glsl"
};
#undef ROLLS
#undef precise
#undef FUNCTION

template <class Body>
void forAll(std::size_t count, int threads, const Body& body) {
  if (threads == 1) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : threads);
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
                      });
  });
}

}  // namespace

glm::vec3 pairAcceleration(const std::vector<glm::vec4>& bodies, glm::vec3 here, float gravity,
                           float softening) {
  vec3 total(0);
  for (std::size_t chunk = 0; chunk < bodies.size(); chunk += chunkBodies) {
    vec3 sum(0);
    for (std::size_t j = chunk; j < std::min(bodies.size(), chunk + chunkBodies); ++j)
      sum = addPull(sum, here, bodies[j], softening * softening);
    total = total + sum;
  }
  return total * gravity;
}

glm::vec3 curlNoiseAt(glm::vec3 p, int seed) {
  ParticleStep data{};
  data.seed = seed;
  return Kernel{{}, data}.curlNoise(p);
}

ParticlesTwin::ParticlesTwin(simreel::sim::ParticlePlan plan) : plan_(std::move(plan)) {
  auto cloud = plan_.firstCloud();
  positions = std::move(cloud.positions);
  velocities = std::move(cloud.velocities);
  accelerations.assign(positions.size(), vec4(0));
  spins.assign(positions.size(), vec4(0));
  turns.assign(positions.size(), vec4(0, 0, 0, 1));
}

void ParticlesTwin::step(double time, int threads) {
  beginFrame(time, threads);
  for (int i = 0; i < plan_.parameters().substeps; ++i) predict(i, threads);
}

void ParticlesTwin::beginFrame(double time, int threads) {
  if (!primed_) {
    attract(threads);
    kick(plan_.prime(time), threads);
    primed_ = true;
  }
  const auto& p = plan_.parameters();
  if (meshes) meshes->beginFrame(time, p.substeps, plan_.substepSeconds());
  steps_ = plan_.frame(time);
}

void ParticlesTwin::meet(int index, const std::function<void(const Meet&)>& body) {
  const auto& p = plan_.parameters();
  const ParticleStep& data = steps_[static_cast<std::size_t>(index)];
  Kernel kernel{{}, data};
  if (meshes) {
    kernel.meshData = meshes->steps[static_cast<std::size_t>(index)];
    kernel.fieldCells = meshes->cells.data();
  }
  if (heightPlan) kernel.heightGrid = heightPlan->at(index, p.substeps, p.margin, p.bounce);
  kernel.heights = heights.data();
  if (walls) {
    kernel.wallGrid = walls->grid({p.margin, p.bounce, plan_.substepSeconds()});
    kernel.walls = &*walls;
  }
  body([&](std::size_t i, const vec4& position, const vec4& velocity, const vec4* start,
           const Rolling& rolling) {
    Kernel::ParticleMotion m = kernel.particleMotion(position, velocity);
    m.spin = rolling.spin;
    m.roll = rolling.roll;
    if (data.colliderCount > 0 || meshes)
      m = kernel.outOfSolids(m, vec3(start != nullptr ? *start : position));
    if (heightPlan) m = kernel.overHeights(m);
    if (walls) m = kernel.besideWalls(m, vec3(start != nullptr ? *start : m.position));
    positions[i] = m.position;
    velocities[i] = m.velocity;
    return Rolling{m.spin, m.roll};
  });
}

/// Balls of a substep in the order of their buckets.
struct ParticlesTwin::Balls {
  std::vector<uint> slots;
  std::vector<vec4> guesses, begins, speeds, places;
  std::vector<vec3> spins, rolls;  ///< angular velocities (m/s) and angles of the substep (m), times radii
  std::vector<std::vector<int>> lists;
  [[nodiscard]] float perMass(std::size_t s) const { return exactReciprocal(max(guesses[s].w, 1e-30F)); }
};

namespace {

using Balls = ParticlesTwin::Balls;

Balls sortedBalls(Kernel& kernel, const std::vector<vec4>& positions, const std::vector<vec4>& starts,
                  const std::vector<vec4>& velocities, const std::vector<vec4>& spins) {
  Balls balls;
  std::vector<uint> buckets(positions.size());
  const auto dead = static_cast<uint>(kernel.stepData.balls.tableMask);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    balls.slots.push_back(static_cast<uint>(i));
    buckets[i] = velocities[i].w < 0 ? dead : kernel.ballBucket(kernel.ballCell(vec3(positions[i])));
  }
  std::stable_sort(balls.slots.begin(), balls.slots.end(),
                   [&](uint a, uint b) { return buckets[a] < buckets[b]; });
  for (const uint i : balls.slots) {
    const ivec2 place = kernel.ringPlace(static_cast<int>(i));
    const bool fresh = place.y >= 0;
    const float radius = kernel.ballRadius(positions[i].w) * kernel.ballGrowth(place.x, velocities[i].w);
    balls.guesses.push_back(positions[i]);
    balls.begins.emplace_back(vec3(fresh ? positions[i] : starts[i]), buckets[i] == dead ? 0 : radius);
    balls.speeds.push_back(velocities[i]);
    balls.spins.push_back(fresh ? vec3(0) : vec3(spins[i]) * radius);
  }
  return balls;
}

void findNeighbours(Kernel& kernel, Balls& balls) {
  const std::size_t count = balls.guesses.size();
  balls.lists.resize(count);
  std::unordered_map<uint, std::pair<int, int>> runs;
  for (int s = 0; s < static_cast<int>(count); ++s) {
    if (balls.begins[static_cast<std::size_t>(s)].w <= 0) continue;
    const uint bucket =
        kernel.ballBucket(kernel.ballCell(vec3(balls.guesses[static_cast<std::size_t>(s)])));
    auto& run = runs.try_emplace(bucket, s, s).first->second;
    if (run.second - run.first < ballRun) run.second = s + 1;
  }
  for (std::size_t s = 0; s < count; ++s) {
    const vec4 here = balls.guesses[s];
    int touching = 0;
    for (int around = 0; around < 27 && balls.begins[s].w > 0; ++around) {
      const ivec3 cell = kernel.ballCell(vec3(here)) + kernel.ballNextCell(around);
      const auto run = runs.find(kernel.ballBucket(cell));
      if (run == runs.end()) continue;
      for (int j = run->second.first; j < run->second.second; ++j) {
        const auto other = static_cast<std::size_t>(j);
        if (other == s || kernel.ballCell(vec3(balls.guesses[other])) != cell) continue;
        const int near = kernel.ballsNear(vec3(here), vec3(balls.guesses[other]),
                                          balls.begins[s].w + balls.begins[other].w);
        if (near == 0 || static_cast<int>(balls.lists[s].size()) == kernel.stepData.balls.listed) continue;
        touching += near - 1;
        balls.lists[s].push_back(j);
      }
    }
    balls.places.emplace_back(vec3(here),
                              kernel.ballShare(touching) * exactReciprocal(std::max(here.w, 1e-30F)));
  }
}

Kernel::BallPath pathOf(Kernel& kernel, const Balls& balls, std::size_t s) {
  return kernel.ballPath(balls.places[s], balls.speeds[s]);
}

Kernel::BallImpact impactOf(Kernel& kernel, const Balls& balls, std::size_t a, std::size_t b) {
  return kernel.ballImpact(pathOf(kernel, balls, a), pathOf(kernel, balls, b),
                           balls.begins[a].w + balls.begins[b].w);
}

/// Returns the neighbour that each ball meets first, or the ball itself.
std::vector<std::size_t> partnersOf(Kernel& kernel, const Balls& balls) {
  std::vector<std::size_t> partners;
  for (std::size_t s = 0; s < balls.guesses.size(); ++s) {
    partners.push_back(s);
    Kernel::BallImpact best{};
    best.time = -1;
    uint bestTie = 0;
    for (const int j : balls.lists[s]) {
      const auto hit = impactOf(kernel, balls, s, static_cast<std::size_t>(j));
      const uint tie = kernel.ballTie(static_cast<int>(s), j);
      if (!kernel.ballSooner(hit, best, tie, bestTie)) continue;
      best = hit;
      bestTie = tie;
      partners[s] = static_cast<std::size_t>(j);
    }
  }
  return partners;
}

}  // namespace

void ParticlesTwin::strikeBalls(int index, Balls& balls) {
  Kernel kernel{{}, steps_[static_cast<std::size_t>(index)]};
  for (int round = 0; round < plan_.ballImpacts(); ++round) {
    const auto partners = partnersOf(kernel, balls);
    auto places = balls.places, speeds = balls.speeds;
    std::vector<vec3> turning = balls.spins;
    meet(index, [&](const Meet& out) {
      for (std::size_t s = 0; s < partners.size(); ++s) {
        const std::size_t other = partners[s];
        if (other == s || partners[other] != s) continue;
        const auto after =
            kernel.ballStruck(pathOf(kernel, balls, s), impactOf(kernel, balls, s, other), balls.perMass(s),
                              balls.perMass(other), balls.spins[s], balls.spins[other]);
        const Rolling rolling{after.spin, after.spin * kernel.stepData.dt};
        const vec4 end(after.path.end, balls.guesses[s].w);
        turning[s] =
            out(s, end, vec4(after.path.velocity, balls.speeds[s].w), &balls.begins[s], rolling).spin;
        places[s] = vec4(vec3(positions[s]), balls.places[s].w);
        speeds[s] = velocities[s];
      }
    });
    balls.places = places;
    balls.speeds = speeds;
    balls.spins = turning;
  }
}

void ParticlesTwin::correctBalls(int index, Balls& balls) {
  Kernel kernel{{}, steps_[static_cast<std::size_t>(index)]};
  for (const vec3& spin : balls.spins) balls.rolls.push_back(spin * kernel.stepData.dt);
  for (int round = 0; round < ballIterations; ++round) {
    std::vector<vec4> next = balls.places;
    std::vector<vec3> rolls(next.size(), vec3(0));
    meet(index, [&](const Meet& out) {
      for (std::size_t s = 0; s < next.size(); ++s) {
        if (balls.begins[s].w <= 0) continue;
        const Kernel::Ball here{balls.places[s], balls.begins[s]};
        vec3 sum(0), turned = balls.rolls[s];
        for (const int j : balls.lists[s]) {
          const auto other = static_cast<std::size_t>(j);
          const auto push =
              kernel.ballPush(here, {balls.places[other], balls.begins[other]}, balls.perMass(s),
                              static_cast<int>(s), j, balls.rolls[s] + balls.rolls[other]);
          sum = sum + push.way;
          turned = turned + push.roll;
        }
        const vec4 place(vec3(here.place) + kernel.ballPushes(sum, here.start.w), balls.guesses[s].w);
        rolls[s] = out(s, place, vec4(0), &balls.begins[s], {vec3(0), turned}).roll;
        next[s] = vec4(vec3(positions[s]), here.place.w);
      }
    });
    balls.places = next;
    balls.rolls = rolls;
  }
}

void ParticlesTwin::touchBalls(int index) {
  Kernel kernel{{}, steps_[static_cast<std::size_t>(index)]};
  Balls balls = sortedBalls(kernel, positions, starts, velocities, spins);
  findNeighbours(kernel, balls);
  const auto stateBefore = std::pair(positions, velocities);
  strikeBalls(index, balls);
  const auto struck = balls.places;
  correctBalls(index, balls);
  std::tie(positions, velocities) = stateBefore;
  const auto motionOf = [&](std::size_t s) {
    return kernel.ballMotion(vec3(struck[s]), vec3(balls.speeds[s]), balls.places[s]);
  };
  for (std::size_t s = 0; s < positions.size(); ++s) {
    if (balls.begins[s].w <= 0) continue;
    const auto here = motionOf(s);
    auto leaving = kernel.ballLeaving(here);
    for (const int j : balls.lists[s]) {
      const auto other = static_cast<std::size_t>(j);
      leaving = kernel.ballBounce(leaving, here, motionOf(other), balls.begins[s].w + balls.begins[other].w,
                                  balls.perMass(s), static_cast<int>(s), j);
    }
    vec3 velocity = kernel.ballLeft(leaving, here), place = vec3(here.place);
    const bool rests = leaving.touches && kernel.ballRests(vec3(balls.begins[s]), place, velocity);
    if (rests) {
      place = vec3(balls.begins[s]);
      velocity = kernel.ballIdle(velocity);
    }
    if (plan_.rolls()) {
      const std::size_t i = balls.slots[s];
      const vec3 spin = kernel.ballSpin(balls.rolls[s], balls.begins[s].w);
      spins[i] = vec4(rests ? kernel.ballIdle(spin) : spin, 0);
      if (kernel.ringPlace(static_cast<int>(i)).y >= 0) turns[i] = vec4(0, 0, 0, 1);
      turns[i] = kernel.ballTurned(turns[i], rests ? vec3(0) : spin);
    }
    positions[balls.slots[s]] = vec4(place, balls.guesses[s].w);
    velocities[balls.slots[s]] = vec4(velocity, balls.speeds[s].w);
  }
}

void ParticlesTwin::predict(int index, int threads) {
  const auto& p = plan_.parameters();
  const ParticleStep& data = steps_[static_cast<std::size_t>(index)];
  Kernel kernel{{}, data};
  kernel.blow(wind);
  starts = positions;
  meet(index, [&](const Meet& out) {
    forAll(positions.size(), threads, [&](std::size_t i) {
      auto m = kernel.moved(static_cast<int>(i), positions[i], velocities[i], vec3(accelerations[i]));
      if (plan_.rolls()) m = kernel.turning(m, spins[i]);
      const Rolling after = out(i, m.position, m.velocity, &starts[i], {m.spin, m.roll});
      if (!plan_.rolls()) return;
      m.position = positions[i];
      m.spin = after.spin;
      spins[i] = kernel.spinOf(m);
    });
    for (int e = 0; e < data.emitterCount; ++e)
      for (int k = 0; k < data.emitters[e].newborns; ++k) {
        const auto m = kernel.newbornMoved(e, k, p.attractor.has_value(), p.turbulence.strength > 0);
        out(static_cast<std::size_t>(kernel.newbornSlot(e, k)), m.position, m.velocity, nullptr, {});
      }
  });
  attract(threads);
  kick(data, threads);
  if (p.contact) touchBalls(index);
}

void ParticlesTwin::settle(int index) {
  meet(index, [&](const Meet& out) {
    for (std::size_t i = 0; i < positions.size(); ++i)
      if (starts[i].w != 0) out(i, positions[i], velocities[i], &starts[i], {});
  });
}

void ParticlesTwin::attract(int threads) {
  const auto& p = plan_.parameters();
  if (p.method == simreel::sim::GravityMethod::none) return;
  forAll(positions.size(), threads, [&](std::size_t i) {
    accelerations[i] = vec4(pairAcceleration(positions, vec3(positions[i]), p.gravity, p.softening), 0);
  });
}

void ParticlesTwin::kick(const ParticleStep& data, int threads) {
  const auto& p = plan_.parameters();
  const bool pairs = p.method != simreel::sim::GravityMethod::none;
  forAll(positions.size(), threads, [&](std::size_t i) {
    Kernel kernel{{}, data};
    kernel.blow(wind);
    Kernel::ParticleMotion m = kernel.particleMotion(positions[i], velocities[i]);
    const vec3 pull = pairs ? vec3(accelerations[i]) : vec3(0);
    Pace pace = data.pace;
    if (const auto place = kernel.ringPlace(static_cast<int>(i)); place.y >= 0) {
      pace = paceOf(kernel.livedSeconds(place.x, place.y), p.slowing());
      if (pairs) m = kernel.pulledSinceBirth(m, pull, pace);
    }
    const vec3 field = kernel.fieldAcceleration(data.fields, vec3(m.position), p.attractor.has_value(),
                                                p.turbulence.strength > 0);
    const vec3 acceleration = pairs ? pull + field : field;
    positions[i] = m.position;
    accelerations[i] = vec4(acceleration, 0);
    velocities[i] = kernel.kicked(m.velocity, acceleration, pace);
  });
}
