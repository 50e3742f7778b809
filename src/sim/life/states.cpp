#include "sim/life/states.hpp"

#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/automata/engine/cell_engine.hpp"
#include "sim/life/rle.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

template <class T>
std::vector<glm::uvec4> wholeElements(const std::vector<T>& items) {
  std::vector<glm::uvec4> result((items.size() * sizeof(T) + 15) / 16);
  std::memcpy(result.data(), items.data(), items.size() * sizeof(T));
  return result;
}

struct StatesPaint {
  static constexpr auto file = "automata/paint.comp";
  gl::Uniform<"rowItems", int> rowItems;
  gl::Uniform<"highest", int> highest;
  StrokeUniforms stroke;
  gl::InOut<"cells"> cells;
  gl::In<"stamps"> stamps;
};

class LifeStates : public Simulation {
 public:
  LifeStates(LifePlan plan, const std::string& name, const Setting& setting)
      : name_(name),
        plan_(std::move(plan)),
        size_(plan_.parameters().size),
        colors_(plan_.stateColors()),
        engine_(plan_.rule(), plan_.shape(), size_, false, "life \"" + name + "\"") {
    const auto first = wholeElements(plan_.firstStates());
    cells_[0] = gl::WordsArray(name_ + " cells", first);
    cells_[1] = gl::WordsArray(name_ + " next cells", static_cast<int>(first.size()));
    if (!plan_.strokes().empty()) {
      paint_ = gl::Kernel<StatesPaint>(gl::kernelDefines(false));
      stamps_ = gl::WordsArray(name_ + " stamps", wholeElements(plan_.strokes().imageBits()));
    }
    paint(plan_.strokesInto(plan_.generationAt(plan_.frameAt(setting.startTime))));
    gl::barrier();
  }

  void step(double time, const StepWatch& watch) override {
    const long frame = plan_.frameAt(time);
    if (!started_) firstGeneration_ = generation_ = plan_.generationAt(frame);
    started_ = true;
    const long end = plan_.generationAt(frame + 1);
    int done = 0;
    while (generation_ < end) {
      engine_.run(cells_[0], cells_[1]);
      std::swap(cells_[0], cells_[1]);
      ++generation_;
      paint(plan_.strokesInto(generation_));
      if (watch) watch(++done);
    }
    gl::barrier();
    if (watch)
      while (done < stepsPerFrame()) watch(++done);
  }

  [[nodiscard]] int stepsPerFrame() const override { return plan_.stepsPerFrame(); }

  [[nodiscard]] std::string elementName(long element) const override {
    const long x = element % rowItems() * 16;
    return fmt::format("cells ({} to {}, {})", x, std::min<long>(x + 15, size_.x - 1),
                       element / rowItems());
  }

  void publish(double /*time*/, Drawables& drawables) const override {
    Field field;
    field.name = &name_;
    field.size = size_;
    field.words = &cells_[0].view();
    field.cells = Field::Cells::bytes;
    field.categories = true;
    field.rowWords = 4 * rowItems();
    field.range = {0, static_cast<float>(plan_.rule().states - 1)};
    field.colors = &colors_;
    field.display = &plan_.parameters().display;
    drawables.fields.push_back(field);
  }

  void visitCheckpointData(CarryOver& carry) override {
    carry.number("started", started_);
    carry.number("generation", generation_);
    carry.number("first generation", firstGeneration_);
    carry.array("cells", cells_[0].buffer());
  }

  [[nodiscard]] std::vector<StateArray> state() const override {
    return {{"cells", &cells_[0].buffer(), true}};
  }

  [[nodiscard]] StateFile stateFile() const override {
    return {"rle", [this](const std::string& comment) {
              const auto bytes = cells_[0].buffer().readAll<std::uint8_t>();
              return writeStatesRle({size_, bytes}, plan_.rule(), plan_.shape().suffix(size_), comment);
            }};
  }

  [[nodiscard]] std::vector<double> measure() const override {
    const auto bytes = cells_[0].buffer().readAll<std::uint8_t>();
    const auto living = static_cast<double>(bytes.size()) -
                        static_cast<double>(std::count(bytes.begin(), bytes.end(), std::uint8_t{0}));
    return {living, living / (static_cast<double>(size_.x) * size_.y),
            static_cast<double>(generation_ - firstGeneration_)};
  }

 private:
  [[nodiscard]] int rowItems() const { return (size_.x + 15) / 16; }

  void paint(const std::vector<shader::Stroke>& strokes) {
    for (const shader::Stroke& stroke : strokes) {
      const glm::ivec4 box = Strokes::box(stroke, size_);
      if (box.z == 0) continue;
      paint_.dispatch({(box.x + box.z - 1) / 16 - box.x / 16 + 1, box.w},
                      {.rowItems = rowItems(),
                       .highest = plan_.rule().states - 1,
                       .stroke = uniformsOf(stroke, box),
                       .cells = cells_[0],
                       .stamps = stamps_});
    }
  }

  std::string name_;
  LifePlan plan_;
  glm::ivec2 size_;
  std::vector<glm::vec3> colors_;
  CellEngine engine_;
  gl::WordsArray cells_[2];  ///< current cells, and the output of the next generation
  gl::WordsArray stamps_;
  gl::Kernel<StatesPaint> paint_;
  bool started_ = false;
  long generation_ = 0, firstGeneration_ = 0;
};

}  // namespace

std::unique_ptr<Simulation> makeLifeStates(LifePlan plan, const std::string& name, const Setting& setting) {
  return std::make_unique<LifeStates>(std::move(plan), name, setting);
}

}  // namespace simreel::sim
