#pragma once
#include "sim/mesh_cells/cells.hpp"
#include "sim/reaction/brushes.hpp"
#include "sim/reaction/parameters.hpp"

#include <string>
#include <vector>

namespace simreel::sim {

/// CPU-side setup of a rule: its program, the initial state, maps, and step parameters. Used by the GPU
/// simulation and by its CPU twin.
class ReactionPlan {
 public:
  /// Warns if the steps are too long for the diffusion. On a mesh, sets `size` to one row with all cells.
  /// Throws UserError if the mesh cannot be read.
  ReactionPlan(ReactionParameters parameters, const std::string& object, int seed, double frameSeconds);
  /// Returns true if the constructor warned that steps are too long for the diffusion.
  [[nodiscard]] bool diffusesTooFast() const { return tooFast_; }
  /// Reads the images that the parameters name, to detect errors. Throws the errors of loadPicture.
  void checkPictures() const;

  /// Adopts new parameter values. Returns false if the set of parameters differs, or if a parameter varies
  /// differently in space.
  [[nodiscard]] bool retune(const ReactionParameters& now);

  [[nodiscard]] const ReactionParameters& parameters() const { return parameters_; }
  [[nodiscard]] const Rule& rule() const { return rule_; }
  [[nodiscard]] const RuleProgram& program() const { return program_; }
  /// Returns the strokes of a plane.
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }
  /// Returns the links between a mesh's cells; null on grids.
  [[nodiscard]] const RuleLinks* links() const { return onMesh_ ? &links_ : nullptr; }
  /// Returns the positions of a mesh's cells on other objects' fields; empty on grids.
  [[nodiscard]] const std::vector<glm::ivec2>& places() const { return places_; }
  /// mesh() returns the mesh, and cells() returns the cells on it.
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const MeshCells& cells() const { return cells_; }
  [[nodiscard]] unsigned noiseSeed() const { return static_cast<unsigned>(seed_) * 2246822519U; }
  /// Returns the value of each species beyond edges of the kind "fixed".
  [[nodiscard]] std::vector<float> edges() const;

  /// Returns a field with the initial state in `stage`, allocated memory in all other arrays, and the maps.
  [[nodiscard]] RuleField firstField() const;
  /// Returns the values listed in UniformIndex for the frame that starts at `time` (seconds). The model's
  /// time among them is 0.
  [[nodiscard]] std::vector<float> valuesAt(double time) const;
  /// Returns the number of steps from scene time 0 to `time` (seconds).
  [[nodiscard]] long stepAt(double time) const;
  /// Returns the model's time, in units of time, at a moment within the step that follows step `step`.
  /// `later` is the part of that step that has passed, as a fraction. `first` is the step number of the
  /// initial state, before the presteps.
  [[nodiscard]] float modelTime(long step, long first, double later) const;
  struct Painted {
    shader::Stroke stroke;
    int species;
    Brush brush;  ///< Brush in a volume (in cells) or on a mesh (in the cell coordinates of firstField()).
  };
  /// Returns the strokes that paint into the state after `step` steps of the frame that starts at `time`
  /// (seconds).
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
  double perMetre_ = 1;  ///< Number of units of length per metre, on a mesh.
  int seed_;
  double frameSeconds_;
  Rule rule_;
  RuleProgram program_;
  Strokes strokes_;
};

/// Computes a step of the CPU twin. `number` is the number of the step, `first` the step number of the
/// initial state; `values` is the result of ReactionPlan::valuesAt.
void evaluateStep(const ReactionPlan& plan, std::vector<float> values, long number, long first,
                  RuleField& field);
/// Applies a stroke in a volume or on a mesh.
void evaluateBrush(const ReactionPlan::Painted& painted, RuleField& field);
/// Returns the displayed values of the state in field.stage, which is the state before step `number`.
[[nodiscard]] std::vector<float> evaluateShown(const ReactionPlan& plan, std::vector<float> values,
                                               long number, long first, RuleField& field);

}  // namespace simreel::sim
