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

/// Bending stiffness of a mesh cloth, valid from a given substep on. It changes when a seam closes, because
/// the cloth then also bends across the seam.
struct GarmentBending {
  int from = 0;                     ///< number of substeps since the start of the run
  std::vector<glm::uvec4> entries;  ///< two entries per element; an entry is a vertex and a stiffness in
                                    ///< N/m
  std::vector<glm::uvec4> fans;     ///< for each vertex: index of its first ring, number of rings, index of
                                    ///< its first element of `entries`, number of elements
};

/// Constant input arrays of the mesh cloth kernels (glsl/garment).
struct GarmentArrays {
  std::vector<glm::uvec4> corners;  ///< three vertices of each face; the faces are sorted by colour
  std::vector<int> colours;         ///< index of the first face of each colour, followed by the number of
                                    ///< faces
  std::vector<glm::vec4> elements;  ///< two elements per face: p, q, r, s; then 1 / (k A) of weft, warp and
                                    ///< shear, or k A if energy is kept (stiffness k, area A)
  std::vector<glm::uvec4> rings;    ///< one element for each face around a vertex: the other two corners,
                                    ///< the face, and which corner of the face the vertex is
  std::vector<GarmentBending> bendings;  ///< bendings in the order of `from`; the first has `from` = 0
  std::vector<glm::uvec4> stitches;      ///< stitches sorted by colour: two vertices, their initial
                                         ///< distance in metres, the closing rate in 1/s
  std::vector<int> stitchColours;        ///< index of the first stitch of each colour, followed by the
                                         ///< number of stitches
  std::vector<glm::uvec4> attachments;   ///< per attachment: vertex, pin, length in metres, compliance in
                                         ///< m/N
  std::vector<glm::uvec4> copies;        ///< for each drawn vertex: x is the index of its cloth vertex
};

/// Maximum contact distance of a triangle, as a fraction of the triangle's height.
inline constexpr double roomOfHeight = 0.35;

/// The part of a triangle cloth that the CPU computes, like ClothPlan for grids. The GPU simulation and its
/// CPU reference both use it.
class GarmentPlan {
 public:
  /// Reads the mesh. Throws the errors of ClothPlan, ClothTriangles and the mesh's reader, and
  /// UserError(usage) for pins that hold no vertex and for pins or seams with an invalid vertex. Warns if
  /// the given number of substeps is too small. For `boneNamed` and `startTime`, see ClothPlan.
  using BoneNamed = std::function<Carrier(const std::string& body, const std::string& bone)>;
  GarmentPlan(const std::string& name, const ClothParameters& parameters, int seed, double frameSeconds,
              const std::vector<ColliderShape>& colliders, const BoneNamed& boneNamed = {},
              double startTime = 0, const HeldBySkin& heldBySkin = {});

  /// Returns for each vertex, and then for each ghost point of a clamped edge: xyz the position in metres,
  /// w the inverse mass in 1/kg (0 if pinned). Ghost points are pinned.
  [[nodiscard]] std::vector<glm::vec4> firstPositions() const;
  /// Returns for each vertex: xyz the velocity in m/s (zero), w the pin group of a pinned vertex.
  [[nodiscard]] std::vector<glm::vec4> firstVelocities() const;
  /// Returns in xyz for a pinned vertex its rest position in metres, which its pins move; for other
  /// vertices zero (a trend in m/s, glsl/cloth/motion.glsl).
  [[nodiscard]] std::vector<glm::vec4> firstTrends() const;
  /// Returns the number of vertices, including ghost points.
  [[nodiscard]] std::size_t vertexCount() const { return rest_.size(); }
  [[nodiscard]] std::vector<shader::ClothStep> frame(double time) { return steps_.frame(time); }
  void visitCheckpointData(CarryOver& carry) { steps_.visitCheckpointData(carry); }

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
  /// Returns the plate elements that apply in the next substep.
  [[nodiscard]] const std::vector<PlateElement>& plate() const {
    return plates_[bendingAt(steps_.stepsBegun())];
  }
  /// Returns the index of the bending that applies in substep number `substep` since the start of the run.
  [[nodiscard]] std::size_t bendingAt(int substep) const;
  /// Returns for each vertex the maximum contact distance in metres at which a triangle does not touch its
  /// neighbours: roomOfHeight times the smallest height of the triangles around the vertex.
  [[nodiscard]] std::vector<float> contactRooms() const;
  [[nodiscard]] const std::vector<double>& masses() const {
    return masses_;
  }  ///< Returns the masses in kg. Pinned vertices have a mass, too.

 private:
  GarmentPlan(const std::string& name, const ClothParameters& parameters, int seed, double frameSeconds,
              const std::vector<ColliderShape>& colliders, const BoneNamed& boneNamed, double startTime,
              const HeldBySkin& heldBySkin, Mesh mesh);
  /// Places and pins the vertices and computes the rows of the bending matrix. Returns the parameters with
  /// the number of substeps that "auto" chooses.
  [[nodiscard]] ClothParameters settled(const std::string& name, ClothParameters parameters,
                                        double frameSeconds, const std::vector<ColliderShape>& colliders);
  void place(const ClothParameters& parameters);
  void pin(const std::string& name, const ClothParameters& parameters);
  /// Returns the cloth vertex for a vertex index of the mesh. `what` is the JSON path of the index for
  /// error messages.
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
  std::vector<glm::vec3> rest_;  ///< rest positions in world space, in metres: first the vertices, then the
                                 ///< ghost points
  std::vector<int> groups_;      ///< pin group of each vertex and ghost point, or -1 if not pinned
  std::vector<ClampedEdge> clamps_;
  /// Pairs of vertices that are sewn together; the key is the time in seconds until their seam is closed.
  std::map<double, std::vector<std::pair<unsigned, unsigned>>> seamPairs_;
  GarmentArrays arrays_;
  ClothPlan steps_;
  SkinPins skinPins_;
};

}  // namespace simreel::sim
