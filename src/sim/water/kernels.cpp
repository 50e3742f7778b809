#include "sim/water/kernels.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"
#include "sim/mesh/height_field.hpp"
#include "sim/water/quantities.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace simreel::sim {

struct WaterStepPart {
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"stepNumber", int> stepNumber;
  gl::Block<"WaterBlock", shader::WaterStep> step;
  gl::InOut<"StatusBlock"> status;
  gl::In<"cells"> cells;
  gl::Out<"nextCells"> next;
};

struct WaterColumns {
  static constexpr auto file = "water/step.comp";
  struct Variant {
    gl::Range<"ROWS", 1, 32> rows;
    gl::Switch<"SEA"> sea;
  };
  WaterStepPart part;
};

struct WaterStrips {
  static constexpr auto file = "water/step_strips.comp";
  struct Variant {
    gl::Switch<"SEA"> sea;
  };
  WaterStepPart part;
  gl::Uniform<"rows", int> rows;
};

struct WaterPaint {
  static constexpr auto file = "water/paint.comp";
  struct Variant {
    gl::Flag<"DROP"> drop;
  };
  struct Drop {
    gl::Uniform<"drop.center", glm::vec2> center;
    gl::Uniform<"drop.perRadius2", float> perRadius2;
    gl::Uniform<"drop.height", float> height;
    gl::Uniform<"drop.shallow", float> shallow;
  };
  gl::Uniform<"size", glm::ivec2> size;
  StrokeUniforms stroke;
  Drop drop;
  gl::InOut<"cells"> cells;
  gl::In<"stamps"> stamps;
};

struct WaterDisplay {
  static constexpr auto file = "water/look.comp";
  gl::Uniform<"size", glm::ivec2> size;
  gl::Block<"LookBlock", shader::WaterLook> look;
  gl::In<"cells"> cells;
  gl::Out<"shown"> shown;
};

struct WaterSums {
  static constexpr auto file = "water/tally.comp";
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"shallow", float> shallow;
  gl::Block<"WaterBlock", shader::WaterStep> step;
  gl::In<"cells"> cells;
  gl::Out<"laneSums"> laneSums;
};

struct WaterBed {
  static constexpr auto file = "water/bed.comp";
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"fresh", bool> fresh;
  gl::Uniform<"waterGround.corner", glm::vec2> corner;
  gl::Uniform<"waterGround.cell", float> cell;
  gl::Uniform<"waterGround.base", float> base;
  HeightPart heights;
  gl::InOut<"cells"> cells;
};

