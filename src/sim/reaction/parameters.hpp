#pragma once
#include "scene/fitted.hpp"
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
  scene::Animated<float> diffusion = 0.0F;  ///< Diffusion coefficient D of the term D lap(u), in squared
                                            ///< lengths per unit of time.
  std::string rate = "0";                   ///< Expression for du/dt without the diffusion term.
  std::string start = "0";                  ///< Expression for the initial state.
  std::string next;  ///< Expression for the value after a step; used instead of a rate.
  double edge = 0;   ///< Value of the species beyond edges of the kind "fixed".
};

struct ReactionParameter {
  std::string name;
  scene::Animated<float> value = 0.0F;
  std::optional<double> across,
      down;  ///< Values of the parameter at the right edge (`across`) and at the bottom edge (`down`).
  std::filesystem::path image;  ///< Image whose brightness interpolates from `value` (black) to `white`.
  double white = 1;
  std::string field;       ///< Name of another object's field that supplies the values.
  bool isPresets = false;  ///< True if a preset defines the parameter. Such a parameter need not occur in
                           ///< the expressions.

  [[nodiscard]] bool isMapped() const { return across || down || !image.empty(); }
};

struct ReactionLet {
  std::string name, is = "0";
};

struct ReactionStroke : StrokeParameters {
  std::string species;  ///< Species to paint; if empty, the first species.
};

/// Display of a volume: the isosurface at a level, or the cells at or above the level.
struct ReactionSurface {
  enum class Draw { isosurface, cubes };
  Draw draw = Draw::isosurface;
  std::optional<scene::Animated<float>>
      level;              ///< Level of the isosurface; if empty, the middle of the display's range.
  std::string color;      ///< Expression whose value selects the surface's colour from the colour map; if
                          ///< empty, the material's colour is used.
  glm::vec3 position{0};  ///< Centre of the volume in metres.
  float width = 2;        ///< Width of the volume along x in metres.
  bool closed = true;
  void describe(scene::Fields& fields);
};

/// Mesh whose vertices are the cells of the reaction.
struct ReactionMesh {
  enum class Shape { file, plane, sphere, torus };
  enum class Maps { texture, front, top };
  Shape shape = Shape::file;
  std::filesystem::path file;
  glm::vec3 size{4, 0, 4};         ///< Size of a plane in metres.
  float radius = 1, tube = 0.35F;  ///< Radii of a sphere or torus in metres.
  glm::ivec2 resolution{129, 65};  ///< Number of vertices along u and v.
  int refine = 0;                  ///< Number of subdivisions; each subdivision splits every face into
                                   ///< four.
  std::optional<Maps> maps;  ///< Mapping of images and fields to the mesh; if empty, texture coordinates if
                             ///< the mesh has any, otherwise a projection from the front.
  scene::Animated<glm::vec3> position = glm::vec3(0);  ///< Position of the mesh in metres.
  scene::Animated<glm::vec3> rotation = glm::vec3(0);  ///< Rotation of the mesh in degrees.
  scene::Animated<float> scale = 1.0F;
  void describe(scene::Fields& fields);
  /// Loads or generates the mesh. Throws the errors of loadMesh.
  [[nodiscard]] Mesh make() const;
  /// Returns true if make() gives the same mesh as `other`, regardless of position, rotation and scale.
  [[nodiscard]] bool isMadeAs(const ReactionMesh& other) const;
  [[nodiscard]] glm::mat4 model(double time) const;
  [[nodiscard]] std::optional<scene::Box> framed() const;
};

/// Scene parameters of user-defined equations: du/dt = D lap(u) + rate for each species.
struct ReactionParameters : ObjectParameters, HasColorRange, OwnCells, scene::Covering, scene::Fitted {
  glm::ivec2 size{256, 256};  ///< Grid size in cells.
  int depth = 1;              ///< Number of layers; more than one makes a volume.
  int preset = -1;
  double spacing = 1;       ///< Distance between cells in units of length.
  bool hasSpacing = false;  ///< True if the scene sets `spacing`.
  double dt = 0.1;          ///< Time step in units of time.
  int steps = 8;            ///< Number of steps per frame.
  int presteps = 0;         ///< Number of steps before the first frame.
  RuleMethod method = RuleMethod::euler;
  RuleBoundary boundary = RuleBoundary::torus;
  std::vector<ReactionSpecies> species;
  std::vector<ReactionParameter> parameters;
  std::vector<ReactionLet> lets;
  std::string show;  ///< Expression to display; if empty, the first species.
  std::vector<ReactionStroke> strokes;
  FieldDisplay display;
  ReactionSurface surface;
  std::optional<ReactionMesh> mesh;

  ReactionParameters();
  void describe(scene::Fields& fields) override;
  void fitPicture(glm::ivec2 picture) override {
    if (space() == RuleSpace::plane) size = display.fittedGrid(size, picture);
  }
  [[nodiscard]] std::vector<MeasuredRange> measuredRanges() override { return display.measuredRanges(); }
  [[nodiscard]] const char* drawnWith() const override {
    return space() == RuleSpace::plane ? "its \"display\"" : nullptr;
  }
  void leaveRoom(glm::vec2 room) override { display.room = room; }
  [[nodiscard]] Extent covering() const override {
    return space() == RuleSpace::plane ? display.covering() : Extent::none;
  }
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t minLargestBufferBytes() const override {
    return space() == RuleSpace::mesh ? 0 : std::int64_t{4} * size.x * size.y * depth;
  }
  void useStandardPreset(scene::Fields& fields);
  /// Returns true if a parameter takes its values from another object's field.
  [[nodiscard]] bool readsFields() const;
  /// Returns true if fields of `other` can be read cell by cell: `other` has the same mesh, or is a volume
  /// of the same proportions.
  [[nodiscard]] bool readsCellsOf(const OwnCells& other) const override;
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;

  [[nodiscard]] RuleSpace space() const {
    return mesh ? RuleSpace::mesh : depth > 1 ? RuleSpace::volume : RuleSpace::plane;
  }
  /// Returns the size as text: "256x256" or "64x64x64".
  [[nodiscard]] std::string cellsText() const;
  /// Returns the distance in metres between neighbouring cells of a volume.
  [[nodiscard]] float cellWidth() const { return surface.width / static_cast<float>(size.x); }
  [[nodiscard]] float levelAt(double time) const;
  [[nodiscard]] RuleText ruleText() const;
  /// Returns the index of the species that a stroke paints, or -1 if no species has the given name.
  [[nodiscard]] int painted(const ReactionStroke& stroke) const;

 private:
  void checkSpace(scene::Fields& fields) const;
  void checkMesh(scene::Fields& fields) const;
  void checkBrushes(scene::Fields& fields) const;
};

}  // namespace simreel::sim
