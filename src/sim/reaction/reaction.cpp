#include "sim/reaction/reaction.hpp"

#include "base/error.hpp"
#include "sim/core/frame_observer.hpp"
#include "sim/core/kind.hpp"
#include "sim/core/moments.hpp"
#include "sim/core/retunable.hpp"
#include "sim/gray_scott/quantities.hpp"
#include "sim/grid/field_values.hpp"
#include "sim/grid/tally.hpp"
#include "sim/mesh_cells/painted.hpp"
#include "sim/reaction/kernels.hpp"
#include "sim/reaction/presets.hpp"
#include "sim/reaction/rule/model.hpp"
#include "sim/volume/isosurface.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

struct ReactionSums {
  static constexpr auto file = "reaction/tally.comp";
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"columns", int> columns;
  gl::Uniform<"species", int> species;
  gl::In<"cells"> cells;
  gl::Out<"laneSums"> laneSums;
};

class Reaction : public Simulation, public FrameStarter, public Retunable {
 public:
  Reaction(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        material_(object.material),
        frameSeconds_(setting.frameSeconds),
        links_(setting.links),
        plan_(parametersOf<ReactionParameters>(object), object.name, setting.seed, setting.frameSeconds),
        kernels_(name_, plan_, setting.fast),
        colors_(plan_.parameters().display.colors()),
        first_(plan_.stepAt(setting.startTime) - plan_.parameters().presteps),
        now_(plan_.stepAt(setting.startTime)),
        shownTime_(setting.startTime) {
    for (const ReactionSpecies& species : plan_.parameters().species)
      speciesNames_.push_back(name_ + "." + species.name);
    makeTally(setting.fast);
    if (plan_.links() != nullptr) painted_.emplace(name_, plan_.mesh(), plan_.cells(), colors_);
    if (isVolume())
      isosurface_.emplace(name_, shapeOf(plan_.parameters()),
                          plan_.parameters().surface.color.empty() ? std::vector<glm::vec3>() : colors_);
    kernels_.setValues(plan_.valuesAt(0));
    prestep(setting);
    for (const auto& painted : plan_.strokesAt(setting.startTime, 0)) kernels_.paint(painted);
    gl::barrier();
    look(setting.startTime);
  }

  void frameStarts() override {
    const std::vector<ReactionParameter>& parameters = plan_.parameters().parameters;
    if (!plan_.parameters().readsFields()) return;
    for (std::size_t i = 0; i < parameters.size(); ++i)
      if (const std::string& field = parameters[i].field; !field.empty())
        kernels_.setMap(static_cast<int>(i), fieldNamed(*links_, field), layersOf(field));
    if (!std::exchange(hasRead_, true)) look(shownTime_);
  }
  void step(double time, const StepWatch& watch) override {
    advance(time, watch);
    look(time + frameSeconds_);
  }
  void pass(double time) override { advance(time, {}); }
  void resumed(double time) override {
    now_ = plan_.stepAt(time);
    kernels_.setValues(plan_.valuesAt(time));
    look(time);
  }
  bool grow() override { return isosurface_ && isosurface_->grow(); }
  [[nodiscard]] std::optional<MeshTable> mesh() const override {
    if (painted_) return painted_->table(plan_.parameters().mesh->model(shownTime_));
    return isosurface_ ? std::optional(isosurface_->mesh()) : std::nullopt;
  }

  [[nodiscard]] bool retune(const scene::Parameters& now) override {
    return plan_.retune(dynamic_cast<const ReactionParameters&>(now));
  }

  [[nodiscard]] int stepsPerFrame() const override { return plan_.parameters().steps; }
  [[nodiscard]] std::string elementName(long element) const override {
    const long columns = kernels_.columns(), rows = this->rows();
    const long plane = element / columns / rows, row = element / columns % rows, x = element % columns * 4;
    return fmt::format("{} of cells {} to {}", speciesName(plane), placeName(x, row),
                       placeName(std::min<long>(x + 3, plan_.parameters().size.x - 1), row));
  }

  void publish(double time, Drawables& drawables) const override {
    const ReactionParameters& p = plan_.parameters();
    const int planeWords = 4 * kernels_.columns() * rows();
    Field field;
    field.name = &name_;
    field.words = &kernels_.wordsOf(plan_.program().shown);
    field.cells = Field::Cells::floats;
    field.size = {p.size.x, rows()};
    field.rowWords = 4 * kernels_.columns();
    field.firstWord = planeWords * plan_.program().shown.plane;
    field.cellWords = 1;
    field.range = {static_cast<float>(p.display.low), static_cast<float>(p.display.high)};
    field.colors = &colors_;
    field.display = p.space() == RuleSpace::plane ? &p.display : nullptr;
    drawables.fields.push_back(field);
    // These fields are for files and are not drawn over the picture.
    field.words = &kernels_.words();
    field.display = nullptr;
    for (std::size_t i = 0; i < speciesNames_.size(); ++i) {
      field.name = &speciesNames_[i];
      field.firstWord = planeWords * static_cast<int>(i);
      drawables.fields.push_back(field);
    }
    if (!isosurface_ && !painted_) return;
    Surface surface = isosurface_ ? isosurface_->surface() : painted_->surface();
    if (painted_) {
      surface.model = p.mesh->model(time);
      surface.doubleSided = p.mesh->shape == ReactionMesh::Shape::plane;
    }
    surface.material = &material_;
    drawables.surfaces.push_back(surface);
  }

  [[nodiscard]] double jumpedBy(double time) const override {
    const auto& mesh = plan_.parameters().mesh;
    return mesh ? lastJump(time, mesh->position, mesh->rotation, mesh->scale) : Simulation::jumpedBy(time);
  }

  void visitCheckpointData(CarryOver& carry) override {
    carry.array("cells", kernels_.cells().buffer());
    // The displayed value may depend on the fields read from other objects.
    if (plan_.parameters().readsFields()) carry.array("fields", kernels_.maps().buffer());
  }
  [[nodiscard]] std::vector<StateArray> state() const override {
    return {{"cells", &kernels_.cells().buffer()}};
  }
  [[nodiscard]] const gl::Buffer* status() const override { return &kernels_.status(); }
  [[nodiscard]] std::string explainLoss(unsigned step, unsigned element) const override {
    const auto width = static_cast<unsigned>(plan_.parameters().size.x);
    const auto height = static_cast<unsigned>(rows());
    return fmt::format(
        "reaction \"{}\": {} of cell {} is infinite or no number after step {}; a smaller \"dt\" or "
        "another "
        "\"method\" may keep it finite",
        name_, speciesName(element / width / height), placeName(element % width, element / width % height),
        static_cast<int>(step) + 1 - static_cast<int>(first_));
  }

  [[nodiscard]] CountTable counts() const override {
    std::vector<const char*> names;
    names.reserve(countNames_.size());
    for (const std::string& name : countNames_) names.push_back(name.c_str());
    return tally_.table(std::move(names));
  }
  [[nodiscard]] std::vector<double> measure() const override {
    Drawables drawables;
    publish(0, drawables);
    std::vector<float> values = fieldValues(drawables.fields.front());
    const auto count = static_cast<double>(values.size());
    double sum = 0, squares = 0;
    for (const float value : values) sum += static_cast<double>(value);
    for (const float value : values) {
      const double d = static_cast<double>(value) - sum / count;
      squares += d * d;
    }
    const auto [minimum, maximum] = std::minmax_element(values.begin(), values.end());
    const double maximumOf = *maximum, minimumOf = *minimum;
    if (isVolume()) {  // The wavelength is measured in the middle layer.
      const glm::ivec2 size = plan_.parameters().size;
      const auto layer = static_cast<std::ptrdiff_t>(size.x) * size.y;
      values.erase(values.begin(), values.begin() + layer * (plan_.parameters().depth / 2));
      values.resize(static_cast<std::size_t>(layer));
    }
    return {sum / count, minimumOf, maximumOf, std::sqrt(squares / count),
            plan_.links() != nullptr ? 0 : dominantWavelength(values, plan_.parameters().size)};
  }

 private:
  [[nodiscard]] bool isVolume() const { return plan_.parameters().space() == RuleSpace::volume; }
  /// Returns the total number of rows of cells in all layers.
  [[nodiscard]] int rows() const { return plan_.parameters().size.y * plan_.parameters().depth; }
  [[nodiscard]] std::string placeName(long x, long row) const {
    const long height = plan_.parameters().size.y;
    if (plan_.links() != nullptr) return fmt::format("{}", x);
    return isVolume() ? fmt::format("({}, {}, {})", x, row % height, row / height)
                      : fmt::format("({}, {})", x, row);
  }
  [[nodiscard]] static IsosurfaceShape shapeOf(const ReactionParameters& p) {
    return {glm::ivec3(p.size, p.depth), p.cellWidth(), p.surface.position, p.surface.closed,
            p.surface.draw == ReactionSurface::Draw::cubes};
  }
  [[nodiscard]] VolumeValues valuesOf(const RulePlane& plane) const {
    const int row = 4 * kernels_.columns();
    return {&kernels_.wordsOf(plane), row, row * rows() * plane.plane};
  }

  /// Returns the number of species in the table written next to the frame images.
  [[nodiscard]] int counted() const {
    return std::min(static_cast<int>(plan_.parameters().species.size()), 4);
  }
  void makeTally(bool fast) {
    const ReactionParameters& p = plan_.parameters();
    const int species = counted();
    tally_ = Tally(name_, gl::kernelDefines(fast));
    sums_ = gl::Kernel<ReactionSums>(gl::kernelDefines(fast));
    for (int i = 0; i < 4; ++i) {
      const std::string& name = p.species[static_cast<std::size_t>(i % species)].name;
      countNames_.push_back("mean_" + name + (i < species ? "" : "^" + std::to_string(i / species + 1)));
    }
    for (int i = 0; i < species; ++i)
      countNames_.push_back("most_" + p.species[static_cast<std::size_t>(i)].name);
  }
  /// Computes the displayed and counted values of the current state, which is the state at `time`
  /// (seconds).
  void look(double time) {
    kernels_.prepareDrawing(now_, first_);
    const ReactionParameters& p = plan_.parameters();
    shownTime_ = time;
    const glm::vec2 range(static_cast<float>(p.display.low), static_cast<float>(p.display.high));
    sums_.dispatch(Tally::lanes, {.size = glm::ivec2(p.size.x, rows()),
                                  .columns = kernels_.columns(),
                                  .species = counted(),
                                  .cells = kernels_.cells(),
                                  .laneSums = tally_.laneSums()});
    tally_.join(glm::vec4(static_cast<float>(1 / (static_cast<double>(p.size.x) * rows()))), glm::vec4(1));
    const RuleProgram& program = plan_.program();
    if (isosurface_)
      isosurface_->make(valuesOf(program.shown), p.levelAt(time), {valuesOf(program.tint), range});
    if (painted_)
      painted_->paint(kernels_.wordsOf(program.shown), valuesOf(program.shown).firstWord, range);
  }

  [[nodiscard]] std::string speciesName(long plane) const {
    const auto& species = plan_.parameters().species;
    return plane < static_cast<long>(species.size())
               ? "\"" + species[static_cast<std::size_t>(plane)].name + "\""
               : "a species";
  }

  void advance(double time, const StepWatch& watch) {
    const int steps = plan_.parameters().steps;
    now_ = plan_.stepAt(time);
    kernels_.setValues(plan_.valuesAt(time));
    const long begin = now_;
    int together = 0;  // Number of steps that can run without interruption, because nothing observes the
                       // states between them.
    const auto go = [&] {
      kernels_.advance(now_, together, first_);
      now_ += std::exchange(together, 0);
    };
    for (int i = 1; i <= steps; ++i) {
      ++together;
      const auto strokes = plan_.strokesAt(time, i);
      if (strokes.empty() && !watch) continue;
      go();
      for (const auto& painted : strokes) kernels_.paint(painted);
      if (!watch) continue;
      gl::barrier();
      watch(i);
    }
    go();
    SIMREEL_CHECK_EQ(now_, begin + steps);
    gl::barrier();
  }

  /// Runs the presteps in short batches, so that progress can be reported and the run can be interrupted.
  void prestep(const Setting& setting) {
    const int total = plan_.parameters().presteps;
    constexpr int piece = 32;
    for (int done = 0; done < total; done += piece) {
      const int steps = std::min(piece, total - done);
      kernels_.advance(first_ + done, steps, first_);
      if (!setting.presteps) continue;
      gl::barrier();
      glFinish();
      setting.presteps(done + steps, total);
    }
  }

  /// Returns the number of layers of the object that owns a field. The first call must happen while the
  /// scene's objects are created.
  int layersOf(const std::string& field) {
    const std::string object = PartName(field).object;
    const auto [layers, isNew] = layersOf_.try_emplace(object, 1);
    if (const scene::Object* owner = isNew ? links_->declared(object) : nullptr)
      if (const auto* other = dynamic_cast<const ReactionParameters*>(owner->parameters.get());
          other != nullptr && other->space() == RuleSpace::volume)
        layers->second = other->depth;
    return layers->second;
  }

  std::string name_;
  scene::Material material_;
  double frameSeconds_;
  const Links* links_;
  bool hasRead_ = false;                 ///< True once fields of other objects have been read.
  std::map<std::string, int> layersOf_;  ///< Layer counts of the objects whose fields are read.
  std::vector<std::string> speciesNames_;
  ReactionPlan plan_;
  ReactionKernels kernels_;
  std::vector<glm::vec3> colors_;
  Tally tally_;
  gl::Kernel<ReactionSums> sums_;
  std::optional<Isosurface> isosurface_;  ///< Isosurface of a volume; empty for a plane or a mesh.
  std::optional<PaintedMesh> painted_;    ///< Coloured mesh, if the cells are the vertices of a mesh.
  std::vector<std::string> countNames_;
  long first_, now_;  ///< Step numbers of the initial state and of the current state.
  double shownTime_;  ///< Time in seconds of the displayed state.
};

}  // namespace

SimulationKind reactionKind() {
  SimulationKind kind = kindOf<ReactionParameters>(
      "reaction",
      "Equations of your own on a grid: du/dt = D laplacian(u) + an expression, or one of many presets.",
      [](const scene::Object& object, const Setting& setting) {
        ReactionPlan(parametersOf<ReactionParameters>(object), object.name, setting.seed,
                     setting.frameSeconds)
            .checkPictures();
      },
      makeSimulation<Reaction>);
  kind.kind.appendix = reactionPresetsText;
  return kind;
}

}  // namespace simreel::sim
