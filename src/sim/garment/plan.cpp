#include "sim/garment/plan.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/garment/attachments.hpp"
#include "sim/garment/pace.hpp"
#include "sim/grid/picture_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

std::string placeOf(const std::string& name, const ClothParameters& parameters) {
  return fmt::format("cloth \"{}\" ({})", name, parameters.mesh->text());
}

std::vector<double> vertexMasses(const ClothTriangles& cloth, double density) {
  std::vector<double> masses(cloth.points.size(), 0);
  for (const ClothTriangles::Face& face : cloth.faces)
    for (const unsigned corner : face.corners) masses[corner] += density * face.area / 3;
  return masses;
}

/// Transforms a point from the mesh's local space to world space.
glm::vec3 placed(const ClothParameters& parameters, const glm::dvec3& p) {
  const glm::mat4 turn = rotationMatrix(parameters.rotation);
  glm::dvec3 place(parameters.position);
  for (int k = 0; k < 3; ++k) place += glm::dvec3(glm::vec3(turn[k])) * p[k];
  return glm::vec3(place);
}

double longestEdge(const ClothTriangles& cloth) {
  double longest = 0;
  for (const ClothTriangles::Face& face : cloth.faces)
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(
          longest, glm::distance(cloth.points[face.corners[k]], cloth.points[face.corners[(k + 1) % 3]]));
  return longest;
}

std::uint32_t bitsOf(double value) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(value));
}

}  // namespace

GarmentPlan::GarmentPlan(const std::string& name, const ClothParameters& parameters, int seed,
                         double frameSeconds, const std::vector<ColliderShape>& colliders,
                         const BoneNamed& boneNamed, double startTime, const HeldBySkin& heldBySkin)
    : GarmentPlan(name, parameters, seed, frameSeconds, colliders, boneNamed, startTime, heldBySkin,
                  parameters.mesh->make()) {}

GarmentPlan::GarmentPlan(const std::string& name, const ClothParameters& parameters, int seed,
                         double frameSeconds, const std::vector<ColliderShape>& colliders,
                         const BoneNamed& boneNamed, double startTime, const HeldBySkin& heldBySkin,
                         Mesh mesh)
    : seed_(seed),
      mesh_(std::move(mesh)),
      cloth_(placeOf(name, parameters), mesh_, parameters.mesh->scale, parameters.mesh->weld),
      membrane_(membraneElements(cloth_, mesh_)),
      masses_(vertexMasses(cloth_, parameters.fabric->constants().density)),
      steps_(settled(placeOf(name, parameters), parameters, frameSeconds, colliders), seed, frameSeconds,
             colliders, boneNamed, startTime, {}, longestEdge(cloth_)) {
  skinPins_.attach(parameters.pins, groups_, rest_, heldBySkin, startTime);
  makeArrays();
}

void GarmentPlan::place(const ClothParameters& parameters) {
  rest_.reserve(cloth_.points.size());
  for (const glm::dvec3& p : cloth_.points) rest_.push_back(placed(parameters, p));
}

void GarmentPlan::pin(const std::string& name, const ClothParameters& parameters) {
  groups_.assign(cloth_.points.size(), -1);
  for (std::size_t i = 0; i < parameters.pins.size(); ++i)
    pinGroup(name, parameters.pins[i], static_cast<int>(i));
}

unsigned GarmentPlan::vertexNamed(const std::string& name, const std::string& what, int number) const {
  if (static_cast<std::size_t>(number) >= cloth_.vertexOf.size())
    fail(ExitCode::usage, "{}: {} names vertex {}, but there are {} (0 to {})", name, what, number,
         cloth_.vertexOf.size(), cloth_.vertexOf.size() - 1);
  return cloth_.vertexOf[static_cast<std::size_t>(number)];
}

