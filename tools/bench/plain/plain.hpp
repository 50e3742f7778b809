// The simulations as one writes them in an afternoon, on one thread: what bench_plain holds the kernels
// against. Compiled with -O3 for any x86-64 (no -march, no -ffast-math); the standard library's functions,
// the compiler's own arithmetic.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace plain {

struct Vec3 {
  float x, y, z;
};

/// Gray-Scott on a torus, u and v in arrays of their own.
class GrayScott {
 public:
  GrayScott(int width, int height);
  void step(float diffuseU, float diffuseV, float feed, float kill, float dt);
  std::vector<float> u, v;  ///< x fastest

 private:
  int width_, height_;
  std::vector<float> nextU_, nextV_;
};

/// A sheet of springs (structural, shear, bend) under gravity, or of XPBD constraints.
class Cloth {
 public:
  struct Numbers {
    float spacing, stiffness, shear, bend, inverseMass, gravity, kept, dt;
    float compliance, shearCompliance, bendCompliance;
  };
  Cloth(int width, int height, const Numbers& numbers);
  void springStep();
  void constraintStep();
  std::vector<Vec3> position, velocity;

 private:
  void solve(int dx, int dy, float rest, float compliance);
  int width_, height_;
  Numbers n_;
  std::vector<Vec3> before_;
};

/// Bytes: 1 susceptible, 2 infected, 3 immune; a thousandth's chance by the same hash as ours.
class Epidemic {
 public:
  Epidemic(int side, std::vector<std::uint8_t> cells);
  void step(const std::uint32_t* infection, std::uint32_t recovery, std::uint32_t waning,
            std::uint32_t step);
  std::vector<std::uint8_t> cells;

 private:
  int side_;
  std::vector<std::uint8_t> next_;
};

/// Bytes: 0 bare, 1 fuel, 2 and up burning for so many steps more, 255 burnt. Eight chances by the wind.
class Wildfire {
 public:
  Wildfire(int side, std::vector<std::uint8_t> cells, const float* chances, int burnSteps);
  void step(std::uint32_t step);
  std::vector<std::uint8_t> cells;

 private:
  int side_, burnSteps_;
  float chances_[8];
  std::vector<std::uint8_t> next_;
};

/// B3/S23 on a torus, a byte a cell.
class Life {
 public:
  Life(int width, int height);
  void step();
  std::vector<std::uint8_t> cells;

 private:
  int width_, height_;
  std::vector<std::uint8_t> next_;
};

struct Body {
  float x, y, z, mass;
};
/// All pairs.
void pairs(const std::vector<Body>& bodies, std::vector<Vec3>& acceleration, float gravity,
           float softening);
/// Barnes and Hut's octree: built, then walked for each body.
void tree(const std::vector<Body>& bodies, std::vector<Vec3>& acceleration, float gravity, float softening,
          float opening);

/// A grid of vertices with a ripple from the middle, and its normals from the faces.
class Ripple {
 public:
  Ripple(int width, int height, float size);
  void step(float phase, float amplitude, float wavenumber, float decay);
  std::vector<Vec3> position, normal;

 private:
  int width_, height_;
  std::vector<Vec3> rest_;
  std::vector<std::uint32_t> indices_;
};

/// Floor, walls and rock of a map of bytes, 1 rock: marching squares with shared vertices, into vectors
/// that keep their memory.
class Walls {
 public:
  Walls(int width, int height);
  void make();
  std::vector<std::uint8_t> rock;
  std::vector<Vec3> position, normal;
  std::vector<std::uint32_t> indices;

 private:
  int crossing(int x, int y, bool along);
  void square(int x, int y);
  int width_, height_;
  std::vector<int> across_, down_;
  std::vector<Vec3> corners_;
};

}  // namespace plain
