#pragma once
#include "scene/value/fields.hpp"
#include "sim/core/kind.hpp"
#include "sim/grid/field_display.hpp"
#include "sim/grid/strokes.hpp"
#include "sim/mesh/file/mesh_file.hpp"
#include "sim/ports/field_source.hpp"
#include "sim/reaction/rule/evaluate.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

struct ReactionSpecies {
  std::string name;
  scene::Animated<float> diffusion = 0.0F;  ///< D of D lap(u), lengths^2 per unit of time
  std::string rate = "0";                   ///< the rest of du/dt
  std::string start = "0";                  ///< in the first state
  std::string next;                         ///< what it becomes in a step, instead of a rate
  double edge = 0;                          ///< beyond edges that are fixed
};

struct ReactionParameter {
  std::string name;
  scene::Animated<float> value = 0.0F;
  std::optional<double> across, down;  ///< value at the right, or at the bottom edge
  std::filesystem::path image;         ///< share of the way to `white`
  double white = 1;
  std::string field;       ///< another object's, whose values it has
  bool isPresets = false;  ///< so that expressions may do without it

  [[nodiscard]] bool isMapped() const { return across || down || !image.empty(); }
};

struct ReactionLet {
  std::string name, is = "0";
};

struct ReactionStroke : StrokeParameters {
  std::string species;  ///< empty: the first
};

/// How a volume is drawn: where what is shown passes a level, or its cells from that level on.
struct ReactionSurface {
  enum class Draw { isosurface, cubes };
  Draw draw = Draw::isosurface;
  std::optional<scene::Animated<float>> level;  ///< else it is the middle of the display's range
  std::string color;                            ///< an expression; empty: the material's colour
  glm::vec3 position{0};                        ///< m: middle of the volume
  float width = 2;                              ///< m: of the volume, along x
  bool closed = true;
  void describe(scene::Fields& fields);
};

/// A mesh whose vertices are the cells.
struct ReactionMesh {
  enum class Shape { file, plane, sphere, torus };
  enum class Maps { texture, front, top };
  Shape shape = Shape::file;
  std::filesystem::path file;
  glm::vec3 size{4, 0, 4};         ///< m, of a plane
  float radius = 1, tube = 0.35F;  ///< m
  glm::ivec2 resolution{129, 65};  ///< vertices along u and v
  int refine = 0;                  ///< times that each face becomes four
  std::optional<Maps> maps;        ///< else by texture coordinates if it has them, or from the front
  scene::Animated<glm::vec3> position = glm::vec3(0);  ///< m
  scene::Animated<glm::vec3> rotation = glm::vec3(0);  ///< degrees
  scene::Animated<float> scale = 1.0F;
  void describe(scene::Fields& fields);
  /// Throws what loadMesh throws.
  [[nodiscard]] Mesh make() const;
  /// Whether make() gives the same as another's, wherever both stand.
  [[nodiscard]] bool isMadeAs(const ReactionMesh& other) const;
  [[nodiscard]] glm::mat4 model(double time) const;
  [[nodiscard]] std::optional<scene::Box> framed() const;
};

/// Equations of one's own as a scene says them: du/dt = D lap(u) + rate for each species.
struct ReactionParameters : ObjectParameters, OwnCells {
  glm::ivec2 size{256, 256};  ///< cells
  int depth = 1;              ///< layers of them; more than one: a volume
  int preset = -1;
  double spacing = 1;       ///< of cells, units of length
  bool hasSpacing = false;  ///< whether the scene says so
  double dt = 0.1;          ///< units of time
  int steps = 8;            ///< per frame
  int presteps = 0;         ///< before everything
  RuleMethod method = RuleMethod::euler;
  RuleBoundary boundary = RuleBoundary::torus;
  std::vector<ReactionSpecies> species;
  std::vector<ReactionParameter> parameters;
  std::vector<ReactionLet> lets;
  std::string show;  ///< an expression; empty: the first species
  std::vector<ReactionStroke> strokes;
  FieldDisplay display;
  ReactionSurface surface;
  std::optional<ReactionMesh> mesh;

  ReactionParameters();
  void describe(scene::Fields& fields) override;
  [[nodiscard]] const char* drawnWith() const override {
    return space() == RuleSpace::plane ? "its \"display\"" : nullptr;
  }
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t leastBlockBytes() const override {
    return space() == RuleSpace::mesh ? 0 : std::int64_t{4} * size.x * size.y * depth;
  }
  /// True where parameters take values of other objects' fields.
  [[nodiscard]] bool readsFields() const;
  /// True for cells of the same mesh, and for a volume of the same proportions.
  [[nodiscard]] bool readsCellsOf(const OwnCells& other) const override;
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;

  [[nodiscard]] RuleSpace space() const {
    return mesh ? RuleSpace::mesh : depth > 1 ? RuleSpace::volume : RuleSpace::plane;
  }
  /// "256x256" or "64x64x64".
  [[nodiscard]] std::string cellsText() const;
  /// m between the cells of a volume.
  [[nodiscard]] float cellWidth() const { return surface.width / static_cast<float>(size.x); }
  [[nodiscard]] float levelAt(double time) const;
  [[nodiscard]] RuleText ruleText() const;
  /// The species that a stroke paints; -1: there is none of that name.
  [[nodiscard]] int painted(const ReactionStroke& stroke) const;

 private:
  void checkSpace(scene::Fields& fields) const;
  void checkMesh(scene::Fields& fields) const;
  void checkBrushes(scene::Fields& fields) const;
};

}  // namespace simreel::sim
