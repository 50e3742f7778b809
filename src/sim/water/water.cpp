#include "sim/water/water.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "sim/core/kind.hpp"
#include "sim/grid/picture_file.hpp"
#include "sim/grid/sheet_mesh.hpp"
#include "sim/mesh/buffers.hpp"
#include "sim/mesh/height_field.hpp"
#include "sim/mesh/looks.hpp"
#include "sim/ports/landform.hpp"
#include "sim/water/float_kernels.hpp"
#include "sim/water/ground.hpp"
#include "sim/water/kernels.hpp"
#include "sim/water/plan.hpp"
#include "sim/water/quantities.hpp"
#include "sim/water/skirt.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Returns a description of the water's surface as a height field for objects that collide with it.
HeightPlan heightsOf(const WaterParameters& p, double frameSeconds) {
  MeshParameters plane;
  const glm::vec2 cells(p.size - 1);
  plane.size = {cells.x * p.cell, 0, cells.y * p.cell};
  plane.resolution = p.size;
  plane.position = p.position;
  plane.grip = p.grip;
  return {plane, frameSeconds};
}

/// Returns the object's parameters with the colour and roughness of its material, unless "look" gives them.
WaterParameters coloredLike(const scene::Object& object) {
  WaterParameters p = parametersOf<WaterParameters>(object);
  if (!p.ownDeep && object.materialKeys.contains("color")) p.deep = object.material.color;
  if (!p.ownRoughness && object.materialKeys.contains("roughness")) p.roughness = object.material.roughness;
  return p;
}

