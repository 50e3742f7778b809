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

/// How cloth of a mesh bends from some substep on: seams that have pulled shut bend as the cloth does.
struct GarmentBending {
  int from = 0;                     ///< substeps since the start
  std::vector<glm::uvec4> entries;  ///< two a pair: a vertex, N/m
  std::vector<glm::uvec4> fans;  ///< of each vertex: first ring, how many, first pair of entries, how many
};

/// What the kernels of cloth of a mesh read and never write (glsl/garment).
struct GarmentArrays {
  std::vector<glm::uvec4> corners;  ///< of each face, colour by colour: three vertices
  std::vector<int> colours;         ///< first face of each colour, and their number
  std::vector<glm::vec4> elements;  ///< two a face: p, q, r, s; compliances of weft, warp and shear (m/N)
  std::vector<glm::uvec4> rings;    ///< a face around a vertex: the two others, the face
  std::vector<GarmentBending> bendings;  ///< by their start, the first from 0 on
  std::vector<glm::uvec4> stitches;      ///< colour by colour: two vertices, m apart at the start, 1/s
  std::vector<int> stitchColours;        ///< as of faces
  std::vector<glm::uvec4> attachments;   ///< a vertex, a pin, m, m/N
  std::vector<glm::uvec4> copies;        ///< of each drawn vertex: x its vertex
};

/// Fraction of a triangle's height that contact may keep around it.
inline constexpr double roomOfHeight = 0.35;

/// Everything of cloth made of triangles that is decided on the CPU, as ClothPlan for grids; shared by the
/// GPU simulation and its CPU twin.
class GarmentPlan {
 public:
  /// Reads the mesh. Throws what ClothPlan and ClothTriangles throw, what the mesh's reader does, and
  /// UserError(usage) for pins that hold nothing, or pins or seams of no vertex. Warns where the given
  /// substeps are too few.
  /// `boneNamed`, `startTime`: as of ClothPlan.
  using BoneNamed = std::function<Carrier(const std::string& body, const std::string& bone)>;
  GarmentPlan(const std::string& name, const ClothParameters& parameters, int seed, double frameSeconds,
              const std::vector<ColliderShape>& colliders, const BoneNamed& boneNamed = {},
              double startTime = 0, const HeldBySkin& heldBySkin = {});

  /// xyz in m, w inverse mass in 1/kg (0: pinned): the vertices, then the ghosts of clamped edges, which
  /// are pinned.
  [[nodiscard]] std::vector<glm::vec4> firstPositions() const;
  /// xyz in m/s (zero), w the pin group of a pinned vertex.
  [[nodiscard]] std::vector<glm::vec4> firstVelocities() const;
  /// xyz: of what is pinned where pins carry it from (m), else zero (m/s; glsl/cloth/motion.glsl).
  [[nodiscard]] std::vector<glm::vec4> firstTrends() const;
  /// With the ghosts.
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
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }  ///< as drawn
  [[nodiscard]] const ClothTriangles& cloth() const { return cloth_; }
  [[nodiscard]] const std::vector<MembraneElement>& membrane() const { return membrane_; }
  /// As of the next substep.
  [[nodiscard]] const std::vector<PlateElement>& plate() const {
    return plates_[bendingAt(steps_.stepsBegun())];
  }
  /// Which of the bendings holds in the substep of that number since the start.
  [[nodiscard]] std::size_t bendingAt(int substep) const;
  /// m, of each vertex the most that contact may keep around it, so that a triangle does not touch its
  /// neighbours: roomOfHeight of the least height of a triangle there.
  [[nodiscard]] std::vector<float> contactRooms() const;
  [[nodiscard]] const std::vector<double>& masses() const { return masses_; }  ///< kg, the pinned included

 private:
  GarmentPlan(const std::string& name, const ClothParameters& parameters, int seed, double frameSeconds,
              const std::vector<ColliderShape>& colliders, const BoneNamed& boneNamed, double startTime,
              const HeldBySkin& heldBySkin, Mesh mesh);
  /// Places and pins the vertices, makes the rows of bending. Returns the parameters with the substeps that
  /// "auto" comes to.
  [[nodiscard]] ClothParameters settled(const std::string& name, ClothParameters parameters,
                                        double frameSeconds, const std::vector<ColliderShape>& colliders);
  void place(const ClothParameters& parameters);
  void pin(const std::string& name, const ClothParameters& parameters);
  /// Of a vertex that `what` of the scene names by its number in the mesh.
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
  std::vector<std::vector<PlateElement>> plates_;  ///< of each bending
  std::vector<double> masses_;
  std::vector<glm::vec3> rest_;  ///< m, world, of vertices and ghosts
  std::vector<int> groups_;      ///< of each of them: the pin group; -1: free
  std::vector<ClampedEdge> clamps_;
  /// Stitches by the seconds until they are shut.
  std::map<double, std::vector<std::pair<unsigned, unsigned>>> shut_;
  GarmentArrays arrays_;
  ClothPlan steps_;
  SkinPins skinPins_;
};

}  // namespace simreel::sim