void GarmentPlan::pinGroup(const std::string& name, const PinGroup& group, int number) {
  int held = 0;
  const auto hold = [&](std::size_t vertex) {
    groups_[vertex] = number;
    ++held;
  };
  for (const int vertex : group.vertices) hold(vertexNamed(name, fmt::format("pins[{}]", number), vertex));
  if (group.box)
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      bool inside = true;
      for (int k = 0; k < 3; ++k)
        inside = inside && rest_[i][k] >= group.box->min[k] && rest_[i][k] <= group.box->max[k];
      if (inside) hold(i);
    }
  if (!group.map.empty()) {
    if (mesh_.uvs.empty())
      fail(ExitCode::usage,
           "{}: pins[{}] has a \"map\", but the mesh has no uv; pin by \"box\" or \"vertices\"", name,
           number);
    const Picture picture = loadPicture(group.map, "map of pins", 16384);
    const auto pixel = [](float at, int size) {
      const double part = static_cast<double>(at) - std::floor(static_cast<double>(at));
      return std::min(static_cast<int>(part * size), size - 1);
    };
    for (std::size_t i = 0; i < mesh_.uvs.size(); ++i)
      if (picture.level(pixel(mesh_.uvs[i].x, picture.size.x), pixel(mesh_.uvs[i].y, picture.size.y)) >=
          128)
        hold(cloth_.vertexOf[i]);
  }
  if (held == 0)
    fail(
        ExitCode::usage,
        "{}: pins[{}] holds no vertex; give \"vertices\", a larger \"box\" or a \"map\" with bright places",
        name, number);
}

void GarmentPlan::clamp(const std::string& name, const ClothParameters& parameters) {
  std::vector<bool> holds(parameters.pins.size(), false);
  for (unsigned f = 0; f < cloth_.faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const ClothTriangles::Face& face = cloth_.faces[f];
      const int group = groups_[face.corners[k]];
      if (face.neighbours[k] != ClothTriangles::none || group < 0 ||
          groups_[face.corners[(k + 1) % 3]] != group)
        continue;
      const auto number = static_cast<std::size_t>(group);
      if (!parameters.pins[number].clamp) continue;
      holds[number] = true;
      const glm::dvec3 a = cloth_.points[face.corners[k]];
      const glm::dvec3 edge = cloth_.points[face.corners[(k + 1) % 3]] - a;
      const glm::dvec3 within = cloth_.points[face.corners[(k + 2) % 3]] - a;
      // The ghost point is as far outside the edge as the third corner is inside.
      const glm::dvec3 out = edge * (glm::dot(within, edge) / glm::dot(edge, edge)) - within;
      const auto ghost = static_cast<unsigned>(cloth_.points.size() + clamps_.size());
      clamps_.push_back({f, k, ghost, std::sqrt(glm::dot(out, out))});
      rest_.push_back(placed(parameters, a + 0.5 * edge + out));
    }
  for (const ClampedEdge& edge : clamps_)
    groups_.push_back(groups_[cloth_.faces[edge.face].corners[edge.side]]);
  for (std::size_t i = 0; i < holds.size(); ++i)
    if (parameters.pins[i].clamp && !holds[i])
      fail(ExitCode::usage,
           "{}: pins[{}] has \"clamp\", but holds no edge of a border: pin both ends of one, or leave out "
           "\"clamp\"",
           name, i);
}