class Water : public Simulation, public Landform {
 public:
  Water(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        speedName_(object.name + ".speed"),
        levelName_(object.name + ".level"),
        material_(object.material),
        plan_((WaterKernels::checkLimits(object.name, parametersOf<WaterParameters>(object).size),
               coloredLike(object)),
              object.name, setting.seed, setting.frameSeconds),
        size_(plan_.parameters().size),
        colors_(plan_.parameters().display.colors()),
        palette_(name_ + " colours", plan_.palette()),
        kernels_(name_, plan_, setting.fast) {
    const WaterParameters& p = plan_.parameters();
    material_.roughness = p.roughness;
    ground_.roughness = p.groundRoughness;
    ground_.texture = p.groundTexture;
    const float across = static_cast<float>(p.size.y) / static_cast<float>(p.size.x);
    ground_.textureScale = glm::vec3(p.groundRepeat, p.groundRepeat * across, 1);
    if (p.visible) makeSurfaces();
    if (p.collides) heights_.emplace(name_, heightsOf(p, setting.frameSeconds));
    if (!p.groundObject.empty()) {
      bed_ = setting.wanted<HeightField>(p.groundObject);
      kernels_.follow(*bed_, 0);
    }
    kernels_.fall(setting.startTime, 0);
    if (!plan_.floats().empty()) {
      floats_.emplace(name_, plan_, setting.fast);
      counts_ = gl::Buffer(name_ + " counts", countElements * sizeof(glm::vec4));
      floats_->begin(kernels_.cells(), kernels_.status());
    }
    if (heights_) heights_->setHeights(kernels_.cells(), 0);
    prepareDrawing();
    tallyNow(setting.startTime);
  }

  void step(double time, const StepWatch& watch) override {
    advance(time, watch);
    prepareDrawing();
    tallyNow(time);
    if (heights_) heights_->setHeights(kernels_.cells(), 0);
  }
  /// Objects that fall onto the water need the heights of two consecutive frames, so the full step runs.
  void pass(double time) override {
    if (heights_) return step(time, {});
    advance(time, {});
  }
  void resumed(double time) override {
    prepareDrawing();
    tallyNow(time);
  }
  void visitCheckpointData(CarryOver& carry) override {
    carry.array("cells", kernels_.cells().buffer());
    if (floats_) floats_->visitCheckpointData(carry);
    if (heights_) heights_->visitCheckpointData(carry);
  }

  [[nodiscard]] int stepsPerFrame() const override { return plan_.substeps(); }
  [[nodiscard]] std::string elementName(long element) const override {
    const long cells = static_cast<long>(size_.x) * size_.y;
    if (element >= cells) return fmt::format("float {}", element - cells);
    return fmt::format("cell ({}, {})", element % size_.x, element / size_.x);
  }

  void publish(double /*time*/, Drawables& drawables) const override {
    const WaterParameters& p = plan_.parameters();
    if (p.visible) {
      Surface surface;
      surface.grid = size_;
      surface.vertexCount = size_.x * size_.y;
      surface.indices = &rowIndices_;
      surface.rowIndices = (size_.x - 1) * 6;
      surface.indexCount = (size_.x - 1) * (size_.y - 1) * 6;
      surface.doubleSided = true;
      surface.positions = &kernels_.cells().view();
      surface.heights = &groundHeights_;
      surface.palette = &groundPalette_.view();
      surface.material = &ground_;
      if (bed_ == nullptr) drawables.surfaces.push_back(surface);
      if (sides_ && bed_ == nullptr) {
        Surface sides = sides_->surface();
        sides.material = &sidesMaterial_;
        drawables.surfaces.push_back(sides);
      }
      surface.positions = &kernels_.shown().view();
      surface.heights = &shownHeights_;
      surface.palette = &palette_.view();
      surface.material = &material_;
      drawables.surfaces.push_back(surface);
      if (floats_) floats_->publish(drawables);
    }
    Field field;
    field.name = &name_;
    field.words = &kernels_.shownWords();
    field.cells = Field::Cells::floats;
    field.size = size_;
    field.rowWords = 4 * size_.x;
    field.cellWords = 4;
    field.range = {static_cast<float>(p.display.low), static_cast<float>(p.display.high)};
    field.colors = &colors_;
    field.display = &p.display;
    drawables.fields.push_back(field);
    // These fields are for files and are not drawn over the picture.
    field.display = nullptr;
    field.name = &levelName_;
    field.words = &kernels_.cellWords();
    drawables.fields.push_back(field);
    field.name = &speedName_;
    field.words = &kernels_.shownWords();
    field.firstWord = 2;
    drawables.fields.push_back(field);
  }

  [[nodiscard]] std::vector<StateArray> state() const override {
    std::vector<StateArray> arrays = {{"cells", &kernels_.cells().buffer()}};
    if (floats_) floats_->addState(arrays);
    return arrays;
  }
  [[nodiscard]] std::optional<MeshTable> mesh() const override {
    return sheet(kernels_.shown().buffer().readAll<glm::vec4>());
  }
  /// Returns the ground.
  [[nodiscard]] MeshTable landform() const override {
    auto cells = kernels_.cells().buffer().readAll<glm::vec4>();
    const float base = plan_.look().base;
    for (glm::vec4& cell : cells) cell.y = base + cell.w;
    return sheet(std::move(cells));
  }
  void connect(Outlets& outlets) override {
    if (heights_) outlets.provide(&*heights_);
  }
  [[nodiscard]] const gl::Buffer* status() const override { return &kernels_.status(); }
  [[nodiscard]] std::string remark(int frame) const override {
    const auto words = kernels_.status().readAll<unsigned>();
    return fmt::format(
        "water \"{}\": by frame {} a step took a Courant number of {:.3g}, and more than 0.5 is not "
        "accurate; give more \"substeps\" ({} now), or with \"auto\" the actual \"greatestDepth\" and "
        "\"greatestSpeed\"",
        name_, frame, std::bit_cast<float>(words[2]), plan_.substeps());
  }
  [[nodiscard]] std::string explainLoss(unsigned step, unsigned element) const override {
    return fmt::format(
        "water \"{}\" was lost in substep {} at {}: its level or speed is no longer a number; use more "
        "substeps ({} per frame now, or \"auto\")",
        name_, step, elementName(element), plan_.substeps());
  }
  [[nodiscard]] CountTable counts() const override {
    CountTable table = kernels_.tally().table(
        {"volume", "kineticEnergy", "potentialEnergy", "wetArea", "courant", "fastest", "deepest"});
    if (!floats_) return table;
    table.columns.insert(table.columns.end(), {"displaced", "floatSpeed", "leastUpright", "draft", "floatX",
                                               "floatY", "floatZ"});
    table.steps = &counts_;
    table.elements = countElements;
    return table;
  }
  [[nodiscard]] std::vector<double> measure() const override {
    return measureWater(plan_, kernels_.cells().buffer().readAll<glm::vec4>(),
                        floats_ ? floats_->state().readAll<glm::vec4>() : std::vector<glm::vec4>());
  }

 private:
  /// Returns the mesh of a grid of points whose heights are given; their x and z are set here.
  [[nodiscard]] MeshTable sheet(std::vector<glm::vec4> positions) const {
    const shader::WaterLook look = plan_.look();
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const int row = static_cast<int>(i) / size_.x;
      const int column = static_cast<int>(i) % size_.x;
      positions[i].x = look.left + static_cast<float>(column) * look.cell;
      positions[i].z = look.back + static_cast<float>(row) * look.cell;
    }
    return sheetMesh(size_, positions);
  }
  /// Creates the drawing data other than the cells: two bytes per cell, and the indices of one row.
  void makeSurfaces() {
    const WaterParameters& p = plan_.parameters();
    const shader::WaterLook look = plan_.look();
    groundPalette_ = gl::Vec4Array(name_ + " ground colours", groundPalette(plan_));
    groundColors_ = gl::Buffer::of<std::uint16_t>(name_ + " ground", groundColors(plan_));
    groundColorView_ = gl::Texture::view(name_ + " ground", GL_R16F, groundColors_, sizeof(std::uint16_t));
    rowIndices_ = gl::Buffer::of<unsigned>(name_ + " indices", gridIndices({size_.x, 2}));
    shownHeights_.corner = {look.left, look.back};
    shownHeights_.cell = look.cell;
    groundHeights_ = shownHeights_;
    groundHeights_.base = look.base;
    groundHeights_.component = 3;
    groundHeights_.rim = groundRim(plan_);
    groundHeights_.colors = &groundColorView_;
    for (std::size_t i = 0; i < 4; ++i)
      if (p.sides[i] == WaterBorder::wall) groundHeights_.walls |= 1 << i;
    if (!p.restsOnGround || plan_.firstCells().empty()) return;
    sides_.emplace(name_ + " sides", groundSides(plan_, groundHeights_.walls, groundHeights_.rim));
    sidesMaterial_ = ground_;
    sidesMaterial_.color = p.ground;
    sidesMaterial_.textureScale.y = sidesMaterial_.textureScale.x;
  }
  void advance(double time, const StepWatch& watch) {
    kernels_.startFrame(time);
    if (floats_) floats_->startFrame(time);
    for (int i = 1; i <= plan_.substeps(); ++i) {
      if (bed_ != nullptr) kernels_.follow(*bed_, i);
      kernels_.step(i);
      kernels_.fall(time, i);
      if (floats_) floats_->step(i - 1, kernels_.cells(), kernels_.status());
      if (watch) {
        gl::barrier();
        watch(i);
      }
    }
    gl::barrier();
  }

