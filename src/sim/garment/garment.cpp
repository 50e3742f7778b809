#include "sim/garment/garment.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "gl/element_array.hpp"
#include "gl/program.hpp"
#include "sim/body/bones.hpp"
#include "sim/cloth/cloth.hpp"
#include "sim/cloth/skin_hold.hpp"
#include "sim/cloth/thin.hpp"
#include "sim/collide/distance_fields.hpp"
#include "sim/contact/lock_step.hpp"
#include "sim/contour/walls.hpp"
#include "sim/core/kind.hpp"
#include "sim/core/step_blocks.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/garment/plan.hpp"
#include "sim/garment/quantities.hpp"
#include "sim/mesh/buffers.hpp"
#include "sim/mesh/height_field.hpp"
#include "sim/mesh/looks.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace simreel::shader::garment {
#include "glsl/cloth/mesh/bindings.glsl"
}  // namespace simreel::shader::garment

namespace simreel::sim {

namespace {

/// Cloth of triangles on the GPU. Each substep: what the air does to faces; forces and a prediction by
/// vertices; stretch and shear, a colour of faces after the other; then speeds and what the cloth meets.
class Garment : public Simulation, public LockStep {
 public:
  Garment(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        plan_(object.name, parametersOf<ClothParameters>(object).inStep(setting.together<LockStep>().steps),
              setting.seed, setting.frameSeconds, *setting.colliders, boneNamedIn(setting),
              setting.startTime, heldBySkinIn(setting)),
        vertices_(static_cast<int>(plan_.vertexCount())),
        heights_(setting.find<HeightField>()),
        frameSeconds_(setting.frameSeconds),
        topology_(name_, plan_.mesh()),
        looks_(object, plan_.mesh()) {
    if (const std::string ignored = ignoredLooks(object, plan_.mesh()); !ignored.empty())
      warn("cloth \"{}\": {} has what is not drawn: {}", name_, plan_.parameters().mesh.file.string(),
           ignored);
    const ClothParameters& p = plan_.parameters();
    if (!p.walls.empty()) {
      walls_ = setting.wanted<Walls>(p.walls);
      walls_->checkReach(name_, p.margin);
    }
    if (p.hasAir) wind_ = setting.wanted<FluidWind>(p.air.fluid);
    meshes_ = MeshTouch(name_, setting.find<DistanceFields>(), plan_.substeps(), plan_.substepSeconds());
    makeArrays();
    makePrograms(setting.fast);
    thin_ = ThinColliders(name_, "cloth/mesh/thin.comp", plan_.thinCount(), vertices_, setting.fast);
    if (thin_.there()) thin_.kernel().set("count", vertices_);
    show();
  }

  void step(double time, const StepWatch& watch) override {
    beginFrame(time);
    for (int i = 0; i < plan_.substeps(); ++i) {
      predict(i);
      finish();
      if (watch) watch(i + 1);
    }
    endFrame(time);
  }

  void connect(Outlets& outlets) override {
    if (plan_.parameters().hasContact) outlets.provide<LockStep>(this);
  }
  [[nodiscard]] ContactPart contactPart() const override {
    const ClothParameters& p = plan_.parameters();
    ContactPart part{plan_.firstPositions(), {}, 0, p.contact.friction, plan_.contactRooms()};
    part.positions.resize(part.rooms.size());  // without ghosts
    part.name = name_;
    for (const glm::uvec4& face : plan_.arrays().corners) part.faces.emplace_back(face);
    double sum = 0;
    for (const float room : part.rooms) sum += room;
    part.thickness = p.contactThickness(
        static_cast<float>(sum / (roomOfHeight * static_cast<double>(part.rooms.size()))));
    return part;
  }
  void beginFrame(double time) override {
    begun_ = plan_.stepsBegun();
    steps_.upload(plan_.frame(time));
    meshes_.beginFrame(time);
    hold_.beginFrame(plan_.skinPins(), time, time + frameSeconds_);
  }
  void predict(int substep) override {
    steps_.bind(static_cast<std::size_t>(substep));
    gl::barrier();
    push();
    hold_.hold(velocities_, substep, plan_.substeps());
    accelerate(plan_.bendingAt(begun_ + substep));
    stretch();
    attach();
    sew();
    trends_.bindState(shader::garment::settledTrendsBinding);
    meet(settle_, substep);
    if (!plan_.parameters().hasContact) return;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    left_.copyFrom(positions_[1]);
  }
  void settle(int substep) override {
    steps_.bind(static_cast<std::size_t>(substep));
    gl::barrier();
    left_.bindInput(shader::garment::leftBinding);
    meet(settleAgain_, substep);
  }
  [[nodiscard]] Contact::Part arrays() const override {
    return {&positions_[0], &positions_[1], &velocities_, &trends_};
  }
  void finish() override { std::swap(positions_[0], positions_[1]); }
  void endFrame(double time) override {
    gl::barrier();
    time_ = time + frameSeconds_;
    show();
  }

  [[nodiscard]] int stepsPerFrame() const override { return plan_.substeps(); }
  [[nodiscard]] std::string elementName(long element) const override {
    return fmt::format("vertex {}", element);
  }

  void publish(double /*time*/, Drawables& drawables) const override {
    Surface surface = topology_.surface();
    surface.positions = &drawnPositions_.view();
    surface.normals = &drawnNormals_.view();
    surface.doubleSided = true;
    looks_.show(surface, drawables);
  }

  void carryOver(CarryOver& carry) override {
    plan_.carryOver(carry);
    carry.array("positions", positions_[0].buffer());
    carry.array("velocities", velocities_.buffer());
    carry.array("trends", trends_.buffer());
  }
  void resumed(double time) override {
    time_ = time;
    show();
  }

  [[nodiscard]] std::vector<StateArray> state() const override {
    return {{"positions", &positions_[0].buffer()},
            {"velocities", &velocities_.buffer()},
            {"trends", &trends_.buffer()}};
  }
  [[nodiscard]] PointTable points() const override {
    const auto positions = positions_[0].buffer().readAll<glm::vec4>();
    const auto velocities = shownVelocities(positions);
    PointTable table{{"x", "y", "z", "vx", "vy", "vz"}, {}};
    for (const unsigned i : plan_.cloth().vertexOf)
      table.values.insert(table.values.end(), {positions[i].x, positions[i].y, positions[i].z,
                                               velocities[i].x, velocities[i].y, velocities[i].z});
    return table;
  }
  [[nodiscard]] std::optional<MeshTable> mesh() const override {
    MeshTable table;
    table.uvs = plan_.mesh().uvs;
    table.indices = plan_.mesh().indices;
    for (const glm::vec4& p : drawnPositions_.buffer().readAll<glm::vec4>())
      table.positions.emplace_back(p);
    for (const glm::vec4& n : drawnNormals_.buffer().readAll<glm::vec4>()) table.normals.emplace_back(n);
    return table;
  }
  [[nodiscard]] const gl::Buffer* status() const override { return &status_; }
  [[nodiscard]] std::vector<double> measure() const override {
    const auto positions = positions_[0].buffer().readAll<glm::vec4>();
    return measureGarment(plan_, positions, shownVelocities(positions), time_);
  }
  [[nodiscard]] std::string explainLoss(unsigned step, unsigned element) const override {
    return fmt::format(
        "cloth \"{}\" blew up in substep {} at vertex {}: its position or velocity is no longer a sensible "
        "number; use more substeps ({} per frame now, or \"auto\"), or a heavier fabric",
        name_, step, element, plan_.substeps());
  }

 private:
  [[nodiscard]] std::vector<glm::vec4> shownVelocities(const std::vector<glm::vec4>& positions) const {
    const bool keeps = plan_.parameters().keepsEnergy();
    return actualVelocities(positions, velocities_.buffer().readAll<glm::vec4>(),
                            keeps ? std::vector<glm::vec4>() : trends_.buffer().readAll<glm::vec4>());
  }
  void makeArrays() {
    const auto positions = plan_.firstPositions();
    positions_[0] = gl::Vec4Array(name_ + " positions", positions);
    positions_[1] = gl::Vec4Array(name_ + " next positions", positions);
    velocities_ = gl::Vec4Array(name_ + " velocities", plan_.firstVelocities());
    trends_ = gl::Vec4Array(name_ + " trends", plan_.firstTrends());
    if (plan_.parameters().hasContact) left_ = gl::Vec4Array(name_ + " left", vertices_);
    const GarmentArrays& arrays = plan_.arrays();
    const auto words = [&](const char* what, const std::vector<glm::uvec4>& items) {
      return gl::WordsArray(name_ + what, items);
    };
    corners_ = words(" faces", arrays.corners);
    rings_ = words(" rings", arrays.rings);
    if (!arrays.attachments.empty()) attachments_ = words(" attachments", arrays.attachments);
    if (!arrays.stitches.empty()) stitches_ = words(" stitches", arrays.stitches);
    for (const GarmentBending& bending : arrays.bendings) {
      fans_.push_back(words(" fans", bending.fans));
      entries_.push_back(words(" bending", bending.entries));
    }
    copies_ = words(" copies", arrays.copies);
    elements_ = gl::Vec4Array(name_ + " elements", arrays.elements);
    const int faces = plan_.parameters().hasAir ? static_cast<int>(arrays.corners.size()) : 1;
    faceForces_ = gl::Vec4Array(name_ + " air", faces);
    const int drawn = static_cast<int>(arrays.copies.size());
    drawnPositions_ = gl::Vec4Array(name_ + " drawn positions", drawn);
    drawnNormals_ = gl::Vec4Array(name_ + " drawn normals", drawn);
    const unsigned fine[4] = {0xffffffffU, 0xffffffffU, 0, 0};
    status_ = gl::Buffer::of<unsigned>(name_ + " status", fine);
    steps_ = StepBlocks<shader::ClothStep>(name_ + " steps", plan_.substeps());
  }

  void makePrograms(bool fast) {
    gl::Defines defines = gl::kernelDefines(fast);
    hold_ = SkinHold(name_, plan_.skinPins(), defines);
    defines.emplace_back("AIR", plan_.parameters().hasAir ? "true" : "false");
    defines.emplace_back("DAMPED", plan_.parameters().damped() ? "1" : "0");
    defines.emplace_back("KEEPS", plan_.parameters().keepsEnergy() ? "1" : "0");
    if (gl::memoryPath() == gl::MemoryPath::texel)
      defines.emplace_back("COLLIDERS", std::to_string(plan_.colliderCount()));
    const auto meeting = [&](bool meets) {
      gl::Defines all = defines;
      all.emplace_back("HEIGHTS", meets && heights_ != nullptr ? "1" : "0");
      addWallDefines(all, meets ? walls_ : nullptr);
      if (meets) meshes_.addDefines(all);
      return all;
    };
    const auto make = [&](const char* path, std::size_t count, bool meets = false) {
      gl::Program program = gl::Program::compute(path, meeting(meets));
      program.set("count", static_cast<int>(count));
      return program;
    };
    const auto vertices = static_cast<std::size_t>(vertices_);
    if (plan_.parameters().hasAir) {
      gl::Defines all = meeting(false);
      addWindDefines(all, wind_);
      air_ = gl::Program::compute("cloth/mesh/air.comp", all);
      air_.set("count", static_cast<int>(plan_.arrays().corners.size()));
      if (wind_ != nullptr) wind_->tell(air_);
    }
    predict_ = make("cloth/mesh/predict.comp", vertices);
    stretch_ = make("cloth/mesh/stretch.comp", 0);
    if (!plan_.arrays().attachments.empty())
      attach_ = make("cloth/mesh/attach.comp", plan_.arrays().attachments.size());
    if (!plan_.arrays().stitches.empty()) sew_ = make("cloth/mesh/sew.comp", 0);
    settle_ = make("cloth/mesh/settle.comp", vertices, true);
    defines.emplace_back("AGAIN", "1");
    if (plan_.parameters().hasContact) settleAgain_ = make("cloth/mesh/settle.comp", vertices, true);
    defines.pop_back();
    show_ = make("cloth/mesh/show.comp", plan_.arrays().copies.size());
    settle_.checkUniformBlock("StepBlock", sizeof(shader::ClothStep));
    meshes_.check(settle_);
  }

  /// What the air does to faces.
  void push() {
    if (plan_.parameters().hasAir) {
      positions_[0].bindInput(shader::garment::positionsBinding);
      velocities_.bindInput(shader::garment::velocitiesBinding);
      corners_.bindInput(shader::garment::cornersBinding);
      faceForces_.bindState(shader::garment::faceForcesBinding);
      if (wind_ != nullptr) wind_->bind();
      air_.dispatch(static_cast<int>(plan_.arrays().corners.size()));
      gl::barrier();
    }
  }

  /// Into positions_[1], where forces take the vertices.
  void accelerate(std::size_t bending) {
    positions_[0].bindInput(shader::garment::positionsBinding);
    positions_[1].bindState(shader::garment::nextPositionsBinding);
    velocities_.bindState(shader::garment::velocitiesBinding);
    trends_.bindInput(shader::garment::trendsBinding);
    if (plan_.parameters().keepsEnergy())
      elements_.bindInput(shader::garment::elementsBinding);
    else
      faceForces_.bindInput(shader::garment::faceForcesBinding);
    entries_[bending].bindInput(shader::garment::entriesBinding);
    fans_[bending].bindInput(shader::garment::fansBinding);
    rings_.bindInput(shader::garment::ringsBinding);
    predict_.dispatch(vertices_);
    gl::barrier();
  }

  /// positions_[1], from where the vertices would go to where they may.
  void stretch() {
    if (plan_.parameters().keepsEnergy()) return;  // forces did
    elements_.bindInput(shader::garment::elementsBinding);
    corners_.bindInput(shader::garment::cornersBinding);
    inColours(stretch_, plan_.arrays().colours, false);
    inColours(stretch_, plan_.arrays().colours, true);
  }

  /// Holds what is farther from its pin than the cloth is long.
  void attach() {
    if (plan_.arrays().attachments.empty()) return;
    attachments_.bindInput(shader::garment::attachmentsBinding);
    trends_.bindState(shader::garment::trendsBinding);
    attach_.dispatch(static_cast<int>(plan_.arrays().attachments.size()));
    gl::barrier();
  }

  /// Pulls seams shut, a colour of stitches after the other.
  void sew() {
    if (plan_.arrays().stitches.empty()) return;
    stitches_.bindInput(shader::garment::stitchesBinding);
    inColours(sew_, plan_.arrays().stitchColours, false);
  }

  /// A dispatch for each colour; what they wrote is there for what follows.
  static void inColours(const gl::Program& program, const std::vector<int>& colours, bool back) {
    for (std::size_t k = 0; k + 1 < colours.size(); ++k) {
      const std::size_t colour = back ? colours.size() - 2 - k : k;
      const int count = colours[colour + 1] - colours[colour];
      program.set("first", colours[colour]);
      program.set("count", count);
      program.dispatch(count);
      gl::barrier();
    }
  }

  /// Speeds of what is left in positions_[1], and what the vertices meet.
  void meet(const gl::Program& settling, int substep) {
    status_.bindStorage(shader::statusBinding);
    positions_[0].bindInput(shader::garment::positionsBinding);
    positions_[1].bindState(shader::garment::nextPositionsBinding);
    velocities_.bindState(shader::garment::velocitiesBinding);
    meshes_.bind(substep);
    if (heights_ != nullptr) {
      heights_->bind();
      heights_->tell(settling, substep, plan_.substeps(), plan_.parameters().margin, 0.0F);
    }
    if (walls_ != nullptr) {
      walls_->bind();
      walls_->tell(settling, plan_.substepSeconds(), plan_.parameters().margin, 0.0F);
    }
    settling.dispatch(vertices_);
    if (!thin_.there()) return;
    fans_[0].bindInput(shader::garment::fansBinding);
    rings_.bindInput(shader::garment::ringsBinding);
    thin_.fend(positions_[0], positions_[1], velocities_, vertices_, 1);
  }

  /// What is drawn of the present state.
  void show() {
    positions_[0].bindInput(shader::garment::positionsBinding);
    copies_.bindInput(shader::garment::copiesBinding);
    fans_[0].bindInput(shader::garment::fansBinding);
    rings_.bindInput(shader::garment::ringsBinding);
    drawnPositions_.bindState(shader::garment::drawnPositionsBinding);
    drawnNormals_.bindState(shader::garment::drawnNormalsBinding);
    gl::barrier();
    show_.dispatch(static_cast<int>(plan_.arrays().copies.size()));
    gl::barrier();
  }

  std::string name_;
  GarmentPlan plan_;
  int vertices_;                     ///< with the ghosts of clamped edges
  const HeightField* heights_;       ///< null: none in the scene
  const Walls* walls_ = nullptr;     ///< null: it meets none
  const FluidWind* wind_ = nullptr;  ///< null: no fluid's is in its air
  MeshTouch meshes_;
  ThinColliders thin_;
  double frameSeconds_;
  double time_ = 0;             ///< s, of the present state
  gl::Vec4Array positions_[2];  ///< now, and where the next substep writes
  gl::Vec4Array velocities_, elements_, faceForces_;
  gl::Vec4Array trends_;  ///< glsl/cloth/motion.glsl; of what is pinned where it is at rest
  gl::Vec4Array left_;    ///< of cloth in contact: where it was left before contact pushed
  gl::WordsArray corners_, rings_, copies_, stitches_, attachments_;
  std::vector<gl::WordsArray> fans_, entries_;  ///< of each bending
  int begun_ = 0;                               ///< substeps before the present frame
  gl::Vec4Array drawnPositions_, drawnNormals_;
  MeshTopology topology_;
  MovingLooks looks_;
  gl::Buffer status_;
  StepBlocks<shader::ClothStep> steps_;
  SkinHold hold_;
  gl::Program air_, predict_, stretch_, attach_, sew_, settle_, settleAgain_, show_;
};

}  // namespace

SimulationKind clothKind() {
  return kindOf<ClothParameters>(
      "cloth",
      "A sheet of particles held together by springs, or a mesh of fabric, in wind and over colliders.",
      [](const scene::Object& object, const Setting& setting) {
        const auto& parameters = parametersOf<ClothParameters>(object);
        if (!parameters.hasMesh) return checkSheet(object, setting);
        static_cast<void>(GarmentPlan(object.name, parameters, setting.seed, setting.frameSeconds,
                                      *setting.colliders, boneNamedIn(setting), setting.startTime,
                                      heldBySkinIn(setting)));
      },
      [](const scene::Object& object, const Setting& setting) {
        if (parametersOf<ClothParameters>(object).hasMesh) return makeSimulation<Garment>(object, setting);
        return makeSheet(object, setting);
      });
}

}  // namespace simreel::sim