void GarmentPlan::sew(const std::string& name, const ClothParameters& parameters) {
  std::vector<glm::uvec4> stitches;
  for (std::size_t k = 0; k < parameters.seams.size(); ++k) {
    const Seam& seam = parameters.seams[k];
    for (std::size_t i = 0; i < seam.from.size(); ++i) {
      const unsigned a = vertexNamed(name, fmt::format("seams[{}]", k), seam.from[i]);
      const unsigned b = vertexNamed(name, fmt::format("seams[{}]", k), seam.to[i]);
      if (a == b) continue;  // Both indices denote the same merged vertex.
      const glm::dvec3 d = glm::dvec3(rest_[b]) - glm::dvec3(rest_[a]);
      seamPairs_[seam.seconds].emplace_back(a, b);
      stitches.emplace_back(a, b, bitsOf(std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z)),
                            bitsOf(1 / seam.seconds));
    }
  }
  // Greedy colouring: each stitch gets the first colour that no other stitch at its two vertices has.
  std::vector<std::vector<glm::uvec4>> colours;
  std::vector<std::vector<bool>> taken;
  for (const glm::uvec4& stitch : stitches) {
    std::size_t colour = 0;
    while (colour < taken.size() && (taken[colour][stitch.x] || taken[colour][stitch.y])) ++colour;
    if (colour == taken.size()) {
      taken.emplace_back(cloth_.points.size(), false);
      colours.emplace_back();
    }
    taken[colour][stitch.x] = taken[colour][stitch.y] = true;
    colours[colour].push_back(stitch);
  }
  for (const auto& colour : colours) {
    arrays_.stitchColours.push_back(static_cast<int>(arrays_.stitches.size()));
    arrays_.stitches.insert(arrays_.stitches.end(), colour.begin(), colour.end());
  }
  arrays_.stitchColours.push_back(static_cast<int>(arrays_.stitches.size()));
}

ClothParameters GarmentPlan::settled(const std::string& name, ClothParameters parameters,
                                     double frameSeconds, const std::vector<ColliderShape>& colliders) {
  place(parameters);
  pin(name, parameters);
  clamp(name, parameters);
  sew(name, parameters);
  plates_.push_back(plateElements(cloth_, clamps_));
  std::vector<std::pair<unsigned, unsigned>> sewn;
  int opposite = 0;
  for (const auto& [seconds, stitches] : seamPairs_) {
    sewn.insert(sewn.end(), stitches.begin(), stitches.end());
    ClothTriangles grown = cloth_;
    opposite = grown.sew(sewn);
    plates_.push_back(plateElements(grown, clamps_));
  }
  if (opposite > 0)
    warn(
        "{}: {} edges are sewn to edges of faces that face the other way, so the seam bends like a hinge "
        "there; turn one piece over",
        name, opposite);
  std::vector<bool> pinned;
  for (std::size_t i = 0; i < masses_.size(); ++i) pinned.push_back(groups_[i] >= 0);
  const std::vector<double> inverse = inverseMasses();
  std::multimap<unsigned, unsigned> links;
  for (const glm::uvec4& stitch : arrays_.stitches) {
    links.emplace(stitch.x, stitch.y);
    links.emplace(stitch.y, stitch.x);
  }
  const GarmentPace pace(parameters, cloth_, membrane_, masses_, pinned, links);
  const double bending = parameters.fabric->constants().bending;
  double bendingSquared = 0;
  for (const auto& plate : plates_)
    bendingSquared =
        std::max(bendingSquared, std::min(plateFrequencySquared(plate, bending, inverse, 1.0),
                                          25 * plateFrequencySquared(plate, bending, inverse, 0.5)));
  const bool given = parameters.substeps.has_value();
  if (!given) {
    const double reach = parameters.margin + 0.5 * parameters.fabric->constants().thickness;
    const double edge = longestEdge(cloth_);
    const bool thin = std::any_of(colliders.begin(), colliders.end(), [&](const ColliderShape& shape) {
      return ColliderPlan::isThin(shape, edge, reach);
    });
    // With a substep of 1/960 s, faces that are relaxed once per substep yield fast enough to a rod of 2 cm
    // at 10 m/s.
    const double longest = parameters.keepsEnergy() ? keepingFaceSubstep : 1.0 / 960;
    const int fewest =
        thin || parameters.keepsEnergy() ? static_cast<int>(std::ceil(frameSeconds / longest - 1e-9)) : 8;
    parameters.substeps = pace.substeps(frameSeconds, bendingSquared,
                                        parameters.fewestSubsteps(frameSeconds, std::max(fewest, 8)));
  }
  const double seconds = frameSeconds / *parameters.substeps;
  if (given && seconds > pace.stableSeconds())
    warn(
        "{}: {} fewer than the {:.0f} that the hanging parts need to be stable; set \"substeps\": \"auto\"",
        name,
        *parameters.substeps == 1 ? "1 substep is" : fmt::format("{} substeps are", *parameters.substeps),
        std::ceil(frameSeconds / pace.stableSeconds()));
  if (!given && pace.stretchError(seconds) > 0.01)
    warn("{}: with {} substeps it stretches by {:.1f}% more than its fabric; take a coarser mesh", name,
         *parameters.substeps, 100 * pace.stretchError(seconds));
  for (const Attachment& a :
       attachmentsOf(cloth_, pinned, membrane_, masses_, parameters.fabric->constants(),
                     softeningSeconds(parameters, seconds)))
    arrays_.attachments.emplace_back(
        a.vertex, a.pin, bitsOf(a.length),
        bitsOf(a.compliance + (parameters.keepsEnergy()
                                   ? (attachmentSoftening - 1) * seconds * seconds / masses_[a.vertex]
                                   : 0)));
  bend(name, parameters, seconds, given);
  return parameters;
}

