#include "reference/contact_twin.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace {

using namespace simreel::shader;

#define FUNCTION inline
#define precise
struct ContactKernel {
  const ContactStep& contactStep;
#include "glsl/contact/model.glsl"
#include "glsl/contact/search.glsl"
};
#undef precise
#undef FUNCTION

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

float ContactTwin::thicknessOf(auto& kernel, const ivec4& corners) const {
  return kernel.thicknessBetween(corners, plan_.skins()[at(corners.x)].x, plan_.skins()[at(corners.w)].x);
}

void ContactTwin::push(const std::vector<Part>& parts, bool first) {
  const ContactStep step = plan_.step(first, 1 << 20);
  ContactKernel kernel{step};
  const auto& skins = plan_.skins();
  std::vector<vec4>&now = now_, &next = next_;
  now.clear();
  next.clear();
  for (const Part& part : parts) {
    for (std::size_t k = 0; k < part.now->size(); ++k) {
      const vec4& p = (*part.now)[k];
      const int v = static_cast<int>(now.size());
      now.emplace_back(vec3(p), kernel.isSolid(v)  ? 0.0F
                                : kernel.isBall(v) ? kernel.ballWeight(p.w, (*part.next)[k].w)
                                                   : p.w);
    }
    next.insert(next.end(), part.next->begin(), part.next->end());
  }
  const auto xyz = [](const std::vector<vec4>& from, int i) { return vec3(from[at(i)]); };
  const std::size_t movable = at(plan_.movable());
  const float maxPathBefore = maxPath_;
  maxPath_ = 0;
  const auto isGone = [&](std::size_t i) { return kernel.isBall(static_cast<int>(i)) && now[i].w == 0; };
  for (std::size_t i = at(plan_.balls()); i < now.size(); ++i) {
    const float way = isGone(i) ? 0.0F : kernel.lengthOf(vec3(now[i]), vec3(next[i]));
    maxPath_ = std::max(maxPath_, i < movable ? kernel.ballMotion(way, skins[i].z) : way);
  }
  bool stale = first || hulls_.empty() || maxPath_ > searched_;
  for (std::size_t i = 0; i < next.size() && !stale; ++i)
    stale = !isGone(i) &&
            !kernel.pairsComplete(vec3(next[i]), hulls_[i].low, hulls_[i].high, maxPathBefore, beside_[i]);
  if (stale) {
    ++searches;
    searched_ = kernel.searchAllowance(maxPath_);
    beside_.assign(now.size(), 0.0F);
    hulls_.clear();
    for (std::size_t i = 0; i < next.size(); ++i)
      hulls_.push_back(kernel.widened(kernel.reachOf(vec3(now[i]), vec3(next[i]), skins[i].x),
                                      i < movable ? searched_ : 0.0F));
    for (std::size_t i = 0; i < next.size(); ++i)
      if (isGone(i)) hulls_[i] = {vec3(1e30F), vec3(-1e30F)};
    vertexPairs_.clear();
    edgePairs_.clear();
    const auto hullOf = [&](uint v) { return kernel.widened(hulls_[v], skins[v].x); };
    const auto boxesOf = [&](const std::vector<uvec4>& leaves) {
      std::vector<Hull> boxes;
      for (const uvec4& leaf : leaves)
        boxes.push_back(kernel.together(kernel.together(hullOf(leaf.x), hullOf(leaf.y)), hullOf(leaf.z)));
      return boxes;
    };
    const auto meet = [&](const Hull& a, const Hull& b) {
      return kernel.overlap(a.low, a.high, b.low, b.high);
    };
    const auto bothSolid = [&](uint a, uint b) { return a >= at(plan_.balls()) && b >= movable; };
    const auto radius = [&](uint v) {
      return kernel.radiusOf(vec3(now[v]), hulls_[v].low, hulls_[v].high);
    };
    const auto place = [&](uint v) { return vec3(now[v]); };
    const auto sift = [&](bool edge, uint a, uint b, uint c, uint d) {
      const Near n = edge ? kernel.nearOfEdges(ivec4(0), place(a), place(b), place(c), place(d))
                          : kernel.nearOfVertex(ivec4(0), place(a), place(b), place(c), place(d));
      if (!kernel.mayMeet(n, vec4(radius(a), radius(b), radius(c), radius(d)),
                          thicknessOf(kernel, ivec4(a, b, c, d))))
        return;
      const bool ball = kernel.isBall(static_cast<int>(a));
      if (ball && skins[a].w >= 0 && skins[a].w != skins[b].w) return;
      if (kernel.isSolid(static_cast<int>(a)) || kernel.isSolid(static_cast<int>(d)) || ball)
        for (const uint v : {a, b, c, d})
          if (v < movable) beside_[v] = 1;
      (edge ? edgePairs_ : vertexPairs_).emplace_back(a, b, c, d);
    };
    const auto& faces = plan_.faces();
    const std::vector<Hull> faceBoxes = boxesOf(faces);
    for (uint v = 0; v < now.size(); ++v)
      for (std::size_t f = 0; f < faces.size(); ++f)
        if (faces[f].w == 0 && !bothSolid(v, faces[f].x) && !kernel.isCornerOf(faces[f], v) &&
            meet(hullOf(v), faceBoxes[f]))
          sift(false, v, faces[f].x, faces[f].y, faces[f].z);
    const auto& edges = plan_.edges();
    const std::vector<Hull> edgeBoxes = boxesOf(edges);
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (std::size_t j = i + 1; j < edges.size(); ++j)
        if (edges[i].w == 0 && edges[j].w == 0 && !bothSolid(edges[i].x, edges[j].x) &&
            !kernel.isCornerOf(edges[j], edges[i].x) && !kernel.isCornerOf(edges[j], edges[i].y) &&
            meet(edgeBoxes[i], edgeBoxes[j]))
          sift(true, edges[i].x, edges[i].y, edges[j].x, edges[j].y);
  }
  pairs = vertexPairs_.size() + edgePairs_.size();
  extraMoves_.clear();
  for (std::size_t i = 0; i < now.size(); ++i)
    extraMoves_.push_back(kernel.extraMoveLimit(vec3(now[i]), vec3(next[i]), maxPath_, beside_[i]));

  std::vector<Near>& near = near_;
  near.clear();
  std::vector<float> nearest(now.size(), 1e30F);
  std::vector<vec3> up(now.size(), vec3(0)), down = up;
  const auto carry = [&](const Near& n, const vec3& way, const vec4& carries) {
    const ivec4 c = kernel.cornersOf(n);
    for (int k = 0; k < 4; ++k) {
      const vec3 by = way * carries[k];
      up[at(c[k])] = max(up[at(c[k])], by);
      down[at(c[k])] = max(down[at(c[k])], -by);
    }
  };
  const auto consider = [&](const Near& n) {
    const ivec4 c = kernel.cornersOf(n);
    const vec4 heights = kernel.heightsOf(n, xyz(now, c.x), xyz(now, c.y), xyz(now, c.z), xyz(now, c.w));
    const vec4 rises = kernel.heightsOf(n, xyz(next, c.x) - xyz(now, c.x), xyz(next, c.y) - xyz(now, c.y),
                                        xyz(next, c.z) - xyz(now, c.z), xyz(next, c.w) - xyz(now, c.w));
    const float thick = thicknessOf(kernel, c);
    const vec4 extraMoves(extraMoves_[at(c.x)], extraMoves_[at(c.y)], extraMoves_[at(c.z)],
                          extraMoves_[at(c.w)]);
    if (isGone(at(c.x))) return;
    if (!kernel.isNear(n, heights, rises, thick, extraMoves)) return;
    near.push_back(n);
    nearest[at(c.x)] = std::min(nearest[at(c.x)], n.normal.w);
    if (!kernel.meetsSolid(n)) return;
    const bool solid = kernel.isSolid(c.x);
    const vec3 way =
        kernel.wayOfSide(n, solid, xyz(next, c.x) - xyz(now, c.x), xyz(next, c.y) - xyz(now, c.y),
                         xyz(next, c.z) - xyz(now, c.z), xyz(next, c.w) - xyz(now, c.w));
    carry(n, way, kernel.carriesOf(n, solid, heights, heights + rises, way, thick));
  };
  for (const ivec4& c : vertexPairs_)
    consider(kernel.nearOfVertex(c, xyz(now, c.x), xyz(now, c.y), xyz(now, c.z), xyz(now, c.w)));
  for (const ivec4& c : edgePairs_)
    consider(kernel.nearOfEdges(c, xyz(now, c.x), xyz(now, c.y), xyz(now, c.z), xyz(now, c.w)));
  nears = near.size();
  const auto start = [&] {
    starts_.clear();
    for (std::size_t i = 0; i < now.size(); ++i)
      starts_.push_back(maxPath_ == 0 || !kernel.hasSolids() ? vec3(now[i])
                                                             : kernel.carriedTo(now[i], up[i], down[i]));
  };
  start();
  for (int round = 0; round < simreel::sim::ContactPlan::carryRounds && maxPath_ > 0; ++round) {
    for (const Near& n : near) {
      const ivec4 c = kernel.cornersOf(n);
      if (kernel.meetsSolid(n)) continue;
      const auto by = [&](int v) { return starts_[at(v)] - xyz(now, v); };
      const vec4 heights = kernel.heightsOf(n, xyz(now, c.x), xyz(now, c.y), xyz(now, c.z), xyz(now, c.w));
      const vec4 after = heights + kernel.heightsOf(n, by(c.x), by(c.y), by(c.z), by(c.w));
      const float thick = thicknessOf(kernel, c);
      if (kernel.gapOf(n, after) >= kernel.leftOf(kernel.gapOf(n, heights), thick)) continue;
      const vec3 way = kernel.wayOfSide(n, true, by(c.x), by(c.y), by(c.z), by(c.w));
      const vec3 otherWay = kernel.wayOfSide(n, false, by(c.x), by(c.y), by(c.z), by(c.w));
      const bool further = kernel.firstGoesFurther(n, way, otherWay);
      const vec3 leading = further ? way : otherWay;
      carry(n, leading, kernel.carriesOf(n, further, heights, after, leading, thick));
    }
    start();
  }
  carried = 0;
  for (std::size_t i = 0; i < movable; ++i) carried += starts_[i] == vec3(now[i]) ? 0 : 1;

  std::vector<vec4>& wanted = wanted_;
  wanted = next;
  for (int round = 0; round < plan_.rounds(); ++round) {
    std::vector<int> counts(now.size(), 0);
    std::vector<vec3> ways;
    touching = 0;
    for (const Near& n : near) {
      const ivec4 c = kernel.cornersOf(n);
      std::array<vec3, 4> moves;
      for (int k = 0; k < 4; ++k) moves[at(k)] = xyz(wanted, c[k]) - xyz(now, c[k]);
      const vec3 slide = kernel.weighted(n.shares, moves[0], moves[1], moves[2], moves[3]);
      const float thick = thicknessOf(kernel, c);
      const float friction = kernel.frictionBetween(skins[at(c.x)].y, skins[at(c.w)].y);
      bool pushes = kernel.isInside(n);
      float back = -1e30F;
      if (kernel.isBall(c.x)) {
        const auto led = [&](int v) { return xyz(next, v) - xyz(now, v); };
        pushes = kernel.pushesBall(n, nearest[at(c.x)]);
        back = kernel.givenBack(n, kernel.weighted(n.shares, led(c.x), led(c.y), led(c.z), led(c.w)), thick,
                                skins[at(c.x)].z);
      }
      const vec3 way = kernel.correctionOf(n, slide, thick, friction, back, pushes);
      ways.push_back(way);
      if (way == vec3(0)) continue;
      ++touching;
      for (int k = 0; k < 4; ++k) counts[at(c[k])] += kernel.massWeightOf(n.shares[k]);
    }
    std::vector<ivec3> sums(now.size(), ivec3(0));
    for (std::size_t i = 0; i < near.size(); ++i) {
      if (ways[i] == vec3(0)) continue;
      const Near& n = near[i];
      const ivec4 c = kernel.cornersOf(n);
      vec4 weights(0);
      for (int k = 0; k < 4; ++k) weights[k] = kernel.weightOf(now[at(c[k])].w, counts[at(c[k])]);
      const vec3 impulse = kernel.impulseOf(n.shares, weights, ways[i]);
      ivec3 rest(0);
      for (int k = 0; k < 3; ++k) {
        const ivec3 quanta = kernel.quantaOf(impulse, n.shares[k]);
        sums[at(c[k])] += quanta;
        rest -= quanta;
      }
      sums[at(c.w)] += rest;
    }
    for (std::size_t i = 0; i < movable; ++i) {
      const float maximum = 0.5F * skins[i].x + extraMoves_[i];
      const vec3 moved = kernel.pushedTo(vec3(next[i]), vec3(wanted[i]), now[i].w, sums[i], maximum,
                                         hulls_[i].low, hulls_[i].high);
      if (counts[i] > 0 && now[i].w > 0) wanted[i] = vec4(moved, wanted[i].w);
    }
  }

  std::size_t i = 0;
  for (const Part& part : parts)
    for (std::size_t k = 0; k < part.next->size(); ++k, ++i) {
      if (i >= movable) continue;
      (*part.next)[k] = wanted[i];
      if (!kernel.isBall(static_cast<int>(i)) || now[i].w == 0) continue;
      vec4& velocity = (*part.velocities)[k];
      velocity = vec4(kernel.speedBy(vec3(velocity), vec3(next[i]), vec3(wanted[i])), velocity.w);
    }
}

