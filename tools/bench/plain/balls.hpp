#pragma once
#include "plain.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace plain {

/// Balls of one size and mass in a box without a lid, by the method of glsl/particles/contact.
class BallHeap {
 public:
  struct Numbers {
    float radius, half;  ///< of a ball; of the box across, m
    float weight, friction, restitution, bounce;
    int impacts, iterations;
  };
  BallHeap(const Numbers& numbers, std::vector<Vec3> places, std::vector<Vec3> speeds)
      : positions(std::move(places)),
        velocities(std::move(speeds)),
        numbers_(numbers),
        starts_(positions),
        struck_(positions),
        lists_(positions.size() * listed),
        counts_(positions.size()),
        partners_(positions.size()),
        shares_(positions.size()) {
    for (std::vector<Vec3>& scratch : scratch_) scratch = positions;
  }
  void step(float dt);
  std::vector<Vec3> positions, velocities;  ///< sorted again in each step

 private:
  static constexpr std::size_t listed = 16;
  struct Impact {
    float time = -1, speed = 0;
    Vec3 normal = {0, 0, 0};
  };
  void outOfBox(Vec3& p, Vec3* velocity, const Vec3& from) const;
  void search();
  [[nodiscard]] Impact impactOf(std::size_t a, std::size_t b, float dt) const;
  void strike(float dt);
  void correct();
  void leave(float dt);
  Numbers numbers_;
  std::vector<Vec3> starts_, struck_, scratch_[3];
  std::vector<int> firsts_, lists_, counts_, partners_;
  std::vector<float> shares_;
};

}  // namespace plain
