#include "reference/cloth_twin.hpp"

#include "reference/held_twin.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace {

using namespace simreel::shader;
#include "glsl/cloth/segment_links.glsl"
#include "glsl/cloth/thin_rounds.glsl"

#define FUNCTION inline
#define precise
/// Provides the globals that model.glsl reads in a kernel, and includes the model file.
struct Kernel : WindKernel {
  ivec2 size;
  const ClothStep& stepData;
  const vec4* source;
  MeshColliders meshData{};
  const uvec4* fieldCells = nullptr;
  HeightGrid heightGrid{};
  const vec4* heights = nullptr;
  WallGrid wallGrid{};
  const WallsTwin* walls = nullptr;
  [[nodiscard]] vec4 loadPosition(int i) const { return source[i]; }
  [[nodiscard]] vec4 loadHeights(int i) const { return heights[i]; }
  [[nodiscard]] uvec4 loadFieldCell(int i) const { return fieldCells[i]; }
  [[nodiscard]] int loadWallClass(int x, int y) const { return walls->classAt(x, y); }
  [[nodiscard]] float loadWallValue(int x, int y) const { return walls->valueAt(x, y); }
  int lineLinks = 0, lineStart = 0, linePace = 1;
  float lineRest = 0, lineCompliance = 0, lineGive = 0, lineKept = 0, lineSoftening = 1;
  bool keeps = false;
  const vec4* past = nullptr;  // positions at the start of the substep
  std::array<float, segmentLinks + 1> lineLower{}, lineMass{};
  std::array<float, segmentLinks> lineStretch{};
  [[nodiscard]] vec4 lineParticle(int k) const { return source[lineStart + k * linePace]; }
  [[nodiscard]] vec4 lineBefore(int k) const { return past[lineStart + k * linePace]; }
#include "glsl/cloth/line_model.glsl"
#include "glsl/cloth/model.glsl"
#include "glsl/cloth/segment.glsl"
#include "glsl/cloth/thin.glsl"
#include "glsl/collide/closest.glsl"
#include "glsl/contour/model.glsl"
#include "glsl/contour/wall_model.glsl"
#include "glsl/fluid/wind_model.glsl"
#include "glsl/mesh/height_model.glsl"
};
#undef precise
#undef FUNCTION

void tell(Kernel& kernel, const HeightGrid& grid, const vec4* heights, const WallGrid& wallGrid,
          const WallsTwin* walls) {
  kernel.heightGrid = grid;
  kernel.heights = heights;
  kernel.wallGrid = wallGrid;
  kernel.walls = walls;
}

void tellMeshes(Kernel& kernel, const DistanceTwin& meshes, int index) {
  kernel.meshData = meshes.steps[static_cast<std::size_t>(index)];
  kernel.fieldCells = meshes.cells.data();
}

template <class Body>
void forRows(int rows, int threads, const Body& body) {
  if (threads == 1) {
    for (int y = 0; y < rows; ++y) body(y);
    return;
  }
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : threads);
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<int>(0, rows), [&](const tbb::blocked_range<int>& range) {
      for (int y = range.begin(); y < range.end(); ++y) body(y);
    });
  });
}

