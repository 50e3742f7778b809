#include "sim/lenia/lenia.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/limits.hpp"
#include "sim/core/kind.hpp"
#include "sim/lenia/plan.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

struct LeniaGrid {
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"rowItems", int> rowItems;
  gl::Uniform<"paddedItems", int> paddedItems;
  gl::Uniform<"margin", int> margin;
};

struct LeniaPad {
  static constexpr auto file = "lenia/pad.comp";
  LeniaGrid grid;
  gl::Uniform<"range", int> range;
  gl::In<"cells"> cells;
  gl::Out<"padded"> padded;
};

struct LeniaStep {
  static constexpr auto file = "lenia/step.comp";
  struct Variant {
    gl::Flag<"SMOOTH_LIFE"> smoothLife;
    gl::Range<"KERNELS", 1, 8> kernels;
    gl::Range<"RANGE", 2, maxLeniaRadius> range;
    gl::Code<"REACHES", "2,2,2,2,2"> reaches;  // half-width of each row of the widest kernel, in cells
  };
  LeniaGrid grid;
  gl::Uniform<"dt", float> dt;
  gl::Uniform<"limits", glm::vec4> limits;
  gl::Uniform<"slopes", glm::vec2> slopes;
  gl::Uniforms<"growth", glm::vec4, 8> growth;
  gl::In<"padded"> padded;
  gl::In<"weights"> weights;
  gl::Out<"newCells"> next;
};

struct LeniaPaint {
  static constexpr auto file = "lenia/paint.comp";
  gl::Uniform<"rowItems", int> rowItems;
  StrokeUniforms stroke;
  gl::InOut<"cells"> cells;
  gl::In<"stamps"> stamps;
};

