#pragma once
#include "base/error.hpp"
#include "kernels/kernels.hpp"
#include "scene/value/formula.hpp"
#include "sim/core/drawable.hpp"
#include "sim/core/kind.hpp"
#include "sim/grid/field_display.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

class KernelPlan;

/// Buffer or texture of a user's kernels, as a scene describes it.
struct KernelMemory {
  std::string name;
  scene::Formula size;    ///< elements or texels along one to three axes; empty: of the file, or one
  scene::Formulas start;  ///< first values by member; what is not named is zero
  std::filesystem::path file;
  bool previous = false;  ///< kernels read it as it was before their dispatch
  bool upward = false;    ///< the first row of its file is the last one of the texture
  double counter = 0;     ///< of append and consume buffers
  // Of textures.
  std::string format;  ///< as GLSL names it; empty: the shader's, or of 32 bits a channel
  enum class Filter { shader, point, linear };
  enum class Wrap { shader, repeat, clamp, mirror };
  Filter filter = Filter::shader;
  Wrap wrap = Wrap::shader;
};

/// Entry of a schedule: a dispatch, or what happens between dispatches.
struct KernelEntry {
  std::string kernel;
  scene::Formula threads;  ///< invocations along each axis; empty: by what the kernel writes
  int repeat = 1, every = 1;
  std::string indirect;     ///< buffer that holds the numbers of work groups
  int offset = 0;           ///< bytes, of `indirect` or `into`
  scene::Formula swap;      ///< two names, exchanged after the kernel
  std::string clear;        ///< buffer or texture that becomes zero
  std::string count, into;  ///< copies the counter of one buffer into another
};

/// Triangles whose vertices are elements of a buffer.
struct KernelSurface {
  std::string of, position = "position", normal;
  glm::ivec2 grid{0, 0};       ///< vertices along x and y; 0: the buffer's size
  std::string indices;         ///< buffer of three indices a triangle
  std::filesystem::path mesh;  ///< whose triangles they are
  bool doubleSided = true;
};

/// Elements of a buffer as balls, discs or meshes.
struct KernelPoints {
  std::string of, position = "position", velocity, mass, alive;
  Instances::Shape shape = Instances::Shape::sprite;
  std::filesystem::path mesh;
  bool alongVelocity = false;
  float size = 0.05F;
  float massExponent = 0;
  Instances::ColorBy colorBy = Instances::ColorBy::material;
  glm::vec2 colorRange{0, 1};
  std::string map = "inferno";
  bool additive = false;
  float brightness = 1;
};

/// A texture or the elements of a buffer as a field over the picture.
struct KernelField {
  std::string of, show;  ///< member or component; empty: the colour of four numbers, else the first number
  bool encoded = false;  ///< colours are sRGB, as on a screen
  FieldDisplay display;
};

/// Number of a buffer's member that checks and charts may ask for.
struct KernelMeasure {
  enum class What { mean, sum, min, max };
  std::string name, of, member;
  What what = What::mean;
};

/// Shaders of a user, their memory, and when they run.
struct KernelsParameters : ObjectParameters {
  std::filesystem::path file;
  scene::Formula keywords;
  std::vector<KernelMemory> buffers, textures;
  scene::Formulas constants;
  int steps = 1;  ///< per frame
  std::vector<KernelEntry> first, step;
  bool boundsIgnored = false;
  int iterations = 65000;  ///< of a loop, at most; 0: no limit
  bool fast = false;
  std::optional<KernelSurface> surface;
  std::optional<KernelPoints> points;
  std::optional<KernelField> field;
  std::vector<KernelMeasure> measured;
  /// Made by describe() where a scene is read; null: the file cannot be compiled.
  std::shared_ptr<const KernelPlan> plan;
  kernels::Request request;  ///< that its shader was made of
  /// Message of the compiler; empty: there is none.
  std::string problem;
  bool problemIsReport = false;  ///< it says places and carets itself

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override { return quantityList; }
  [[nodiscard]] const char* drawnWith() const override;
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  [[nodiscard]] Looks looks() const override;
  [[nodiscard]] bool wanders() const override;

 protected:
  /// Makes the plan of a shader, and reports its mistakes.
  void makePlan(scene::Fields& fields, std::shared_ptr<const kernels::Shader> shader,
                const std::vector<std::string>& announced,
                const std::map<std::string, std::string>& aliases = {});
  /// Keeps the message of a compiler.
  void keepProblem(const UserError& error);

 private:
  void describeMemory(scene::Fields& fields);
  void describeDrawn(scene::Fields& fields);
  void compile(scene::Fields& fields);
  std::vector<scene::Quantity> quantityList;
};

}  // namespace simreel::sim