/// Solves one line segment by segment, as glsl/cloth/solve_lines.comp does. Writes `particles` and, for
/// lines that conserve energy, `velocities`.
void solveLine(Kernel& kernel, std::vector<vec4>& particles, std::vector<vec4>& velocities) {
  std::vector<std::pair<int, int>> segments;  // first and last link of each segment
  for (int first = 0; first < kernel.lineLinks; first += segmentLinks)
    segments.emplace_back(first, min(first + segmentLinks, kernel.lineLinks) - 1);
  float stretch = 0;
  float pins = 0;
  for (const auto& [first, last] : segments) {
    stretch += kernel.readSegment(first, last);
    pins += kernel.pinsOf(first, last - first + 1);
  }
  const bool pinned = kernel.lineParticle(0).w == 0.0F && kernel.lineParticle(kernel.lineLinks).w == 0.0F;
  kernel.lineGive = kernel.keeps ? kernel.minCompliance(pins) : kernel.edgeComplianceOf(stretch, pinned);
  std::vector<Kernel::Reach> firsts, lasts;
  std::vector<Kernel::Eliminated> separators;
  struct Made {
    decltype(kernel.lineLower) lower, mass;
    decltype(kernel.lineStretch) stretch;
  };
  std::vector<Made> made;  // one element per segment
  for (const auto& [first, last] : segments) {
    kernel.readSegment(first, last);
    firsts.push_back(kernel.firstOfSegment(last - first + 1));
    lasts.push_back(kernel.lastOfSegment(last - first + 1));
    made.push_back({kernel.lineLower, kernel.lineMass, kernel.lineStretch});
  }
  Kernel::Eliminated eliminated{0, 0};
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto next = s + 1 < segments.size() ? firsts[s + 1] : Kernel::Reach{0, 0, 0};
    eliminated = kernel.eliminate(kernel.separatorRow(lasts[s], next), eliminated);
    separators.push_back(eliminated);
  }
  std::vector<float> multipliers(static_cast<std::size_t>(kernel.lineLinks));
  float after = 0;
  for (std::size_t s = segments.size(); s-- > 0;) {
    after = kernel.substituted(separators[s].onto, separators[s].from, after);
    separators[s].onto = after;
  }
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto [first, last] = segments[s];
    kernel.lineLower = made[s].lower;
    kernel.lineMass = made[s].mass;
    kernel.lineStretch = made[s].stretch;
    kernel.solveSegment(last - first + 1, s > 0 ? separators[s - 1].onto : 0.0F, separators[s].onto);
    for (int k = first; k <= last; ++k)
      multipliers[static_cast<std::size_t>(k)] = kernel.lineStretch[static_cast<std::size_t>(k - first)];
  }
  std::vector<vec4> moved;
  vec3 before(0);
  for (int k = 0; k <= kernel.lineLinks; ++k) {
    const bool more = k < kernel.lineLinks;
    const vec4 here = kernel.lineParticle(k);
    const auto i = static_cast<std::size_t>(k);
    vec3 pull(0);
    if (more && kernel.keeps)
      pull = kernel.keptPull(k, k > 0 ? multipliers[i - 1] : 0, multipliers[i],
                             k + 1 < kernel.lineLinks ? multipliers[i + 1] : 0);
    else if (more)
      pull = kernel.pullBetween(here, kernel.lineParticle(k + 1), true, multipliers[i]);
    if (kernel.keeps) {
      vec4& velocity = velocities[static_cast<std::size_t>(kernel.lineStart + k * kernel.linePace)];
      velocity = vec4(kernel.sped(vec3(velocity), here.w, before, pull), velocity.w);
    } else {
      moved.push_back(kernel.pulled(here, before, pull));
    }
    before = pull;
  }
  for (std::size_t k = 0; k < moved.size(); ++k)
    particles[static_cast<std::size_t>(kernel.lineStart + static_cast<int>(k) * kernel.linePace)] =
        moved[k];
}

/// Relaxes the families of pairs one after the other. Each family is divided into two colours, whose pairs
/// share no particle.
void relaxPairs(Kernel& kernel, const simreel::sim::ClothParameters& parameters,
                const std::vector<vec4>& positions, std::vector<vec4>& next) {
  const ivec2 size = parameters.size;
  for (const simreel::sim::SpringFamily& f : relaxedFamilies(parameters))
    for (int color = 0; color < 2; ++color)
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          const ivec2 to = ivec2(x, y) + f.reach;
          if (to.x < 0 || to.x >= size.x || to.y >= size.y) continue;
          const int along = f.reach.x > 0 ? x / f.reach.x : y / f.reach.y;
          if ((along & 1) != color) continue;
          const auto i = static_cast<std::size_t>(y * size.x + x);
          const auto j = static_cast<std::size_t>(to.y * size.x + to.x);
          const float length = kernel.springLength(f.kind);
          const float kept =
              parameters.damped() ? kernel.keptStretch(positions[i], positions[j], length) : 0.0F;
          const vec3 shift =
              kernel.constraintShift(next[i], next[j], length, kernel.scaledCompliance(f.kind), kept);
          next[i] = vec4(vec3(next[i]) - shift * next[i].w, next[i].w);
          next[j] = vec4(vec3(next[j]) + shift * next[j].w, next[j].w);
        }
}

}  // namespace

