#pragma once
#include "sim/mesh_cells/cells.hpp"
#include "sim/reaction/brushes.hpp"
#include "sim/reaction/parameters.hpp"

#include <string>
#include <vector>

namespace simreel::sim {

/// Everything of a rule that is decided on the CPU: its program, the first state, maps, and what steps are
/// told. Shared by the GPU simulation and its CPU twin.
class ReactionPlan {
 public:
  /// Warns of steps that are too long for the diffusion. On a mesh, `size` becomes one row of its cells.
  /// Throws UserError for a mesh that cannot be read.
  ReactionPlan(ReactionParameters parameters, const std::string& object, int seed, double frameSeconds);
  /// Whether it warned of that.
  [[nodiscard]] bool diffusesTooFast() const { return tooFast_; }
  /// Reads the pictures that the parameters name. Throws UserError: what loadPicture says.
  void checkPictures() const;

  /// Takes over the values of parameters. False: they are not the same ones, or vary in space otherwise.
  [[nodiscard]] bool retune(const ReactionParameters& now);

  [[nodiscard]] const ReactionParameters& parameters() const { return parameters_; }
  [[nodiscard]] const Rule& rule() const { return rule_; }
  [[nodiscard]] const RuleProgram& program() const { return program_; }
  /// Of a plane.
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }
  /// Of a mesh; null: there is none.
  [[nodiscard]] const RuleLinks* links() const { return onMesh_ ? &links_ : nullptr; }
  /// Of the cells of a mesh on other objects' fields; empty on grids.
  [[nodiscard]] const std::vector<glm::ivec2>& places() const { return places_; }
  /// The mesh, and its cells.
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const MeshCells& cells() const { return cells_; }
  [[nodiscard]] unsigned noiseSeed() const { return static_cast<unsigned>(seed_) * 2246822519U; }
  /// Of each species beyond fixed edges.
  [[nodiscard]] std::vector<float> edges() const;

  /// A field with the first state in `stage`, room in all others, and the maps.
  [[nodiscard]] RuleField firstField() const;
  /// What ToldPlaces names, in the frame that starts at `time` (s); the model's own time is 0.
  [[nodiscard]] std::vector<float> valuesAt(double time) const;
  /// Steps of time up to `time` (s) of the scene, from its second 0.
  [[nodiscard]] long stepAt(double time) const;
  /// The model's time (units of time) at a step and `later`, a share of one; `first`: the number of the
  /// first state, before the presteps.
  [[nodiscard]] float modelTime(long step, long first, double later) const;
  struct Painted {
    shader::Stroke stroke;
    int species;
    Brush brush;  ///< of a volume, in cells, or a mesh, as ReactionPlan::firstField has its cells' places
  };
  /// Strokes that paint into the state after `step` steps of the frame that starts at `time` (s).
  [[nodiscard]] std::vector<Painted> strokesAt(double time, int step) const;

 private:
  void warnOfSteps(const std::string& object);
  void checkBrushes(const std::string& object) const;
  [[nodiscard]] bool reaches(const Brush& brush) const;
  [[nodiscard]] std::vector<Painted> brushesAt(double now, double seconds) const;
  [[nodiscard]] Brush onMesh(StrokeWay way, float radius, double from, double to) const;
  void readMesh(const std::string& object);
  [[nodiscard]] std::vector<float> placesAlong(int axis) const;
  [[nodiscard]] std::vector<float> weightsOf(const ReactionParameter& parameter) const;

  ReactionParameters parameters_;
  bool onMesh_ = false, tooFast_ = false;
  Mesh mesh_;
  MeshCells cells_;
  RuleLinks links_;
  std::vector<glm::ivec2> places_;
  double perMetre_ = 1;  ///< units of length, on a mesh
  int seed_;
  double frameSeconds_;
  Rule rule_;
  RuleProgram program_;
  Strokes strokes_;
};

/// A step of the CPU twin: `number` of the step, `first`: that of the first state; `values` from
/// ReactionPlan::valuesAt.
void evaluateStep(const ReactionPlan& plan, std::vector<float> values, long number, long first,
                  RuleField& field);
/// A stroke in a volume or on a mesh.
void evaluateBrush(const ReactionPlan::Painted& painted, RuleField& field);
/// What is shown of the state in field.stage, which step `number` begins with.
[[nodiscard]] std::vector<float> evaluateShown(const ReactionPlan& plan, std::vector<float> values,
                                               long number, long first, RuleField& field);

}  // namespace simreel::sim
