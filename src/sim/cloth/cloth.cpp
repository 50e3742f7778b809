#include "sim/cloth/cloth.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "gl/element_array.hpp"
#include "gl/limits.hpp"
#include "gl/program.hpp"
#include "sim/body/bones.hpp"
#include "sim/cloth/plan.hpp"
#include "sim/cloth/quantities.hpp"
#include "sim/cloth/skin_hold.hpp"
#include "sim/cloth/thin.hpp"
#include "sim/collide/distance_fields.hpp"
#include "sim/contact/lock_step.hpp"
#include "sim/contour/walls.hpp"
#include "sim/core/kind.hpp"
#include "sim/core/step_blocks.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/grid/sheet_mesh.hpp"
#include "sim/mesh/height_field.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace simreel::shader::cloth {
#include "glsl/cloth/bindings.glsl"
#include "glsl/cloth/relax_tile.glsl"
#include "glsl/cloth/segment_links.glsl"
}  // namespace simreel::shader::cloth

namespace simreel::sim {

namespace {

class Cloth : public Simulation, public LockStep {
 public:
  Cloth(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        material_(object.material),
        plan_(parametersOf<ClothParameters>(object).inStep(setting.together<LockStep>().steps),
              setting.seed, setting.frameSeconds, *setting.colliders, boneNamedIn(setting),
              setting.startTime, heldBySkinIn(setting)),
        size_(plan_.parameters().size),
        constrained_(plan_.parameters().constrained()),
        keeps_(plan_.parameters().keepsEnergy()),
        heights_(setting.find<HeightField>()),
        frameSeconds_(setting.frameSeconds) {
    checkLimits();
    const ClothParameters& p = plan_.parameters();
    if (p.pinsByDefault)
      infoLineOnce(
          fmt::format("cloth \"{}\": its last row is pinned (default); \"pins\": [] lets it fall", name_));
    if (!p.walls.empty()) {
      walls_ = setting.wanted<Walls>(p.walls);
      walls_->checkReach(name_, p.margin);
    }
    if (p.hasAir) wind_ = setting.wanted<FluidWind>(p.air.fluid);
    meshes_ = MeshTouch(name_, setting.find<DistanceFields>(), plan_.substeps(), plan_.substepSeconds());
    const auto positions = plan_.firstPositions();
    positions_[0] = gl::Vec4Array(name_ + " positions", positions);
    positions_[1] = gl::Vec4Array(name_ + " next positions", positions);
    velocities_[0] = gl::Vec4Array(name_ + " velocities", plan_.firstVelocities());
    makeConstrained();
    indices_ = gl::Buffer::of<unsigned>(name_ + " indices", gridIndices(size_));
    const unsigned fine[4] = {0xffffffffU, 0xffffffffU, 0, 0};
    status_ = gl::Buffer::of<unsigned>(name_ + " status", fine);
    makePrograms(setting.fast);
    steps_ = StepBlocks<shader::ClothStep>(name_ + " steps", plan_.substeps());
    thin_ = ThinColliders(name_, "cloth/thin.comp", plan_.thinCount(), size_.x * size_.y, setting.fast);
    if (thin_.there()) thin_.kernel().set("size", size_);
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
    const std::vector<unsigned> corners = gridIndices(size_);
    ContactPart part{plan_.firstPositions(), {}, p.contactThickness(p.spacing), p.contact.friction, {}};
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
      part.faces.emplace_back(corners[i], corners[i + 1], corners[i + 2]);
    part.name = name_;
    return part;
  }
  void beginFrame(double time) override {
    steps_.upload(plan_.frame(time));
    meshes_.beginFrame(time);
    hold_.beginFrame(plan_.skinPins(), time, time + frameSeconds_);
  }
  void predict(int substep) override {
    status_.bindStorage(shader::statusBinding);
    steps_.bind(static_cast<std::size_t>(substep));
    positions_[0].bindInput(shader::cloth::positionsBinding);
    positions_[1].bindState(shader::cloth::nextPositionsBinding);
    tellColliders(touching(), substep);
    if (wind_ != nullptr) wind_->bind();
    gl::barrier();
    hold_.hold(velocities_[0], substep, plan_.substeps());
    if (constrained_) {
      constrain();
    } else {
      velocities_[0].bindState(shader::cloth::velocitiesBinding);
      step_.dispatch(size_.x, size_.y);
    }
    predicted_ = true;
    thin_.fend(positions_[0], positions_[1], velocities(), size_.x, size_.y);
    if (!plan_.parameters().hasContact) return;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    left_.copyFrom(positions_[1]);
  }
  [[nodiscard]] Contact::Part arrays() const override {
    return {&positions_[0], &positions_[1], &velocities(), trendy() ? &trends_ : nullptr};
  }
  void settle(int substep) override {
    steps_.bind(static_cast<std::size_t>(substep));
    positions_[0].bindInput(shader::cloth::positionsBinding);
    positions_[1].bindState(shader::cloth::nextPositionsBinding);
    velocities().bindState(shader::cloth::velocitiesBinding);
    left_.bindInput(shader::cloth::leftBinding);
    status_.bindStorage(shader::statusBinding);
    tellColliders(settle_, substep);
    gl::barrier();
    settle_.dispatch(size_.x * size_.y);
    thin_.fend(positions_[0], positions_[1], velocities(), size_.x, size_.y);
  }
  void finish() override {
    std::swap(positions_[0], positions_[1]);
    if (trendy()) std::swap(velocities_[0], velocities_[1]);
    predicted_ = false;
  }
  void endFrame(double time) override {
    gl::barrier();
    time_ = time + frameSeconds_;
  }

  [[nodiscard]] int stepsPerFrame() const override { return plan_.substeps(); }
  [[nodiscard]] std::string elementName(long element) const override {
    return fmt::format("particle ({}, {})", element % size_.x, element / size_.x);
  }

  void publish(double /*time*/, Drawables& drawables) const override {
    Surface surface;
    surface.positions = &positions_[0].view();
    surface.grid = size_;
    surface.vertexCount = size_.x * size_.y;
    surface.indices = &indices_;
    surface.indexCount = (size_.x - 1) * (size_.y - 1) * 6;
    surface.doubleSided = true;
    surface.material = &material_;
    drawables.surfaces.push_back(surface);
  }

  void carryOver(CarryOver& carry) override {
    plan_.carryOver(carry);
    carry.array("positions", positions_[0].buffer());
    carry.array("velocities", velocities_[0].buffer());
    if (trendy()) carry.array("trends", trends_.buffer());
  }
  void resumed(double time) override { time_ = time; }

  [[nodiscard]] std::vector<StateArray> state() const override {
    std::vector<StateArray> arrays = {{"positions", &positions_[0].buffer()},
                                      {"velocities", &velocities_[0].buffer()}};
    if (trendy()) arrays.push_back({"trends", &trends_.buffer()});
    return arrays;
  }
  [[nodiscard]] PointTable points() const override {
    const auto positions = positions_[0].buffer().readAll<glm::vec4>();
    const auto velocities = shownVelocities(positions);
    PointTable table{{"x", "y", "z", "vx", "vy", "vz"}, {}};
    table.values.reserve(positions.size() * table.columns.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
      table.values.insert(table.values.end(), {positions[i].x, positions[i].y, positions[i].z,
                                               velocities[i].x, velocities[i].y, velocities[i].z});
    return table;
  }
  [[nodiscard]] std::optional<MeshTable> mesh() const override {
    return sheetMesh(size_, positions_[0].buffer().readAll<glm::vec4>());
  }
  [[nodiscard]] const gl::Buffer* status() const override { return &status_; }
  [[nodiscard]] std::vector<double> measure() const override {
    const auto positions = positions_[0].buffer().readAll<glm::vec4>();
    return measureCloth(plan_.parameters(), positions, shownVelocities(positions), time_, plan_.softness());
  }
  [[nodiscard]] std::string explainLoss(unsigned step, unsigned element) const override {
    const auto width = static_cast<unsigned>(size_.x);
    const bool fabric = plan_.parameters().hasFabric;
    return fmt::format(
        "cloth \"{}\" blew up in substep {} at particle ({}, {}): its position or velocity is no longer a "
        "sensible number; use more substeps ({} per frame now, or \"auto\"){}, {}",
        name_, step, element % width, element / width, plan_.substeps(),
        !constrained_ ? " or \"solver\": \"constraints\"" : "",
        fabric ? "or a heavier fabric" : "lower the stiffness or raise the mass");
  }

 private:
  /// Whether constraints have a trend: those that keep energy are forces.
  [[nodiscard]] bool trendy() const { return constrained_ && !keeps_; }
  [[nodiscard]] std::vector<glm::vec4> shownVelocities(const std::vector<glm::vec4>& positions) const {
    return actualVelocities(positions, velocities_[0].buffer().readAll<glm::vec4>(),
                            trendy() ? trends_.buffer().readAll<glm::vec4>() : std::vector<glm::vec4>());
  }

  /// Velocities as far as the substep has come.
  [[nodiscard]] const gl::Vec4Array& velocities() const {
    return velocities_[trendy() && predicted_ ? 1 : 0];
  }

  /// What constraints and contact need besides.
  void makeConstrained() {
    const int count = size_.x * size_.y;
    if (trendy()) {
      velocities_[1] = gl::Vec4Array(name_ + " next velocities", count);
      trends_ = gl::Vec4Array(name_ + " trends", count);
      if (bends() && !inLines_) between_ = gl::Vec4Array(name_ + " between", count);
    }
    if (plan_.parameters().hasContact) left_ = gl::Vec4Array(name_ + " left", count);
  }

  /// Before anything is filled: a cloth far beyond the limit would first take gigabytes.
  void checkLimits() const {
    const auto bytes = std::int64_t{24} * (size_.x - 1) * (size_.y - 1);
    const std::int64_t max = gl::limits().storageBlockBytes;
    if (bytes > max)
      fail(ExitCode::device,
           "cloth \"{}\" of {}x{} particles needs {} bytes of indices, this device allows {} in one buffer "
           "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE); make it smaller",
           name_, size_.x, size_.y, bytes, max);
  }

  void makePrograms(bool fast) {
    gl::Defines defines = gl::kernelDefines(fast);
    hold_ = SkinHold(name_, plan_.skinPins(), defines);
    const auto make = [&](gl::Program& program, const char* path) {
      program = gl::Program::compute(path, defines);
      program.set("size", size_);
    };
    const auto define = [&](const char* name, bool on) {
      defines.emplace_back(name, on ? "true" : "false");
    };
    meshes_.addDefines(defines);
    defines.emplace_back("HEIGHTS", heights_ != nullptr ? "1" : "0");
    addWallDefines(defines, walls_);
    if (gl::memoryPath() == gl::MemoryPath::texel)
      defines.emplace_back("COLLIDERS", std::to_string(plan_.colliderCount()));
    addWindDefines(defines, wind_);
    defines.emplace_back("DAMPED", plan_.parameters().damped() ? "1" : "0");
    define("AIR", plan_.parameters().hasAir);
    define("FABRIC", plan_.parameters().hasFabric);
    defines.emplace_back("KEEPS", keeps_ ? "1" : "0");
    if (constrained_) {
      rows_ = lineSolver(defines, "ROWS", size_.x);
      columns_ = lineSolver(defines, "LAST", size_.y);
    }
    if (plan_.parameters().hasContact) make(settle_, "cloth/settle.comp");
    if (trendy()) {
      makeRelaxing(fast);
    } else {
      define("SPRINGS", !keeps_);
      define("CONTACT", !keeps_);
      make(step_, "cloth/step.comp");
    }
    step_.checkUniformBlock("StepBlock", sizeof(shader::ClothStep));
    if (wind_ != nullptr) wind_->tell(step_);
    meshes_.check(touching());
  }

  /// The kernels that predict and relax pairs, which meet nothing.
  void makeRelaxing(bool fast) {
    gl::Defines defines = gl::kernelDefines(fast);
    for (const char* other : {"HEIGHTS", "WALLS", "MESHES"}) defines.emplace_back(other, "0");
    defines.emplace_back("DAMPED", plan_.parameters().damped() ? "1" : "0");
    defines.emplace_back("AIR", plan_.parameters().hasAir ? "true" : "false");
    defines.emplace_back("FABRIC", plan_.parameters().hasFabric ? "true" : "false");
    const char* path = inLines_ ? "cloth/constrain_lines.comp" : "cloth/relax.comp";
    gl::Defines first = defines;
    gl::Defines others = defines;
    (inLines_ ? first : others).emplace_back(inLines_ ? "FIRST" : "BENDS", "1");
    addWindDefines(first, wind_);
    step_ = gl::Program::compute(path, first);
    step_.set("size", size_);
    if (!inLines_ && !bends()) return;
    constrain_ = gl::Program::compute(path, others);
    constrain_.set("size", size_);
  }

  /// Of lines of so many particles; a group has as many of them as it has room for, up to a software
  /// driver's vector.
  [[nodiscard]] gl::Program lineSolver(gl::Defines defines, const char* kind, int particles) const {
    constexpr int groupSize = 1024;  // every device has it
    constexpr int vector = 8;
    const int segments = segmentsOf(particles);
    const int lines = std::clamp(groupSize / segments, 1, vector);
    defines.emplace_back(kind, "1");
    defines.emplace_back("LINES", std::to_string(lines));
    defines.emplace_back("SEGMENTS", std::to_string(segments));
    gl::Program program = gl::Program::compute("cloth/solve_lines.comp", defines);
    program.set("size", size_);
    program.set("lines", size_.x * size_.y / particles);
    return program;
  }

  /// What is no shape, which a kernel that touches colliders is to know.
  void tellColliders(const gl::Program& program, int substep) const {
    const float margin = plan_.parameters().margin;
    meshes_.bind(substep);
    if (heights_ != nullptr) {
      heights_->bind();
      heights_->tell(program, substep, plan_.substeps(), margin, 0.0F);
    }
    if (walls_ != nullptr) {
      walls_->bind();
      walls_->tell(program, plan_.substepSeconds(), margin, 0.0F);
    }
  }

  /// The kernel that touches colliders.
  [[nodiscard]] const gl::Program& touching() const { return constrained_ ? columns_ : step_; }

  /// From where the particles would go to where they may.
  void constrain() {
    if (keeps_) {
      velocities_[0].bindState(shader::cloth::velocitiesBinding);
      step_.dispatch(size_.x, size_.y);
    } else {
      velocities_[0].bindInput(shader::cloth::velocitiesBinding);
      velocities_[1].bindState(shader::cloth::aimsBinding);
      trends_.bindInput(shader::cloth::trendsBinding);
      if (inLines_)
        relaxInLines();
      else
        relaxInTiles();
    }
    gl::barrier();
    rows_.dispatch(size_.y, segmentsOf(size_.x));
    gl::barrier();
    velocities_[trendy() ? 1 : 0].bindState(shader::cloth::velocitiesBinding);
    if (trendy()) trends_.bindState(shader::cloth::trendsBinding);
    if (heights_ != nullptr) heights_->bind();
    columns_.dispatch(size_.x, segmentsOf(size_.y));
  }

  void relaxInLines() const {
    const auto families = relaxedFamilies(plan_.parameters());
    for (const SpringFamily& family : families) {
      const bool first = &family == families.data();
      const gl::Program& program = first ? step_ : constrain_;
      const int lines = lineCount(family.reach);
      program.set("reach", family.reach);
      program.set("kind", family.kind);
      program.set("lines", lines);
      if (!first) gl::barrier();
      program.dispatch(lines);
    }
  }

  void relaxInTiles() const {
    using namespace shader::cloth;
    if (!bends()) {
      dispatchTiles(step_, relaxDiagonalHalo);
      return;
    }
    between_.bindState(nextPositionsBinding);
    dispatchTiles(step_, relaxDiagonalHalo);
    gl::barrier();
    between_.bindInput(positionsBinding);
    positions_[1].bindState(nextPositionsBinding);
    dispatchTiles(constrain_, relaxBendHalo);
    positions_[0].bindInput(positionsBinding);
  }
  /// Tiles that leave all of the sheet, of which each leaves what is `halo` from its sides.
  void dispatchTiles(const gl::Program& program, int halo) const {
    using namespace shader::cloth;
    const glm::ivec2 tile(relaxTileX, relaxTileY);
    const glm::ivec2 tiles = (size_ + relaxBefore - halo - 1) / (tile - 2 * halo) + 1;
    program.dispatch(tiles.x * (tile.x / 2), tiles.y * tile.y);
  }
  /// By constraints.
  [[nodiscard]] bool bends() const { return relaxedFamilies(plan_.parameters()).size() > 2; }

  static int segmentsOf(int particles) {
    return (particles - 1 + shader::cloth::segmentLinks - 1) / shader::cloth::segmentLinks;
  }

  /// Lines of particles that a family ties together: one begins wherever nothing lies a reach before.
  [[nodiscard]] int lineCount(glm::ivec2 reach) const {
    if (reach.y == 0) return std::min(reach.x, size_.x) * size_.y;
    if (reach.x == 0) return std::min(reach.y, size_.y) * size_.x;
    return size_.x + size_.y - 1;
  }

  std::string name_;
  scene::Material material_;
  ClothPlan plan_;
  glm::ivec2 size_;
  bool constrained_;  ///< by XPBD; else springs
  bool keeps_;        ///< energy (glsl/cloth/keeping.glsl)
  /// Whether an invocation takes a line of pairs (constrain_lines.comp) instead of one, and the first also
  /// steps.
  bool inLines_ = gl::memoryPath() == gl::MemoryPath::texel;
  const HeightField* heights_;       ///< null: none in the scene
  const Walls* walls_ = nullptr;     ///< null: it meets none
  const FluidWind* wind_ = nullptr;  ///< null: no fluid's is in its air
  MeshTouch meshes_;
  ThinColliders thin_;
  double frameSeconds_;
  double time_ = 0;             ///< s, of the present state
  gl::Vec4Array positions_[2];  ///< now, and where the next substep writes
  gl::Vec4Array between_;       ///< positions after the diagonal constraints, where those of bending follow
  gl::Vec4Array velocities_[2];  ///< now, and of constraints where the next substep writes
  gl::Vec4Array trends_;         ///< of constraints (glsl/cloth/motion.glsl)
  gl::Vec4Array left_;           ///< of cloth in contact: where it was left before contact pushed
  bool predicted_ = false;       ///< between predict() and finish()
  gl::Buffer indices_;
  gl::Buffer status_;
  StepBlocks<shader::ClothStep> steps_;
  SkinHold hold_;
  gl::Program step_, constrain_, rows_, columns_, settle_;
};

}  // namespace

std::unique_ptr<Simulation> makeSheet(const scene::Object& object, const Setting& setting) {
  return makeSimulation<Cloth>(object, setting);
}

void checkSheet(const scene::Object& object, const Setting& setting) {
  static_cast<void>(ClothPlan(parametersOf<ClothParameters>(object), setting.seed, setting.frameSeconds,
                              *setting.colliders, boneNamedIn(setting), setting.startTime,
                              heldBySkinIn(setting)));
}

}  // namespace simreel::sim