ClothTwin::ClothTwin(simreel::sim::ClothPlan plan)
    : positions(plan.firstPositions()),
      velocities(plan.firstVelocities()),
      trends(positions.size()),
      next(positions),
      plan_(std::move(plan)) {}

void ClothTwin::step(double time, int threads) {
  int index = 0;
  const auto steps = plan_.frame(time);
  if (meshes) meshes->beginFrame(time, plan_.substeps(), plan_.substepSeconds());
  pinDisplacements_ = plan_.skinPins().frame(time, time + plan_.substeps() * plan_.substepSeconds());
  for (const ClothStep& data : steps) substep(data, threads, index++);
}

void ClothTwin::substep(const ClothStep& data, int threads, int index) {
  predict(data, threads, index);
  finish();
}

void ClothTwin::finish() {
  std::swap(positions, next);
}

void ClothTwin::predict(const ClothStep& data, int threads, int index) {
  holdBySkin(pinDisplacements_, index, plan_.substeps(), velocities);
  const bool lands = heightPlan.has_value();
  HeightGrid grid{};
  if (lands) grid = heightPlan->at(index, plan_.substeps(), plan_.parameters().margin, 0.0F);
  WallGrid wallGrid{};
  if (walls) wallGrid = walls->grid({plan_.parameters().margin, 0.0F, plan_.substepSeconds()});
  const WallsTwin* solid = walls ? &*walls : nullptr;
  const bool constraints = plan_.parameters().constrained();
  const bool fabric = plan_.parameters().fabric.has_value();
  const bool air = plan_.parameters().air.has_value();
  const ivec2 size = plan_.parameters().size;
  forRows(size.y, threads, [&](int y) {
    Kernel kernel{{}, size, data, positions.data()};
    kernel.blow(wind);
    kernel.keeps = plan_.parameters().keepsEnergy();
    tell(kernel, grid, heights.data(), wallGrid, solid);
    if (meshes) tellMeshes(kernel, *meshes, index);
    for (int x = 0; x < size.x; ++x) {
      const auto i = static_cast<std::size_t>(y * size.x + x);
      const auto m = kernel.advance({x, y}, positions[i], velocities[i], vec3(trends[i]), !constraints, air,
                                    fabric, !constraints, lands, walls.has_value());
      next[i] = vec4(m.position, positions[i].w);
      velocities[i] = vec4(m.velocity, velocities[i].w);
    }
  });
  if (constraints) {
    constrain(data);
    settle(data, index, false);
  } else {
    for (int round = 0; round < thinRounds; ++round) resolveThin(data);
  }
  predicted_ = next;
}

