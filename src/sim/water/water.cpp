#include "sim/water/water.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "gl/limits.hpp"
#include "gl/program.hpp"
#include "sim/core/kind.hpp"
#include "sim/core/step_blocks.hpp"
#include "sim/grid/picture_file.hpp"
#include "sim/grid/sheet_mesh.hpp"
#include "sim/grid/tally.hpp"
#include "sim/mesh/height_field.hpp"
#include "sim/mesh/looks.hpp"
#include "sim/water/bindings.hpp"
#include "sim/water/float_kernels.hpp"
#include "sim/water/ground.hpp"
#include "sim/water/plan.hpp"
#include "sim/water/quantities.hpp"

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

/// Before anything is filled: a grid far beyond the limit would first take gigabytes.
void checkLimits(const std::string& name, glm::ivec2 size) {
  const std::int64_t cells = std::int64_t{size.x} * size.y;
  const auto refuse = [&](std::int64_t need, const char* what, std::int64_t max, const char* limit) {
    if (need > max)
      fail(ExitCode::device,
           "water \"{}\" of {}x{} cells needs {} {} in one buffer, this device allows {} ({}); make "
           "\"size\" "
           "smaller",
           name, size.x, size.y, need, what, max, limit);
  };
  refuse(cells * 16, "bytes", gl::limits().storageBlockBytes, "GL_MAX_SHADER_STORAGE_BLOCK_SIZE");
  refuse(cells, "texels", gl::limits().texelBufferTexels, "GL_MAX_TEXTURE_BUFFER_SIZE");
}

std::vector<glm::uvec4> elementsOf(const std::vector<std::uint32_t>& words) {
  std::vector<glm::uvec4> elements((words.size() + 3) / 4, glm::uvec4(0));
  for (std::size_t i = 0; i < words.size(); ++i) elements[i / 4][static_cast<int>(i % 4)] = words[i];
  return elements;
}

/// The vertices as a plane of a mesh that others fall onto.
HeightPlan heightsOf(const WaterParameters& p, double frameSeconds) {
  MeshParameters plane;
  const glm::vec2 cells(p.size - 1);
  plane.size = {cells.x * p.cell, 0, cells.y * p.cell};
  plane.resolution = p.size;
  plane.position = p.position;
  plane.grip = p.grip;
  return {plane, frameSeconds};
}

