#pragma once
#include "scene/value/formula.hpp"
#include "sim/core/drawable.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/grid/field_display.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// A buffer or texture of a user's kernels, as described in a scene.
struct KernelMemory {
  std::string name;
  scene::Formula
      size;  ///< number of elements or texels along one to three axes; if empty, the size of `file`, or one
  scene::Formulas start;  ///< initial values by member; other members are zero
  std::filesystem::path file;
  bool previous = false;  ///< true if kernels read the contents that the buffer had before their dispatch
  bool upward = false;    ///< true if the first row of the file is the last row of the texture
  double counter = 0;     ///< initial counter value, for append and consume buffers
  // The following members apply only to textures.
  std::string field;  ///< name of another object's field that the texture is filled with, OBJECT or
                      ///< OBJECT.PART
  enum class FieldReadTime { everyFrame, start };
  FieldReadTime readTime = FieldReadTime::everyFrame;
  std::string format;  ///< GLSL image format; if empty, the format in the shader, or 32 bits per channel
  enum class Filter { shader, point, linear };
  enum class Wrap { shader, repeat, clamp, mirror };
  Filter filter = Filter::shader;
  Wrap wrap = Wrap::shader;
};

/// File with the numbers of a constant: a row for each element of its array.
struct KernelConstantFile {
  std::string name;  ///< name of the constant
  std::filesystem::path file;
};

/// Entry of a schedule: a dispatch, or an operation between dispatches.
struct KernelEntry {
  std::string kernel;
  scene::Formula threads;  ///< number of invocations along each axis; if empty, it is derived from the
                           ///< outputs of the kernel
  int repeat = 1, every = 1;
  std::string indirect;     ///< buffer that contains the workgroup counts
  int offset = 0;           ///< byte offset in `indirect` or `into`
  scene::Formula swap;      ///< names of two buffers or textures that are swapped after the kernel has run
  std::string clear;        ///< name of a buffer or texture to fill with zeros
  std::string count, into;  ///< names of two buffers: the counter of `count` is copied into `into`
};

/// Triangle mesh whose vertices are elements of a buffer.
struct KernelSurface {
  std::string of, position = "position", normal;
  glm::ivec2 grid{0, 0};       ///< number of vertices along x and y; if 0, the size of the buffer
  std::string indices;         ///< buffer with three indices per triangle
  std::filesystem::path mesh;  ///< mesh file that provides the triangles
  bool doubleSided = true;
};

/// Elements of a buffer that are drawn as spheres, discs or meshes.
struct KernelPoints {
  std::string of, position = "position", velocity, mass, alive, rotation;
  Instances::Shape shape = Instances::Shape::sprite;
  std::filesystem::path mesh;
  bool alongVelocity = false;
  float size = 0.05F;
  float massExponent = 0;
  Instances::ColorBy colorBy = Instances::ColorBy::material;
  glm::vec2 colorRange{0, 1};
  AutoEnds autoColors;  ///< states which ends of `colorRange` a first run measures
  std::string map = "inferno";
  bool additive = false;
  float brightness = 1;
};

/// Texture, or elements of a buffer, drawn as a field over the picture.
struct KernelField {
  std::string of, show;  ///< member or component; if empty, a colour if the element has at least three
                         ///< numbers, otherwise its first number
  bool encoded = false;  ///< true if colours are sRGB values, false if they are linear
  FieldDisplay display;
};

/// Ground whose heights are the elements of a 2-D texture or of a buffer.
struct KernelTerrain {
  std::string of, height;  ///< member or channel that holds the height; if empty, the first number
  glm::vec3 position{0};   ///< centre of the ground at height 0, in metres
  float width = 4;         ///< width along x in metres
  float scale = 1;         ///< height in metres of the value 1
  int finer = 1;           ///< number of cells of the drawn grid per distance between two neighbouring
                           ///< heights; 0 chooses it by the size of the ground
  bool collides = false;
  float grip = 25.3F;  ///< decay rate (1/s) of the tangential velocity of objects that slide on the ground

  /// Returns the distance in metres between elements if there are `count` of them along x.
  [[nodiscard]] float cell(int count) const { return width / static_cast<float>(count - 1); }
  /// Returns `finer`, or for 0 a power of two that gives about 256 vertices along the longer side.
  [[nodiscard]] int steps(glm::ivec2 heights) const;
};

/// Surface on which the numbers of a 3-D texture, or of a buffer with three axes, equal a level.
struct KernelVolume {
  enum class Draw { isosurface, cubes };
  std::string of, show;  ///< member or channel that is compared with the level; if empty, the first number
  Draw draw = Draw::isosurface;
  scene::Animated<float> level = 0.5F;
  std::string color;  ///< member or channel that selects the colour from the colour map; if empty, the
                      ///< surface has the material's colour
  std::string map = "inferno";
  glm::vec2 colorRange{0, 1};
  glm::vec3 position{0};  ///< centre of the volume in metres
  float width = 2;        ///< width along x in metres; cells are cubes
  bool closed = true;     ///< true to close the surface where it meets the border of the volume
};

/// Velocities in a plane of the world that act as wind on other objects.
struct KernelWind {
  std::string of,
      velocity;      ///< member with at least two numbers; if empty, the first two channels, or the element
  float scale = 1;   ///< velocity in m/s that the value 1 stands for
  float speed = 10;  ///< expected maximum speed in m/s
  FluidPlane plane;
};

/// Statistic over a buffer member, for checks and charts.
struct KernelMeasure {
  enum class What { mean, sum, min, max };
  std::string name, of, member;
  What what = What::mean;
};

/// Description of a user's shaders, their memory and their schedule, as given by a scene.
struct KernelDescription {
  std::filesystem::path file;
  scene::Formula keywords;
  std::vector<KernelMemory> buffers, textures;
  scene::Formulas constants;
  std::vector<KernelConstantFile> constantFiles;
  int steps = 1;  ///< number of steps per frame
  std::vector<KernelEntry> first, step;
  /// Reaction to out-of-bounds accesses: stop ends the run, ignore reports the first access and continues,
  /// silent compiles no code that detects them.
  enum class Bounds { stop, ignore, silent };
  Bounds bounds = Bounds::stop;
  /// Reaction to drawn numbers that are NaN or infinite.
  enum class NonFinite { stop, warn, ignore };
  NonFinite nonFinite = NonFinite::warn;
  int iterations = 65000;  ///< maximum number of iterations of a loop; 0 for no limit
  bool fast = false;
  std::optional<KernelSurface> surface;
  std::optional<KernelPoints> points;
  std::optional<KernelField> field;
  FieldDisplay::Fit defaultFit = FieldDisplay::Fit::cover;  ///< fit of the field that is drawn by default
  std::optional<KernelTerrain> terrain;
  std::optional<KernelVolume> volume;
  std::optional<KernelWind> wind;
  std::vector<KernelMeasure> measured;
};

}  // namespace simreel::sim
