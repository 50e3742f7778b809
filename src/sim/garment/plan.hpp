#pragma once
#include "sim/cloth/plan.hpp"
#include "sim/garment/membrane.hpp"
#include "sim/garment/plate.hpp"
#include "sim/garment/triangles.hpp"

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Bending stiffness of a mesh cloth from a substep on. It changes when a seam closes, because a closed
/// seam bends like the cloth.
struct GarmentBending {
  int from = 0;                     ///< number of substeps since the start
  std::vector<glm::uvec4> entries;  ///< two entries per element: each a vertex and a stiffness in N/m
  std::vector<glm::uvec4> fans;  ///< per vertex: first ring, ring count, first entry element, element count
};

/// Constant input arrays of the mesh cloth kernels (glsl/garment).
struct GarmentArrays {
  std::vector<glm::uvec4> corners;  ///< per face, sorted by colour: three vertices
  std::vector<int> colours;         ///< first face of each colour, then the number of faces
  std::vector<glm::vec4> elements;  ///< two elements per face: p, q, r, s; then 1 / (k A) of weft, warp and
                                    ///< shear, or k A if energy is kept
  std::vector<glm::uvec4> rings;    ///< one element per face around a vertex: the two other corners, the
                                    ///< face, the vertex' place in the face
  std::vector<GarmentBending> bendings;  ///< sorted by start; the first starts at 0
  std::vector<glm::uvec4> stitches;      ///< sorted by colour: two vertices, their initial distance in m,
                                         ///< the closing rate in 1/s
  std::vector<int> stitchColours;        ///< first stitch of each colour, then the number of stitches
  std::vector<glm::uvec4> attachments;   ///< vertex, pin, length in m, compliance in m/N
  std::vector<glm::uvec4> copies;        ///< per drawn vertex: x is its vertex in the cloth
};

/// Maximum contact distance around a triangle, as a fraction of its height.
inline constexpr double roomOfHeight = 0.35;

/// Everything about a triangle cloth that the CPU decides; the counterpart of ClothPlan for grids. The GPU
/// simulation and its CPU reference share it.
class GarmentPlan {
 public:
  /// Reads the mesh. Throws the errors of ClothPlan, ClothTriangles and the mesh's reader, and
  /// UserError(usage) for pins that hold no vertex and for pins or seams with an invalid vertex. Warns if
  /// the given substeps are too few. `boneNamed`, `startTime`: see ClothPlan.
  using BoneNamed = std::function<Carrier(const std::string& body, const std::string& bone)>;
  GarmentPlan(const std::string& name, const ClothParameters& parameters, int seed, double frameSeconds,
              const std::vector<ColliderShape>& colliders, const BoneNamed& boneNamed = {},
              double startTime = 0, const HeldBySkin& heldBySkin = {});

  /// Returns xyz the position in m, w the inverse mass in 1/kg (0: pinned): first the vertices, then the
  /// ghosts of clamped edges, which are pinned.
  [[nodiscard]] std::vector<glm::vec4> firstPositions() const;
  /// Returns xyz the velocity in m/s (zero), w the pin group of a pinned vertex.
  [[nodiscard]] std::vector<glm::vec4> firstVelocities() const;
  /// Returns in xyz, for a pinned vertex, the rest position in m that its pins carry; for others zero (a
  /// trend in m/s, glsl/cloth/motion.glsl).
  [[nodiscard]] std::vector<glm::vec4> firstTrends() const;
  /// Returns the number of vertices including ghosts.
  [[nodiscard]] std::size_t vertexCount() const { return rest_.size(); }
  [[nodiscard]] std::vector<shader::ClothStep> frame(double time) { return steps_.frame(time); }
  void carryOver(CarryOver& carry) { steps_.carryOver(carry); }

  [[nodiscard]] const ClothParameters& parameters() const { return steps_.parameters(); }
  [[nodiscard]] int substeps() const { return steps_.substeps(); }
  [[nodiscard]] double substepSeconds() const { return steps_.substepSeconds(); }
  [[nodiscard]] int stepsBegun() const { return steps_.stepsBegun(); }
  [[nodiscard]] const SkinPins& skinPins() const { return skinPins_; }
  [[nodiscard]] int colliderCount() const { return steps_.colliderCount(); }
  [[nodiscard]] int thinCount() const { return steps_.thinCount(); }
  [[nodiscard]] const GarmentArrays& arrays() const { return arrays_; }
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }  ///< mesh as it is drawn
  [[nodiscard]] const ClothTriangles& cloth() const { return cloth_; }
  [[nodiscard]] const std::vector<MembraneElement>& membrane() const { return membrane_; }
  /// Returns the plate elements in effect in the next substep.
  [[nodiscard]] const std::vector<PlateElement>& plate() const {
    return plates_[bendingAt(steps_.stepsBegun())];
  }
  /// Returns the index of the bending in effect in substep number `substep` since the start.
  [[nodiscard]] std::size_t bendingAt(int substep) const;
  /// Returns for each vertex the maximum contact distance in metres at which a triangle does not touch its
  /// neighbours: roomOfHeight times the smallest height of the triangles around the vertex.
  [[nodiscard]] std::vector<float> contactRooms() const;
  [[nodiscard]] const std::vector<double>& masses() const { return masses_; }  ///< kg; pinned ones included

 private:
  GarmentPlan(const std::string& name, const ClothParameters& parameters, int seed, double frameSeconds,
              const std::vector<ColliderShape>& colliders, const BoneNamed& boneNamed, double startTime,
              const HeldBySkin& heldBySkin, Mesh mesh);
  /// Places and pins the vertices and computes the bending rows. Returns the parameters with the number of
  /// substeps that "auto" chooses.
  [[nodiscard]] ClothParameters settled(const std::string& name, ClothParameters parameters,
                                        double frameSeconds, const std::vector<ColliderShape>& colliders);
  void place(const ClothParameters& parameters);
  void pin(const std::string& name, const ClothParameters& parameters);
  /// Returns the vertex for an index into the mesh; `what` names its place in the scene for error messages.
  [[nodiscard]] unsigned vertexNamed(const std::string& name, const std::string& what, int number) const;
  void pinGroup(const std::string& name, const PinGroup& group, int number);
  void clamp(const std::string& name, const ClothParameters& parameters);
  void bend(const std::string& name, const ClothParameters& parameters, double seconds, bool given);
  [[nodiscard]] std::vector<double> inverseMasses() const;
  void sew(const std::string& name, const ClothParameters& parameters);
  void makeArrays();

  int seed_;
  Mesh mesh_;
  ClothTriangles cloth_;
  std::vector<MembraneElement> membrane_;
  std::vector<std::vector<PlateElement>> plates_;  ///< one vector per bending
  std::vector<double> masses_;
  std::vector<glm::vec3> rest_;  ///< positions in metres, world space: vertices, then ghosts
  std::vector<int> groups_;      ///< pin group of each vertex and ghost; -1: not pinned
  std::vector<ClampedEdge> clamps_;
  /// Vertex pairs sewn together, by the seconds until their seam is closed.
  std::map<double, std::vector<std::pair<unsigned, unsigned>>> shut_;
  GarmentArrays arrays_;
  ClothPlan steps_;
  SkinPins skinPins_;
};

}  // namespace simreel::sim
