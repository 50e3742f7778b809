// Compares the cloth simulations with plain loops. The minimum numbers of operations and bytes of a substep
// are counted here.
#include "beside/subject.hpp"
#include "plain/plain.hpp"
#include "reference/cloth_twin.hpp"
#include "reference/contact_twin.hpp"
#include "reference/garment_twin.hpp"
#include "sim/contact/lock_step.hpp"
#include "sim/grid/sheet_mesh.hpp"

#include <cstring>

namespace simreel::bench {

namespace {

constexpr int substeps = 16;
constexpr float dt = static_cast<float>(frameSeconds / substeps);
constexpr double stateBytes = 64;  // bytes per particle and substep; position and velocity are read and
                                   // written

// Operations of a substep for a particle of a sheet, counted by hand from the equations. A division or a
// square root counts as one. The terms are, in order: forces of the second differences along both axes and
// of the twist (63); velocity and position (21); two diagonals (60); a row link and a column link, with
// their directions (28), matrix (12), solve (26) and update (18); and v = (x - x_before) / dt (6).
constexpr double sheetOperations = 63 + 21 + 60 + 28 + 12 + 26 + 18 + 6;
// Operations of a face: columns of the deformation gradient 24, lengths and directions 22, strains 7,
// gradients of shear 18, products of the gradients 25, matrix 11, solve 28, update 63. Constants such as
// the vertex weights are precomputed and not counted. A vertex has 27 operations, plus 9 for each entry of
// its row of the bending matrix.
constexpr double faceOperations = 198, vertexOperations = 27, entryOperations = 9;
// Operations of a candidate contact pair: 120 for the closest points and 65 for the test whether the pair
// comes near in this substep. A near pair also has two rounds of impulses with 110 operations each, and 85
// for the test whether the two parts pass through each other. The search for pairs is not counted.
constexpr double pairOperations = 185, nearOperations = 305;

plain::Fabric::Numbers numbersOf(const sim::ClothParameters& p) {
  const auto f = p.fabric->constants();
  return {p.spacing, f.density, f.weft, f.warp, f.shear, f.bending, 9.8F, 1 - p.damping * dt, dt};
}

sim::ClothParameters sheet(glm::ivec2 size, float spacing) {
  sim::ClothParameters p;
  p.size = size;
  p.spacing = spacing;
  p.fabric.emplace();
  p.wind = glm::vec3(0);
  p.damping = 0.5F;
  p.substeps = substeps;
  p.pins.clear();
  return p;
}

}  // namespace

Subject fabricSheet() {
  constexpr int side = 256;
  sim::ClothParameters p = sheet({side, side}, 3.2F / side);
  p.rotation = glm::vec3(90, 0, 0);
  p.pins.emplace_back().rows = {0};
  auto own = std::make_shared<plain::Fabric>(side, side, numbersOf(p));
  for (std::size_t x = 0; x < side; ++x) own->inverseMass[x] = 0;
  return {"cloth, fabric",
          "1e6 particle-steps/s",
          double(substeps) * side * side,
          [=] {
            for (int i = 0; i < substeps; ++i) {
              own->predict();
              own->settle();
            }
          },
          frames(std::make_shared<ClothTwin>(sim::ClothPlan(p, 1, frameSeconds, {})), 1),
          frames(onDevice("cloth", p), sim::StepWatch{}),
          {sheetOperations, stateBytes, double(side) * side}};
}

Subject meshCloth() {
  sim::ClothParameters p = sheet({2, 2}, 1);
  p.mesh.emplace();
  p.mesh->resolution = {129, 129};
  p.rotation = glm::vec3(90, 0, 0);
  sim::PinGroup& top = p.pins.emplace_back();
  top.box = sim::PinBox{glm::vec3(-2, 0.999F, -1), glm::vec3(2, 1.1F, 1)};
  const sim::GarmentPlan plan("cloth", p, 1, frameSeconds, {});
  const sim::GarmentArrays& from = plan.arrays();
  auto own = std::make_shared<plain::Garment>();
  own->gravity = 9.8F;
  own->kept = 1 - p.damping * dt;
  own->dt = dt;
  for (const glm::vec4& v : plan.firstPositions()) {
    own->position.push_back({v.x, v.y, v.z});
    own->inverseMass.push_back(v.w);
  }
  own->velocity.resize(own->position.size());
  for (std::size_t f = 0; f < from.corners.size(); ++f) {
    const glm::uvec4 c = from.corners[f];
    const glm::vec4 shape = from.elements[2 * f], give = from.elements[2 * f + 1] / (dt * dt);
    own->faces.push_back(
        {int(c.x), int(c.y), int(c.z), shape.x, shape.y, shape.z, shape.w, give.x, give.y, give.z});
  }
  const auto add = [&](unsigned other, unsigned bits) {
    float stiffness = 0;
    std::memcpy(&stiffness, &bits, sizeof stiffness);
    own->bends.push_back({int(other), stiffness});
  };
  const sim::GarmentBending& bending = from.bendings.front();
  for (const glm::uvec4 fan : bending.fans) {
    own->firstBend.push_back(int(own->bends.size()));
    for (unsigned k = fan.z; k < fan.z + fan.w; ++k) {
      add(bending.entries[k].x, bending.entries[k].y);
      add(bending.entries[k].z, bending.entries[k].w);
    }
  }
  own->firstBend.push_back(int(own->bends.size()));
  const double vertices = double(own->position.size());
  const double faces = double(own->faces.size()) / vertices, entries = double(own->bends.size()) / vertices;
  return {"cloth, mesh",
          "1e6 vertex-steps/s",
          substeps * vertices,
          [=] {
            for (int i = 0; i < substeps; ++i) own->step();
          },
          frames(std::make_shared<GarmentTwin>(sim::GarmentPlan("cloth", p, 1, frameSeconds, {}))),
          frames(onDevice("cloth", p), sim::StepWatch{}),
          {vertexOperations + faceOperations * faces + entryOperations * entries,
           stateBytes + sizeof(plain::Garment::Face) * faces + sizeof(plain::Garment::Bend) * entries,
           vertices}};
}

namespace {

/// Stacked sheets, the lowest of which is fixed at its borders. The same stack is simulated on the device,
/// with the CPU twins, and with plain loops.
struct Pile {
  static constexpr int count = 5;
  static constexpr glm::ivec2 size{23, 21};
  static constexpr std::size_t each = std::size_t(size.x) * size.y;
  std::vector<std::shared_ptr<sim::Simulation>> cloths;
  std::unique_ptr<sim::ContactGroup> group;
  std::vector<ClothTwin> twins;
  std::unique_ptr<ContactTwin> twinContact;
  std::vector<plain::Fabric> plains;
  std::unique_ptr<plain::Contact> plainContact;
  std::vector<plain::Vec3> now, next;
  std::vector<float> inverseMass;
  int frame = 0;
  double pairs = 0, nears = 0;  ///< numbers of candidate pairs and near pairs in a substep after the stack
                                ///< has come to rest