std::vector<double> GarmentPlan::inverseMasses() const {
  std::vector<double> inverse;
  for (std::size_t i = 0; i < masses_.size(); ++i) inverse.push_back(groups_[i] >= 0 ? 0 : 1 / masses_[i]);
  inverse.resize(rest_.size(), 0);
  return inverse;
}

void GarmentPlan::bend(const std::string& name, const ClothParameters& parameters, double seconds,
                       bool given) {
  auto shut = seamPairs_.begin();
  int softened = 0;
  for (const std::vector<PlateElement>& plate : plates_) {
    GarmentBending bending;
    // The bending applies from the first substep after the seam is closed.
    if (!arrays_.bendings.empty()) bending.from = static_cast<int>(std::ceil((shut++)->first / seconds));
    const PlateMatrix matrix(plate, parameters.fabric->constants().bending, inverseMasses(),
                             maxBending(seconds));
    softened = std::max(softened, matrix.softened);
    bending.fans.resize(rest_.size());
    for (std::size_t i = 0; i < masses_.size(); ++i) {
      const PlateRow& row = matrix.rows[i];
      const auto first = static_cast<unsigned>(bending.entries.size());
      for (std::size_t k = 0; k < row.size(); k += 2) {
        const auto [vertex, value] =
            k + 1 < row.size() ? row[k + 1] : std::pair(static_cast<unsigned>(i), 0.0);
        bending.entries.emplace_back(row[k].first, bitsOf(row[k].second), vertex, bitsOf(value));
      }
      bending.fans[i] = {cloth_.starts[i], cloth_.starts[i + 1] - cloth_.starts[i], first,
                         static_cast<unsigned>(bending.entries.size()) - first};
    }
    if (bending.entries.empty()) bending.entries.emplace_back(0);
    arrays_.bendings.push_back(std::move(bending));
  }
  if (static_cast<double>(softened) > 0.05 * static_cast<double>(cloth_.faces.size()))
    warn(
        "{}: {} of {} faces are so small that they bend more easily than the fabric at {} substeps a "
        "frame; {}",
        name, softened, cloth_.faces.size(), *parameters.substeps,
        given ? "set \"substeps\": \"auto\"" : "take a coarser or more even mesh");
}

std::size_t GarmentPlan::bendingAt(int substep) const {
  std::size_t last = 0;
  for (std::size_t i = 1; i < arrays_.bendings.size(); ++i)
    if (arrays_.bendings[i].from <= substep) last = i;
  return last;
}