class Water : public Simulation {
 public:
  Water(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        speedName_(object.name + ".speed"),
        levelName_(object.name + ".level"),
        material_(object.material),
        plan_((checkLimits(object.name, parametersOf<WaterParameters>(object).size),
               parametersOf<WaterParameters>(object)),
              object.name, setting.seed, setting.frameSeconds),
        size_(plan_.parameters().size),
        colors_(plan_.parameters().display.colors()),
        palette_(name_ + " colours", plan_.palette()),
        steps_(name_ + " step", plan_.toldSteps()),
        look_(name_ + " look", sizeof(shader::WaterLook)) {
    const WaterParameters& p = plan_.parameters();
    material_.roughness = p.roughness;
    ground_.roughness = p.groundRoughness;
    ground_.texture = p.groundTexture;
    const float across = static_cast<float>(p.size.y) / static_cast<float>(p.size.x);
    ground_.textureScale = glm::vec3(p.groundRepeat, p.groundRepeat * across, 1);
    for (int i = 0; i < 2; ++i) {
      cells_[i] = gl::Vec4Array(name_ + " cells", plan_.firstCells());
      words_[i] = gl::Texture::view(name_ + " words", GL_RGBA32UI, cells_[i].buffer());
    }
    if (p.visible) makeSurfaces();
    constexpr unsigned fine[4] = {0xffffffffU, 0xffffffffU, 0, 0};
    status_ = gl::Buffer::of<unsigned>(name_ + " status", fine);
    const shader::WaterLook look = plan_.look();
    look_.write(0, std::as_bytes(std::span(&look, 1)));
    makePrograms(setting.fast);
    if (p.collides) heights_.emplace(name_, heightsOf(p, setting.frameSeconds));
    fall(setting.startTime, 0);
    if (!plan_.floats().empty()) {
      floats_.emplace(name_, plan_, setting.fast);
      counts_ = gl::Buffer(name_ + " counts", countElements * sizeof(glm::vec4));
      floats_->begin(cells_[0], status_);
    }
    show();
    tallyNow(setting.startTime);
  }

  void step(double time, const StepWatch& watch) override {
    if (heights_ && !hasHeights_) heights_->take(cells_[0], 0);
    hasHeights_ = true;
    advance(time, watch);
    show();
    tallyNow(time);
    if (heights_) heights_->take(cells_[0], 0);
  }
  /// Others fall between two frames' heights.
  void pass(double time) override {
    if (heights_) return step(time, {});
    advance(time, {});
  }
  void resumed(double time) override {
    show();
    tallyNow(time);
  }
  void carryOver(CarryOver& carry) override {
    carry.array("cells", cells_[0].buffer());
    if (floats_) floats_->carryOver(carry);
    if (!heights_) return;
    carry.number("has heights", hasHeights_);
    heights_->carryOver(carry);
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
      surface.positions = &cells_[0].view();
      surface.heights = &groundHeights_;
      surface.palette = &groundPalette_.view();
      surface.material = &ground_;
      drawables.surfaces.push_back(surface);
      surface.positions = &cells_[1].view();
      surface.heights = &shownHeights_;
      surface.palette = &palette_.view();
      surface.material = &material_;
      drawables.surfaces.push_back(surface);
      if (floats_) floats_->publish(drawables);
    }
    Field field;
    field.name = &name_;
    field.words = &words_[1];
    field.cells = Field::Cells::floats;
    field.size = size_;
    field.rowWords = 4 * size_.x;
    field.cellWords = 4;
    field.range = {static_cast<float>(p.display.low), static_cast<float>(p.display.high)};
    field.colors = &colors_;
    field.display = &p.display;
    drawables.fields.push_back(field);
    // For files only.
    field.display = nullptr;
    field.name = &levelName_;
    field.words = &words_[0];
    drawables.fields.push_back(field);
    field.name = &speedName_;
    field.words = &words_[1];
    field.firstWord = 2;
    drawables.fields.push_back(field);
  }