  /// Measures the current state for the table written next to the frame images.
  void tallyNow(double time) {
    kernels_.tally(time);
    if (!floats_) return;
    // A row has the seven sums that the GPU computes, followed by the quantities of floating bodies.
    constexpr std::size_t sums = 7;
    std::array<float, 4 * countElements> row{};
    kernels_.tally().table({}).steps->read(0, std::as_writable_bytes(std::span(row).first(sums + 1)));
    const std::vector<double> ofFloats = measureFloats(plan_, floats_->state().readAll<glm::vec4>());
    row[0] = static_cast<float>(double{row[0]} -
                                ofFloats[0]);  // The quantity "volume" excludes the displaced volume.
    for (std::size_t i = 0; i < ofFloats.size(); ++i) row.at(sums + i) = static_cast<float>(ofFloats[i]);
    counts_.write(0, std::as_bytes(std::span(row)));
  }

  void prepareDrawing() {
    kernels_.look();
    if (floats_) floats_->prepareDrawing();
  }

  std::string name_, speedName_, levelName_;
  scene::Material material_, ground_, sidesMaterial_;
  WaterPlan plan_;
  glm::ivec2 size_;
  std::vector<glm::vec3> colors_;
  gl::Vec4Array palette_, groundPalette_;
  gl::Buffer groundColors_, rowIndices_;
  gl::Texture groundColorView_;
  GridHeights groundHeights_, shownHeights_;
  std::optional<MeshBuffers> sides_;  ///< Sides of the ground; empty if they are open.
  WaterKernels kernels_;
  std::optional<FloatKernels> floats_;
  const HeightField* bed_ = nullptr;  ///< Heights of the object that is the ground, or null.
  static constexpr int countElements = 4;
  gl::Buffer counts_;                   ///< Table row that includes the quantities of floating bodies.
  std::optional<HeightField> heights_;  ///< Set if the water collides: heights of the surface.
};

}  // namespace

SimulationKind waterKind() {
  return kindOf<WaterParameters>(
      "water", "Shallow water that flows over a terrain, wets and leaves it dry; rain, sources, dams.",
      [](const scene::Object& object, const Setting& setting) {
        const auto& parameters = parametersOf<WaterParameters>(object);
        // If arrays are larger than common devices allow, validation does not create the cells.
        const bool large = parameters.minLargestBufferBytes() > ObjectParameters::commonBlockBytes;
        const WaterPlan plan =
            large ? WaterPlan::withoutCells(parameters, object.name, setting.seed, setting.frameSeconds)
                  : WaterPlan(parameters, object.name, setting.seed, setting.frameSeconds);
        for (std::size_t i = 0; i < parameters.floats.size(); ++i)
          static_cast<void>(
              looksOf(parameters.floats[i].shownAs(object.name), plan.floats().hulls()[i].mesh));
        if (!parameters.groundTexture.empty())
          static_cast<void>(loadPicture(parameters.groundTexture, "texture", 16384));
      },
      makeSimulation<Water>);
}

}  // namespace simreel::sim