void WaterKernels::checkLimits(const std::string& name, glm::ivec2 size) {
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

WaterKernels::WaterKernels(const std::string& name, const WaterPlan& plan, bool fast)
    : plan_(&plan),
      size_(plan.parameters().size),
      rowsEach_(strips_ ? std::clamp(size_.x * size_.y / 60000, 4, 32) : 8),
      steps_(name + " step", plan.uniformSteps()),
      look_(name + " look", sizeof(shader::WaterLook)) {
  for (int i = 0; i < 2; ++i) {
    cells_[i] = gl::Vec4Array(name + " cells", plan.firstCells());
    words_[i] = gl::Texture::view(name + " words", GL_RGBA32UI, cells_[i].buffer());
  }
  constexpr unsigned fine[4] = {0xffffffffU, 0xffffffffU, 0, 0};
  status_ = gl::Buffer::of<unsigned>(name + " status", fine);
  const shader::WaterLook look = plan.look();
  look_.write(0, std::as_bytes(std::span(&look, 1)));
  const gl::Defines defines = gl::kernelDefines(fast);
  const auto& sides = plan.parameters().sides;
  const bool sea = std::find(sides.begin(), sides.end(), WaterBorder::sea) != sides.end();
  if (strips_)
    stripSteps_ = gl::Kernel<WaterStrips>(defines, {.sea = sea});
  else
    columns_ = gl::Kernel<WaterColumns>(defines, {.rows = rowsEach_, .sea = sea});
  display_ = gl::Kernel<WaterDisplay>(defines);
  sums_ = gl::Kernel<WaterSums>(defines);
  tally_ = Tally(name, defines);
  if (!plan.parameters().groundObject.empty()) bed_ = gl::Kernel<WaterBed>(defines);
  if (!plan.anythingFalls()) return;
  stamps_ = gl::WordsArray(name + " stroke images", plan.strokes().imageElements());
  paint_ = gl::Kernel<WaterPaint>(defines);
  drop_ = gl::Kernel<WaterPaint>(defines, {.drop = true});
}

void WaterKernels::startFrame(double time) {
  std::vector<shader::WaterStep> uniforms;
  uniforms.reserve(static_cast<std::size_t>(plan_->uniformSteps()));
  for (int i = 0; i < plan_->uniformSteps(); ++i) uniforms.push_back(plan_->stepAt(time, i));
  steps_.upload(uniforms);
  gl::barrier();
}

void WaterKernels::step(int number) {
  const WaterStepPart part = {
      .size = size_,
      .stepNumber = number,
      .step = steps_.at(plan_->uniformSteps() > 1 ? static_cast<std::size_t>(number - 1) : 0),
      .status = status_,
      .cells = cells_[0],
      .next = cells_[1]};
  const int parts = (size_.y - 1) / rowsEach_ + 1;
  if (strips_)
    stripSteps_.dispatch({(size_.x - 1) / 28 * 32 + 32, parts}, {.part = part, .rows = rowsEach_});
  else
    columns_.dispatch({size_.x, parts}, {part});
  std::swap(cells_[0], cells_[1]);
  std::swap(words_[0], words_[1]);
}

void WaterKernels::follow(const HeightField& heights, int number) const {
  const shader::WaterLook look = plan_->look();
  const int steps = plan_->substeps();
  bed_.dispatch(size_, {.size = size_,
                        .fresh = number == 0,
                        .corner = glm::vec2(look.left, look.back),
                        .cell = look.cell,
                        .base = look.base,
                        .heights = heights.part(number == 0 ? steps - 1 : number - 1, steps, 0, 0),
                        .cells = cells_[0]});
}

void WaterKernels::fall(double time, int number) const {
  if (!plan_->anythingFalls()) return;
  const WaterFalls falls = plan_->fallsAt(time, number);
  const auto raise = [&](const gl::Kernel<WaterPaint>& kernel, glm::ivec4 box, const StrokeUniforms& stroke,
                         const WaterPaint::Drop& drop) {
    if (box.z > 0) kernel.dispatch({box.z, box.w}, {size_, stroke, drop, cells_[0], stamps_});
  };
  for (const shader::Stroke& stroke : falls.strokes) {
    const glm::ivec4 box = Strokes::box(stroke, size_);
    raise(paint_, box, uniformsOf(stroke, box), {});
  }
  for (const shader::WaterDrop& drop : falls.drops) {
    StrokeUniforms there;
    there.box = plan_->box(drop);
    raise(drop_, plan_->box(drop), there, {drop.center, drop.perRadius2, drop.height, drop.shallow});
  }
}

void WaterKernels::look() const {
  display_.dispatch(size_, {.size = size_, .look = look_, .cells = cells_[0], .shown = cells_[1]});
  gl::barrier();
}

void WaterKernels::tally(double time) {
  steps_.upload(std::vector<shader::WaterStep>{plan_->stepAt(time)});
  sums_.dispatch(Tally::lanes, {.size = size_,
                                .shallow = plan_->look().shallow,
                                .step = steps_.at(0),
                                .cells = cells_[0],
                                .laneSums = tally_.laneSums()});
  tally_.join(waterSumFactors(plan_->parameters()), glm::vec4(1));
}

}  // namespace simreel::sim
