// Simple single-threaded versions of the simulations, with which bench_plain compares the kernels. They are
// compiled with -O3 for any x86-64 processor (without -march and -ffast-math) and call the functions of the
// standard library.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace plain {

struct Vec3 {
  float x, y, z;
};

/// Gray-Scott on a torus, with u and v in separate arrays.
class GrayScott {
 public:
  GrayScott(int width, int height);
  void step(float diffuseU, float diffuseV, float feed, float kill, float dt);
  std::vector<float> u, v;  ///< one value per cell; x varies fastest

 private:
  int width_, height_;
  std::vector<float> nextU_, nextV_;
};

/// Gray-Scott in a volume. The Laplacian uses six face neighbours with weight two and twelve edge
/// neighbours.
class GrayScottVolume {
 public:
  explicit GrayScottVolume(int side);
  void step(float diffuseU, float diffuseV, float feed, float kill, float dt);
  std::vector<float> u, v;  ///< one value per cell; x varies fastest, then y

 private:
  int side_;
  std::vector<float> nextU_, nextV_;
};

/// A sheet under gravity that is held together by springs (structural, shear and bend) or by XPBD
/// constraints.
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

/// A woven sheet under gravity. XPBD solves all links of a line of particles together, and then each
/// diagonal separately. The sheet resists bending like a plate.
class Fabric {
 public:
  struct Numbers {
    float spacing, density, weft, warp, shear, bending, gravity, kept, dt;
  };
  /// The pinned particles stay at their initial positions.
  Fabric(int width, int height, const Numbers& numbers);
  /// Computes the positions `next` from `position`. Call settle() afterwards. Other code, such as contact,
  /// may change `next` between the two calls.
  void predict();
  void settle();
  std::vector<Vec3> position, velocity, next;
  std::vector<float> inverseMass;  ///< one value per particle; 0 for a pinned particle

 private:
  [[nodiscard]] std::size_t at(int x, int y) const { return std::size_t(y) * width_ + x; }
  void bend();
  void pull(std::size_t a, std::size_t b, float rest, float give);
  void line(std::size_t first, std::size_t pace, int count, float stiffness);
  int width_, height_;
  Numbers n_;
  std::vector<Vec3> force_, along_;
  std::vector<float> upper_, lambda_;
};

/// Cloth of triangles. XPBD visits the faces one by one and solves weft, warp and shear of a face together.
/// Bending forces come from a sparse matrix, whose rows are stored in `bends`.
class Garment {
 public:
  struct Face {
    int a, b, c;
    float p, q, r, s;         ///< elements of the inverse of the face's 2x2 matrix of rest positions
    float weft, warp, shear;  ///< compliances of the fabric divided by dt^2
  };
  struct Bend {
    int other;
    float stiffness;
  };
  std::vector<Vec3> position, velocity;
  std::vector<float> inverseMass;
  std::vector<Face> faces;
  std::vector<int> firstBend;  ///< index of the first entry of each vertex in `bends`; the last element is
                               ///< the total number of entries
  std::vector<Bend> bends;
  float gravity, kept, dt;
  void step();

 private:
  std::vector<Vec3> next_;
};

/// Prevents faces and edges from passing through each other. In every substep, a hash grid of cubic cells
/// finds near pairs of a vertex and a face and of two edges. Two rounds of impulses with friction then
/// separate the pairs.
class Contact {
 public:
  Contact(std::vector<std::uint32_t> indices, std::size_t vertices, float cell, float thickness,
          float friction);
  /// Applies the impulses of the contacts to the predicted positions `next`.
  void push(const std::vector<Vec3>& now, std::vector<Vec3>& next, const std::vector<float>& inverseMass);

 private:
  struct Touch {
    int corner[4];
    float share[4];  ///< barycentric weights of the four vertices; positive on one of the touching parts,
                     ///< negative on the other
    Vec3 normal;
    float distance;
  };
  struct Box {
    Vec3 low, high;
  };
  void fill(const std::vector<Box>& boxes);
  template <class Visit>
  void cells(const Box& box, const Visit& visit) const;
  [[nodiscard]] std::size_t slot(int x, int y, int z) const;
  void addVertex(const std::vector<Vec3>& now, int v, std::size_t face);
  void addEdges(const std::vector<Vec3>& now, std::size_t i, std::size_t j);
  void addTouch(const int* corner, const float* share, const Vec3& apart);
  void solve(const std::vector<Vec3>& now, std::vector<Vec3>& next, const std::vector<float>& inverseMass);
  std::vector<std::uint32_t> indices_, edges_;
  float cell_, thickness_, friction_;
  std::vector<std::uint32_t> starts_, entries_;
  std::vector<Box> boxes_;
  std::vector<Touch> touches_;
};