void GarmentPlan::makeArrays() {
  const shader::FabricConstants fabric = parameters().fabric->constants();
  const std::vector<double> inverseMasses = this->inverseMasses();
  const std::vector<int> colours = colourFaces(cloth_);
  const int last = *std::max_element(colours.begin(), colours.end());
  std::vector<unsigned> numbers(colours.size());
  for (int colour = 0; colour <= last; ++colour) {
    arrays_.colours.push_back(static_cast<int>(arrays_.corners.size()));
    for (std::size_t f = 0; f < colours.size(); ++f) {
      if (colours[f] != colour) continue;
      numbers[f] = static_cast<unsigned>(arrays_.corners.size());
      const auto& corners = cloth_.faces[f].corners;
      arrays_.corners.emplace_back(corners[0], corners[1], corners[2], 0);
      const MembraneElement& e = membrane_[f];
      arrays_.elements.emplace_back(e.p, e.q, e.r, e.s);
      if (parameters().keepsEnergy()) {
        const glm::dvec3 inverse(inverseMasses[corners[0]], inverseMasses[corners[1]],
                                 inverseMasses[corners[2]]);
        const FaceStiffness k =
            stiffnessOf(e, fabric, inverse, softeningSeconds(parameters(), substepSeconds()));
        arrays_.elements.emplace_back(k.weft * e.area, k.warp * e.area, k.shear * e.area, 0);
      } else {
        arrays_.elements.emplace_back(1 / (fabric.weft * e.area), 1 / (fabric.warp * e.area),
                                      1 / (fabric.shear * e.area), 0);
      }
    }
  }
  arrays_.colours.push_back(static_cast<int>(arrays_.corners.size()));
  for (unsigned i = 0; i < cloth_.points.size(); ++i)
    for (unsigned k = cloth_.starts[i]; k < cloth_.starts[i + 1]; ++k) {
      const unsigned f = cloth_.around[k];
      const auto& corners = cloth_.faces[f].corners;
      const std::size_t at = corners[0] == i ? 0 : corners[1] == i ? 1 : 2;
      arrays_.rings.emplace_back(corners[(at + 1) % 3], corners[(at + 2) % 3], numbers[f],
                                 static_cast<unsigned>(at));
    }
  for (const unsigned vertex : cloth_.vertexOf) arrays_.copies.emplace_back(vertex, 0, 0, 0);
}

std::vector<glm::vec4> GarmentPlan::firstTrends() const {
  std::vector<glm::vec4> trends;
  trends.reserve(rest_.size());
  for (std::size_t i = 0; i < rest_.size(); ++i)
    trends.emplace_back(groups_[i] >= 0 ? rest_[i] : glm::vec3(0), 0.0F);
  return trends;
}

std::vector<glm::vec4> GarmentPlan::firstPositions() const {
  std::vector<glm::vec4> positions;
  positions.reserve(rest_.size());
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    const glm::vec3 noise =
        shader::signedUnits(shader::hash3({static_cast<unsigned>(i), 0U, static_cast<unsigned>(seed_)}));
    positions.emplace_back(rest_[i] + noise * parameters().jitter,
                           groups_[i] >= 0 ? 0.0F : static_cast<float>(1 / masses_[i]));
  }
  return positions;
}

std::vector<glm::vec4> GarmentPlan::firstVelocities() const {
  std::vector<glm::vec4> velocities;
  velocities.reserve(groups_.size());
  for (const int group : groups_) velocities.emplace_back(0, 0, 0, std::max(group, 0));
  for (const unsigned i : skinPins_.particles()) velocities[i].w = heldBySkinMark;
  return velocities;
}

std::vector<float> GarmentPlan::contactRooms() const {
  std::vector<float> rooms(cloth_.points.size(), std::numeric_limits<float>::infinity());
  for (const ClothTriangles::Face& face : cloth_.faces) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(
          longest, glm::distance(cloth_.points[face.corners[k]], cloth_.points[face.corners[(k + 1) % 3]]));
    for (const unsigned corner : face.corners)
      rooms[corner] = std::min(rooms[corner], static_cast<float>(roomOfHeight * 2 * face.area / longest));
  }
  return rooms;
}

}  // namespace simreel::sim