void ClothTwin::settle(const ClothStep& data, int index, bool again) {
  const bool lands = heightPlan.has_value();
  HeightGrid grid{};
  if (lands) grid = heightPlan->at(index, plan_.substeps(), plan_.parameters().margin, 0.0F);
  WallGrid wallGrid{};
  if (walls) wallGrid = walls->grid({plan_.parameters().margin, 0.0F, plan_.substepSeconds()});
  const WallsTwin* solid = walls ? &*walls : nullptr;
  Kernel kernel{{}, plan_.parameters().size, data, positions.data()};
  kernel.blow(wind);
  tell(kernel, grid, heights.data(), wallGrid, solid);
  if (meshes) tellMeshes(kernel, *meshes, index);
  for (std::size_t i = 0; i < next.size(); ++i) {
    Kernel::Motion m;
    if (again) {
      m = kernel.settledAgain(positions[i], predicted_[i], next[i], vec3(velocities[i]), lands,
                              walls.has_value());
    } else if (plan_.parameters().keepsEnergy()) {
      m = kernel.forced(positions[i], next[i], vec3(velocities[i]), lands, walls.has_value());
    } else {
      const auto s = kernel.settled(positions[i], next[i], vec3(velocities[i]), vec3(trends[i]), lands,
                                    walls.has_value());
      m = s.motion;
      trends[i] = vec4(s.trend, 0);
    }
    next[i] = vec4(m.position, next[i].w);
    velocities[i] = vec4(m.velocity, velocities[i].w);
  }
  for (int round = 0; round < thinRounds; ++round) resolveThin(data);
}

void ClothTwin::resolveThin(const ClothStep& data) {
  if (data.thinCount == 0) return;
  const ivec2 size = plan_.parameters().size;
  const ivec2 around[] = {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}};
  Kernel kernel{{}, size, data, positions.data()};
  kernel.blow(wind);
  const auto indexOf = [&](ivec2 at) {
    return at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y ? at.y * size.x + at.x : -1;
  };
  const auto cornerAt = [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    return kernel.cornerOf(positions[i], next[i], velocities[i]);
  };
  std::vector<Kernel::ThinPush> all;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const Kernel::Corner here = cornerAt(indexOf({x, y}));
      Kernel::ThinPush sum = kernel.notPushed();
      for (int c = data.colliderCount; c < data.colliderCount + data.thinCount; ++c) {
        if (here.inverseMass == 0 || !kernel.mayMeet(c, here)) continue;
        Kernel::ThinPush maximum = kernel.notPushed();
        for (int k = 0; k < 6; ++k) {
          const int first = indexOf(ivec2(x, y) + around[k]);
          const int second = indexOf(ivec2(x, y) + around[(k + 1) % 6]);
          if (first < 0) continue;
          maximum = kernel.pushedByEdge(maximum, c, here, cornerAt(first));
          if (second >= 0)
            maximum = kernel.pushedByFace(maximum, c, here, cornerAt(first), cornerAt(second));
        }
        sum = kernel.together(sum, maximum);
      }
      all.push_back(sum);
    }
  for (std::size_t i = 0; i < all.size(); ++i) {
    next[i] = vec4(vec3(next[i]) + all[i].shift, next[i].w);
    velocities[i] = vec4(vec3(velocities[i]) + all[i].change, velocities[i].w);
  }
}

void ClothTwin::constrain(const ClothStep& data) {
  const ivec2 size = plan_.parameters().size;
  const bool damped = plan_.parameters().damped();
  const bool keeps = plan_.parameters().keepsEnergy();
  Kernel kernel{{}, size, data, keeps ? positions.data() : next.data()};
  kernel.blow(wind);
  kernel.past = positions.data();
  kernel.keeps = keeps;
  kernel.lineSoftening = data.softening;
  if (!keeps) relaxPairs(kernel, plan_.parameters(), positions, next);
  for (const bool rows : {true, false})
    for (int line = 0; line < (rows ? size.y : size.x); ++line) {
      kernel.lineLinks = (rows ? size.x : size.y) - 1;
      kernel.lineStart = rows ? line * size.x : line;
      kernel.linePace = rows ? 1 : size.x;
      kernel.lineRest = kernel.springLength(0);
      if (damped) kernel.lineKept = data.dampedPart;
      kernel.lineCompliance =
          plan_.parameters().fabric ? kernel.fabricCompliance(rows, line) : kernel.scaledCompliance(0);
      solveLine(kernel, next, velocities);
    }
}