/// Incompressible flow on a staggered grid that is closed on all sides, with an obstacle and three jets.
/// Advection is MacCormack's. Buoyancy acts on the flow. Multigrid cycles run until max|div u| is at most
/// 1e-5 of max|u|. Dye moves by monotone fluxes.
class Fluid {
 public:
  struct Numbers {
    float dt, lift, kept;
    int dyePasses;
  };
  struct Jet {
    float x, y, radius, u, v, dye[3];
  };
  Fluid(int width, int height, const Numbers& numbers);
  static std::vector<Jet> jetsOf(int width, int height);
  void step();
  std::vector<float> u, v, heat, dye[3];
  std::vector<unsigned char> solid;
  int cycles = 0;  ///< number of multigrid cycles in the latest step

 private:
  struct Level {
    int width, height;
    std::vector<float> value, rhs, across, down;
  };
  [[nodiscard]] std::size_t at(int x, int y) const { return std::size_t(y) * width_ + x; }
  void velocity(float x, float y, float& a, float& b) const;
  void trace(float& x, float& y, float dt) const;
  void carry(const std::vector<float>& from, std::vector<float>& forth, std::vector<float>& to, int w,
             int h, float ox, float oy) const;
  void paint();
  static void sweep(Level& l, int color);
  [[nodiscard]] float residual(const Level& l, int x, int y) const;
  void project();
  void moveDye(std::vector<float>& d, float dt);
  int width_, height_;
  Numbers n_;
  std::vector<Jet> jets_;
  std::vector<float> nextU_, nextV_, nextHeat_, forthU_, forthV_, forthHeat_, flux_;
  std::vector<Level> levels_;
};

/// Shallow water with walls, solved with MUSCL-Hancock, HLL fluxes and hydrostatic reconstruction.
class Water {
 public:
  struct Numbers {
    float ratio, gravity, thin, dry, kept;
  };
  Water(int width, int height, const Numbers& numbers);
  void step();
  std::vector<float> level, alongX, alongY, bed;

 private:
  struct Cell {
    float level, depth, u, v;
  };
  static constexpr std::size_t none = ~std::size_t{0};
  [[nodiscard]] std::size_t at(int x, int y) const { return std::size_t(y) * width_ + x; }
  [[nodiscard]] Cell cell(int x, int y) const;
  void flow(std::size_t before, std::size_t behind, bool across, std::size_t a, std::size_t b);
  int width_, height_;
  Numbers n_;
  std::vector<float> nextLevel_, nextX_, nextY_;
  std::vector<Cell> slopesX_, slopesY_, halves_;
};

/// Performs float operations at the highest rate that one thread reaches. Returns the number of operations.
double arithmetic();
/// Copies a buffer repeatedly on one thread. `bytes` is the size of the buffer and the copy together.
/// Returns the number of bytes read and written.
double copying(std::size_t bytes);

/// Epidemic with one byte per cell: 1 is susceptible, 2 infected, 3 immune. Probabilities are in
/// thousandths. Random numbers come from the hash function of simreel's kernels.
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

/// Wildfire with one byte per cell: 0 is bare, 1 fuel, 255 burnt. A value of 2 or more is burning, and
/// counts the steps that are left. The probability of spreading depends on the wind and is stored for each
/// of eight directions.
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

/// Game of Life (rule B3/S23) on a torus with one byte per cell.
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
/// Computes the gravitational acceleration of every body by summing over all other bodies.
void pairs(const std::vector<Body>& bodies, std::vector<Vec3>& acceleration, float gravity,
           float softening);
/// Computes the gravitational accelerations with a Barnes-Hut octree, which is built first and then
/// traversed for each body.
void tree(const std::vector<Body>& bodies, std::vector<Vec3>& acceleration, float gravity, float softening,
          float opening);

/// A grid of vertices that is displaced by waves from its middle. The vertex normals are computed from the
/// faces.
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

/// Mesh of floor, walls and rock, made from a map of bytes in which 1 means rock. Marching squares with
/// shared vertices builds it. The vectors keep their capacity from frame to frame.
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