  Pile() {
    std::vector<sim::LockStep*> members;
    std::vector<sim::ContactPart> parts;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < count; ++i) {
      sim::ClothParameters p = sheet(size, 0.036F);
      p.position = glm::vec3(0.003F * static_cast<float>(i), 0.007F * static_cast<float>(i), 0);
      p.rotation = glm::vec3(0, static_cast<float>(i) * 25, 0);
      p.jitter = 2e-4F;
      p.contact.emplace();
      if (i == 0) {
        p.pins.emplace_back().rows = {0, -1};
        p.pins.back().columns = {0, -1};
      }
      cloths.push_back(onDevice("cloth", p, substeps));
      members.push_back(cloths.back()->lockStep());
      parts.push_back(members.back()->contactPart());
      twins.emplace_back(sim::ClothPlan(p, 1, frameSeconds, {}));
      plains.emplace_back(size.x, size.y, numbersOf(p));
      for (const unsigned k : sim::gridIndices(size)) indices.push_back(k + std::uint32_t(i * each));
    }
    group = std::make_unique<sim::ContactGroup>(members, std::vector<sim::ContactSolid*>{}, substeps,
                                                frameSeconds, false);
    twinContact = std::make_unique<ContactTwin>(sim::ContactPlan(parts, frameSeconds / substeps));
    plainContact = std::make_unique<plain::Contact>(indices, count * each, 0.04F, parts[0].thickness,
                                                    parts[0].friction);
    for (int i = 0; i < 40; ++i) deviceFrame();
    for (std::size_t i = 0; i < count; ++i) {
      const auto state = cloths[i]->state();
      twins[i].positions = state[0].buffer->readAll<glm::vec4>();
      twins[i].velocities = state[1].buffer->readAll<glm::vec4>();
      for (std::size_t k = 0; k < each; ++k) {
        const glm::vec4 x = twins[i].positions[k], v = twins[i].velocities[k];
        plains[i].position[k] = {x.x, x.y, x.z};
        plains[i].velocity[k] = {v.x, v.y, v.z};
        plains[i].inverseMass[k] = x.w;
        inverseMass.push_back(x.w);
      }
    }
    twinFrame();
    pairs = double(twinContact->pairs);
    nears = double(twinContact->nears);
  }

  void deviceFrame() { group->step(frame++ * frameSeconds, {}); }

  void twinFrame() {
    std::vector<std::vector<shader::ClothStep>> steps;
    for (ClothTwin& twin : twins) steps.push_back(twin.plan().frame(0));
    for (std::size_t s = 0; s < std::size_t(substeps); ++s) {
      std::vector<ContactTwin::Part> parts;
      for (std::size_t i = 0; i < count; ++i) {
        twins[i].predict(steps[i][s], 1, int(s));
        parts.push_back({&twins[i].positions, &twins[i].next, &twins[i].velocities});
      }
      twinContact->push(parts, s == 0);
      for (std::size_t i = 0; i < count; ++i) twins[i].settle(steps[i][s], int(s));
      twinContact->hold(parts);
      for (ClothTwin& twin : twins) twin.finish();
    }
  }

  void plainFrame() {
    for (int s = 0; s < substeps; ++s) {
      now.clear();
      next.clear();
      for (plain::Fabric& cloth : plains) {
        cloth.predict();
        now.insert(now.end(), cloth.position.begin(), cloth.position.end());
        next.insert(next.end(), cloth.next.begin(), cloth.next.end());
      }
      plainContact->push(now, next, inverseMass);
      for (std::size_t i = 0; i < count; ++i) {
        std::copy_n(next.begin() + long(i * each), each, plains[i].next.begin());
        plains[i].settle();
      }
    }
  }
};

}  // namespace

Subject clothsInContact() {
  auto pile = std::make_shared<Pile>();
  const double vertices = double(Pile::count * Pile::each);
  return {"cloth, five in contact",
          "1e6 particle-steps/s",
          substeps * vertices,
          [=] { pile->plainFrame(); },
          [=] { pile->twinFrame(); },
          [=] { pile->deviceFrame(); },
          {sheetOperations + (pairOperations * pile->pairs + nearOperations * pile->nears) / vertices,
           stateBytes, vertices}};
}

}  // namespace simreel::bench