class Lenia : public Simulation {
 public:
  Lenia(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        plan_(parametersOf<LeniaParameters>(object), object.name, setting.seed, setting.frameSeconds),
        size_(plan_.parameters().size),
        colors_(plan_.parameters().display.colors()),
        margin_((plan_.range() + 3) / 4 * 4),
        paddedItems_(plan_.rowItems() + margin_ / 2) {
    checkLimits();
    const auto first = plan_.firstCells();
    for (gl::Vec4Array& cells : cells_) cells = gl::Vec4Array(name_ + " cells", first);
    for (int i = 0; i < 2; ++i)
      words_[i] = gl::Texture::view(name_ + " words", GL_RGBA32UI, cells_[i].buffer());
    padded_ = gl::Vec4Array(name_ + " padded cells", paddedItems_ * (size_.y + 2 * plan_.range()) + 1);
    weights_ = gl::Vec4Array(name_ + " weights", plan_.weights());
    makePrograms(setting.fast);
    paint(plan_.strokesInto(plan_.stepAt(plan_.frameAt(setting.startTime))));
    gl::barrier();
  }

  void step(double time, const StepWatch& watch) override {
    const long frame = plan_.frameAt(time);
    int done = 0;
    for (long s = plan_.stepAt(frame); s < plan_.stepAt(frame + 1); ++s) {
      advance();
      paint(plan_.strokesInto(s + 1));
      if (watch) watch(++done);
    }
    gl::barrier();
    if (watch)
      while (done < stepsPerFrame()) watch(++done);
  }
  [[nodiscard]] int stepsPerFrame() const override { return plan_.stepsPerFrame(); }
  [[nodiscard]] std::string elementName(long element) const override {
    const long x = element % plan_.rowItems() * 4;
    return fmt::format("cells ({} to {}, {})", x, std::min<long>(x + 3, size_.x - 1),
                       element / plan_.rowItems());
  }
  void publish(double /*time*/, Drawables& drawables) const override {
    const FieldDisplay& display = plan_.parameters().display;
    Field field;
    field.name = &name_;
    field.words = &words_[0];
    field.size = size_;
    field.rowWords = 4 * plan_.rowItems();
    field.range = {static_cast<float>(display.low), static_cast<float>(display.high)};
    field.colors = &colors_;
    field.display = &display;
    drawables.fields.push_back(field);
  }
  void visitCheckpointData(CarryOver& carry) override { carry.array("cells", cells_[0].buffer()); }
  [[nodiscard]] std::vector<StateArray> state() const override { return {{"cells", &cells_[0].buffer()}}; }
  [[nodiscard]] std::vector<double> measure() const override {
    double mass = 0, area = 0;
    for (const float value : cells_[0].buffer().readAll<float>()) {
      mass += static_cast<double>(value);
      area += value > 0.1F ? 1 : 0;
    }
    return {mass, area};
  }

 private:
  void checkLimits() const {
    const long items = long{paddedItems_} * (size_.y + 2L * plan_.range()) + 1;
    const long max = std::min<long>(gl::limits().storageBlockBytes / 16, gl::limits().texelBufferTexels);
    if (items > max)
      fail(ExitCode::device,
           "lenia \"{}\" of {} x {} cells needs {} bytes in one buffer, this device allows {} "
           "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, GL_MAX_TEXTURE_BUFFER_SIZE); make \"size\" smaller",
           name_, size_.x, size_.y, items * 16, max * 16);
  }

  void makePrograms(bool fast) {
    const int range = plan_.range();
    pad_ = gl::Kernel<LeniaPad>(gl::kernelDefines(false));
    std::string reaches;
    for (int dy = -range; dy <= range; ++dy)
      reaches += (dy == -range ? "" : ",") + std::to_string(plan_.reach(dy));
    step_ =
        gl::Kernel<LeniaStep>(gl::kernelDefines(fast),
                              {.smoothLife = plan_.parameters().model == LeniaParameters::Model::smoothLife,
                               .kernels = plan_.kernels(),
                               .range = range,
                               .reaches = reaches});
    for (int k = 0; k < plan_.kernels(); ++k) growth_.push_back(plan_.growth(k));
    if (plan_.strokes().empty()) return;
    paint_ = gl::Kernel<LeniaPaint>(gl::kernelDefines(false));
    const auto& bits = plan_.strokes().imageBits();
    std::vector<glm::uvec4> stamps((bits.size() + 3) / 4);
    std::memcpy(stamps.data(), bits.data(), bits.size() * 4);
    stamps_ = gl::WordsArray(name_ + " stamps", stamps);
  }

  void advance() {
    const LeniaGrid grid = {
        .size = size_, .rowItems = plan_.rowItems(), .paddedItems = paddedItems_, .margin = margin_};
    pad_.dispatch({paddedItems_, size_.y + 2 * plan_.range()},
                  {.grid = grid, .range = plan_.range(), .cells = cells_[0], .padded = padded_});
    step_.dispatch({plan_.rowItems(), size_.y}, {.grid = grid,
                                                 .dt = plan_.dt(),
                                                 .limits = plan_.limits(),
                                                 .slopes = plan_.slopes(),
                                                 .growth = growth_,
                                                 .padded = padded_,
                                                 .weights = weights_,
                                                 .next = cells_[1]});
    std::swap(cells_[0], cells_[1]);
    std::swap(words_[0], words_[1]);
  }

  void paint(const std::vector<shader::Stroke>& strokes) {
    for (const shader::Stroke& stroke : strokes) {
      const glm::ivec4 box = Strokes::box(stroke, size_);
      if (box.z == 0) continue;
      paint_.dispatch({(box.x + box.z - 1) / 4 - box.x / 4 + 1, box.w}, {.rowItems = plan_.rowItems(),
                                                                         .stroke = uniformsOf(stroke, box),
                                                                         .cells = cells_[0],
                                                                         .stamps = stamps_});
    }
  }

  std::string name_;
  LeniaPlan plan_;
  glm::ivec2 size_;
  std::vector<glm::vec3> colors_;
  int margin_, paddedItems_;
  gl::Vec4Array cells_[2];  ///< current cells, and the output of the next step
  gl::Texture words_[2];
  gl::Vec4Array padded_, weights_;
  gl::WordsArray stamps_;
  std::vector<glm::vec4> growth_;
  gl::Kernel<LeniaPad> pad_;
  gl::Kernel<LeniaStep> step_;
  gl::Kernel<LeniaPaint> paint_;
};

}  // namespace

SimulationKind leniaKind() {
  return kindOf<LeniaParameters>(
      "lenia", "A continuous automaton: Lenia with one or several kernels, or SmoothLife.",
      [](const scene::Object& object, const Setting& setting) {
        static_cast<void>(LeniaPlan(parametersOf<LeniaParameters>(object), object.name, setting.seed,
                                    setting.frameSeconds));
      },
      makeSimulation<Lenia>);
}

}  // namespace simreel::sim