void ContactTwin::hold(const std::vector<Part>& parts) {
  const ContactStep step = plan_.step(false, 1 << 20);
  ContactKernel kernel{step};
  const auto& skins = plan_.skins();
  const std::vector<vec4>& now = now_;
  std::vector<vec4>& wanted = wanted_;
  const auto xyz = [](const std::vector<vec4>& from, int k) { return vec3(from[at(k)]); };
  std::size_t vertex = 0;
  for (const Part& part : parts)
    for (const vec4& settled : *part.next) {
      wanted[vertex] = kernel.isBall(static_cast<int>(vertex)) && now[vertex].w == 0
                           ? settled
                           : vec4(kernel.keptWithin(vec3(next_[vertex]), vec3(settled),
                                                    skins[vertex].x * 1.25F + extraMoves_[vertex],
                                                    hulls_[vertex].low, hulls_[vertex].high),
                                  settled.w);
      ++vertex;
    }
  std::vector<float> let(now.size(), 1.0F), still(now.size(), 1.0F);
  const auto hold = [&](int round) {
    bool any = false;
    const std::vector<float> before = let;
    for (const Near& n : near_) {
      const ivec4 c = kernel.cornersOf(n);
      const vec4 heights = kernel.heightsOf(n, xyz(now, c.x), xyz(now, c.y), xyz(now, c.z), xyz(now, c.w));
      const vec4 starts =
          kernel.heightsOf(n, starts_[at(c.x)], starts_[at(c.y)], starts_[at(c.z)], starts_[at(c.w)]);
      const auto way = [&](int v) { return xyz(wanted, v) - starts_[at(v)]; };
      const vec4 rises = kernel.heightsOf(n, way(c.x), way(c.y), way(c.z), way(c.w));
      const float thick = thicknessOf(kernel, c);
      const vec4 own = kernel.letOf(n, heights, starts, rises, thick);
      if (round == 0)
        for (int k = 0; k < 4; ++k) still[at(c[k])] = std::min(still[at(c[k])], own[k]);
      const vec4 lets(before[at(c.x)], before[at(c.y)], before[at(c.z)], before[at(c.w)]);
      if (!kernel.passes(n, heights, starts, rises, lets, thick)) continue;
      any = any || !kernel.meetsSolid(n);
      for (int k = 0; k < 4; ++k) let[at(c[k])] = std::min(let[at(c[k])], own[k]);
    }
    return any;
  };
  allStopped = false;
  for (int round = 0; round < 4; ++round) allStopped = hold(round);
  stopped = 0;
  std::size_t i = 0;
  for (const Part& part : parts)
    for (std::size_t k = 0; k < part.next->size(); ++k, ++i) {
      if (i >= at(plan_.movable())) continue;
      const float part_ = now[i].w == 0.0F ? 1.0F : allStopped ? still[i] : let[i];
      if (part_ < 1) ++stopped;
      const vec3 held = kernel.heldAt(starts_[i], vec3(wanted[i]), part_);
      const vec3 v = kernel.speedBy(vec3((*part.velocities)[k]), vec3((*part.next)[k]), held);
      (*part.next)[k] = vec4(held, wanted[i].w);
      if (now[i].w > 0) (*part.velocities)[k] = vec4(v, (*part.velocities)[k].w);
    }
}