  [[nodiscard]] std::vector<StateArray> state() const override {
    std::vector<StateArray> arrays = {{"cells", &cells_[0].buffer()}};
    if (floats_) floats_->addState(arrays);
    return arrays;
  }
  [[nodiscard]] std::optional<MeshTable> mesh() const override {
    auto positions = cells_[1].buffer().readAll<glm::vec4>();
    const shader::WaterLook look = plan_.look();
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const int row = static_cast<int>(i) / size_.x;
      const int column = static_cast<int>(i) % size_.x;
      positions[i].x = look.left + static_cast<float>(column) * look.cell;
      positions[i].z = look.back + static_cast<float>(row) * look.cell;
    }
    return sheetMesh(size_, positions);
  }
  void connect(Outlets& outlets) override {
    if (heights_) outlets.provide(&*heights_);
  }
  [[nodiscard]] const gl::Buffer* status() const override { return &status_; }
  [[nodiscard]] std::string remark(int frame) const override {
    const auto words = status_.readAll<unsigned>();
    return fmt::format(
        "water \"{}\": by frame {} a step took a Courant number of {:.3g}, and more than 0.5 is not "
        "accurate; "
        "give more \"substeps\" ({} now), or with \"auto\" the \"greatestDepth\" and \"greatestSpeed\" "
        "that "
        "there are",
        name_, frame, std::bit_cast<float>(words[2]), plan_.substeps());
  }
  [[nodiscard]] std::string explainLoss(unsigned step, unsigned element) const override {
    return fmt::format(
        "water \"{}\" was lost in substep {} at {}: its level or speed is no longer a number; use more "
        "substeps ({} per frame now, or \"auto\")",
        name_, step, elementName(element), plan_.substeps());
  }
  [[nodiscard]] CountTable counts() const override {
    CountTable table = tally_.table(
        {"volume", "kineticEnergy", "potentialEnergy", "wetArea", "courant", "fastest", "deepest"});
    if (!floats_) return table;
    table.columns.insert(table.columns.end(), {"displaced", "floatSpeed", "leastUpright", "draft", "floatX",
                                               "floatY", "floatZ"});
    table.steps = &counts_;
    table.elements = countElements;
    return table;
  }
  [[nodiscard]] std::vector<double> measure() const override {
    return measureWater(plan_, cells_[0].buffer().readAll<glm::vec4>(),
                        floats_ ? floats_->state().readAll<glm::vec4>() : std::vector<glm::vec4>());
  }

 private:
  /// What is drawn beside the cells: two bytes a cell, and the indices of a row.
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
  }
  void makePrograms(bool fast) {
    gl::Defines defines = gl::kernelDefines(fast);
    gl::Defines rows = defines;
    rows.emplace_back("ROWS", std::to_string(rowsEach_));
    const auto& sides = plan_.parameters().sides;
    const bool sea = std::find(sides.begin(), sides.end(), WaterBorder::sea) != sides.end();
    rows.emplace_back("SEA", sea ? "1" : "0");
    step_ = gl::Program::compute(strips_ ? "water/step_strips.comp" : "water/step.comp", rows);
    step_.checkUniformBlock("WaterBlock", sizeof(shader::WaterStep));
    step_.set("size", size_);
    step_.set("rows", rowsEach_);
    show_ = gl::Program::compute("water/look.comp", defines);
    show_.checkUniformBlock("LookBlock", sizeof(shader::WaterLook));
    show_.set("size", size_);
    tally_ = Tally(name_, "water/tally.comp", defines);
    tally_.kernel().set("size", size_);
    tally_.kernel().set("shallow", plan_.look().shallow);
    if (!plan_.anythingFalls()) return;
    stamps_ = gl::WordsArray(name_ + " stroke images", elementsOf(plan_.strokes().imageBits()));
    paint_ = gl::Program::compute("water/paint.comp", defines);
    paint_.set("size", size_);
    defines.emplace_back("DROP", "1");
    drop_ = gl::Program::compute("water/paint.comp", defines);
    drop_.set("size", size_);
  }

  void advance(double time, const StepWatch& watch) {
    std::vector<shader::WaterStep> told;
    told.reserve(static_cast<std::size_t>(plan_.toldSteps()));
    for (int i = 0; i < plan_.toldSteps(); ++i) told.push_back(plan_.stepAt(time, i));
    steps_.upload(told);
    if (floats_) floats_->startFrame(time);
    for (int i = 1; i <= plan_.substeps(); ++i) {
      steps_.bind(plan_.toldSteps() > 1 ? static_cast<std::size_t>(i - 1) : 0);
      status_.bindStorage(shader::statusBinding);
      cells_[0].bindInput(shader::water::cellsBinding);
      cells_[1].bindState(shader::water::nextCellsBinding);
      step_.set("stepNumber", i);
      gl::barrier();
      const int parts = (size_.y - 1) / rowsEach_ + 1;
      step_.dispatch(strips_ ? (size_.x - 1) / 28 * 32 + 32 : size_.x, parts);
      std::swap(cells_[0], cells_[1]);
      std::swap(words_[0], words_[1]);
      fall(time, i);
      if (floats_) floats_->step(i - 1, cells_[0], status_);
      if (watch) {
        gl::barrier();
        watch(i);
      }
    }
    gl::barrier();
  }

  void fall(double time, int step) {
    if (!plan_.anythingFalls()) return;
    const WaterFalls falls = plan_.fallsAt(time, step);
    for (const shader::Stroke& stroke : falls.strokes) {
      const glm::ivec4 box = Strokes::box(stroke, size_);
      setStroke(paint_, stroke, box);
      raise(paint_, box);
    }
    for (const shader::WaterDrop& drop : falls.drops) {
      const glm::ivec4 box = plan_.box(drop);
      drop_.set("drop.center", drop.center);
      drop_.set("drop.perRadius2", drop.perRadius2);
      drop_.set("drop.height", drop.height);
      drop_.set("drop.shallow", drop.shallow);
      drop_.set("strokeBox", box);
      raise(drop_, box);
    }
  }

  void raise(const gl::Program& program, glm::ivec4 box) {
    if (box.z <= 0 || box.w <= 0) return;
    cells_[0].bindState(shader::water::cellsBinding);
    stamps_.bindInput(shader::water::stampsBinding);
    gl::barrier();
    program.dispatch(box.z, box.w);
  }

  /// What is measured of the present state, for the table beside the frames.
  void tallyNow(double time) {
    steps_.upload(std::vector<shader::WaterStep>{plan_.stepAt(time)});
    steps_.bind(0);
    cells_[0].bindInput(shader::water::cellsBinding);
    tally_.take(waterSumFactors(plan_.parameters()), glm::vec4(1));
    if (!floats_) return;
    // A row has the seven sums that the device makes, then the quantities of floats.
    constexpr std::size_t sums = 7;
    std::array<float, 4 * countElements> row{};
    tally_.table({}).steps->read(0, std::as_writable_bytes(std::span(row).first(sums + 1)));
    const std::vector<double> ofFloats = measureFloats(plan_, floats_->state().readAll<glm::vec4>());
    row[0] = static_cast<float>(double{row[0]} - ofFloats[0]);  // as the quantity of that name
    for (std::size_t i = 0; i < ofFloats.size(); ++i) row.at(sums + i) = static_cast<float>(ofFloats[i]);
    counts_.write(0, std::as_bytes(std::span(row)));
  }

  void show() {
    look_.bindUniform(shader::stepBinding, 0, sizeof(shader::WaterLook));
    cells_[0].bindInput(shader::water::cellsBinding);
    cells_[1].bindState(shader::water::shownBinding);
    gl::barrier();
    show_.dispatch(size_.x, size_.y);
    gl::barrier();
    if (floats_) floats_->show();
  }

  std::string name_, speedName_, levelName_;
  scene::Material material_, ground_;
  WaterPlan plan_;
  glm::ivec2 size_;
  std::vector<glm::vec3> colors_;
  /// By strips (step_strips.comp), or by columns, one an invocation.
  bool strips_ = gl::memoryPath() == gl::MemoryPath::storage;
  /// Of a strip or column: the more, the less is computed twice; fewer where there is little to share out.
  int rowsEach_ = strips_ ? std::clamp(size_.x * size_.y / 60000, 4, 32) : 8;
  gl::Vec4Array cells_[2];  ///< now, and where the next step writes: until then what is drawn and shown
  gl::Texture words_[2];    ///< of both
  gl::Vec4Array palette_, groundPalette_;
  gl::Buffer groundColors_, rowIndices_;
  gl::Texture groundColorView_;
  GridHeights groundHeights_, shownHeights_;
  gl::WordsArray stamps_;
  gl::Buffer status_;
  StepBlocks<shader::WaterStep> steps_;
  gl::Buffer look_;
  gl::Program step_, paint_, drop_, show_;
  std::optional<FloatKernels> floats_;
  Tally tally_;
  static constexpr int countElements = 4;
  gl::Buffer counts_;                   ///< with the quantities of floats
  std::optional<HeightField> heights_;  ///< of water that collides: levels
  bool hasHeights_ = false;             ///< whether they begin with the first frame
};

}  // namespace

SimulationKind waterKind() {
  return kindOf<WaterParameters>(
      "water", "Shallow water that flows over a terrain, wets and leaves it dry; rain, sources, dams.",
      [](const scene::Object& object, const Setting& setting) {
        const auto& parameters = parametersOf<WaterParameters>(object);
        // Arrays of what no common device has room for are not made for a look at them.
        const bool large = parameters.leastBlockBytes() > ObjectParameters::commonBlockBytes;
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
