#include "sim/garment/kernels.hpp"

namespace simreel::sim {

/// Part of a kernel interface: inputs common to all kernels (glsl/garment/kernel.glsl).
struct GarmentPart {
  gl::Uniform<"count", int> count;
  gl::Block<"StepBlock", shader::ClothStep> step;
};
/// Part of a kernel interface: faces around each vertex.
struct GarmentRings {
  gl::In<"fans"> fans;
  gl::In<"rings"> rings;
};
struct GarmentKeeps {
  gl::Switch<"KEEPS"> keeps;
};

struct GarmentAir {
  static constexpr auto file = "garment/air.comp";
  struct Variant {
    gl::Flag<"WIND"> wind;
  };
  GarmentPart garment;
  FluidWindPart wind;
  gl::In<"positions"> positions;
  gl::In<"velocities"> velocities;
  gl::In<"corners"> corners;
  gl::Out<"faceForces"> forces;
};

struct GarmentPredict {
  static constexpr auto file = "garment/predict.comp";
  struct Variant {
    gl::Switch<"KEEPS"> keeps;
    gl::Switch<"AIR"> air;
  };
  GarmentPart garment;
  GarmentRings around;
  gl::In<"positions"> positions;
  gl::InOut<"velocities"> velocities;
  gl::In<"trends"> trends;
  gl::In<"elements"> elements;
  gl::In<"faceForces"> forces;
  gl::In<"entries"> entries;
  gl::Out<"nextPositions"> next;
};

struct GarmentStretch {
  static constexpr auto file = "garment/stretch.comp";
  struct Variant {
    gl::Switch<"DAMPED"> damped;
  };
  GarmentPart garment;
  gl::Uniform<"first", int> first;
  gl::In<"elements"> elements;
  gl::In<"corners"> corners;
  gl::In<"positions"> positions;
  gl::InOut<"nextPositions"> next;
};

struct GarmentAttach {
  static constexpr auto file = "garment/attach.comp";
  using Variant = GarmentKeeps;
  GarmentPart garment;
  gl::In<"attachments"> attachments;
  gl::In<"positions"> positions;
  gl::InOut<"nextPositions"> next;
  gl::InOut<"velocities"> velocities;
  gl::InOut<"trends"> trends;
};

struct GarmentSew {
  static constexpr auto file = "garment/sew.comp";
  GarmentPart garment;
  gl::Uniform<"first", int> first;
  gl::In<"stitches"> stitches;
  gl::InOut<"nextPositions"> next;
  gl::InOut<"velocities"> velocities;
};

struct GarmentSettle {
  static constexpr auto file = "garment/settle.comp";
  struct Variant {
    TouchVariant touch;
    gl::Switch<"KEEPS"> keeps;
    gl::Switch<"AGAIN"> again;
  };
  GarmentPart garment;
  TouchPart touch;
  gl::InOut<"StatusBlock"> status;
  gl::In<"positions"> positions;
  gl::InOut<"nextPositions"> next;
  gl::InOut<"velocities"> velocities;
  gl::InOut<"trends"> trends;
  gl::In<"left"> left;
};

struct GarmentThin {
  static constexpr auto file = "garment/thin.comp";
  gl::Uniform<"count", int> count;
  ThinPart thin;
  GarmentRings around;
};

struct GarmentDisplay {
  static constexpr auto file = "garment/show.comp";
  GarmentPart garment;
  GarmentRings around;
  gl::In<"positions"> positions;
  gl::In<"copies"> copies;
  gl::Out<"drawnPositions"> drawnPositions;
  gl::Out<"drawnNormals"> drawnNormals;
};

namespace {

/// Calls `run` with the first item and the number of items of each colour, in reverse order if `back` is
/// true.
template <class Run>
void inColours(const std::vector<int>& colours, bool back, const Run& run) {
  for (std::size_t k = 0; k + 1 < colours.size(); ++k) {
    const std::size_t colour = back ? colours.size() - 2 - k : k;
    run(colours[colour], colours[colour + 1] - colours[colour]);
  }
}

}  // namespace

GarmentKernels::GarmentKernels(const std::string& name, const GarmentPlan& plan, const TouchVariant& touch,
                               bool fast)
    : plan_(&plan),
      vertices_(static_cast<int>(plan.vertexCount())),
      hold_(name, plan.skinPins(), gl::kernelDefines(fast)),
      thin_(name, plan.thinCount(), vertices_, fast) {
  makeArrays(name);
  makeKernels(touch, fast);
}

void GarmentKernels::predict(int substep, const Step& step, std::size_t bending, const TouchPart& touch) {
  push(step, touch.wind);
  hold_.hold(velocities_, substep, plan_->substeps());
  accelerate(step, bending);
  stretch(step);
  attach(step);
  sew(step);
  meet(settle_, step, touch);
  if (!plan_->parameters().contact) return;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  left_.copyFrom(positions_[1]);
}

void GarmentKernels::makeArrays(const std::string& name) {
  const auto positions = plan_->firstPositions();
  positions_[0] = gl::Vec4Array(name + " positions", positions);
  positions_[1] = gl::Vec4Array(name + " next positions", positions);
  velocities_ = gl::Vec4Array(name + " velocities", plan_->firstVelocities());
  trends_ = gl::Vec4Array(name + " trends", plan_->firstTrends());
  if (plan_->parameters().contact) left_ = gl::Vec4Array(name + " left", vertices_);
  const GarmentArrays& arrays = plan_->arrays();
  const auto words = [&](const char* what, const std::vector<glm::uvec4>& items) {
    return gl::WordsArray(name + what, items);
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
  elements_ = gl::Vec4Array(name + " elements", arrays.elements);
  const int faces = plan_->parameters().air ? static_cast<int>(arrays.corners.size()) : 1;
  faceForces_ = gl::Vec4Array(name + " air", faces);
  const int drawn = static_cast<int>(arrays.copies.size());
  drawnPositions_ = gl::Vec4Array(name + " drawn positions", drawn);
  drawnNormals_ = gl::Vec4Array(name + " drawn normals", drawn);
  const unsigned fine[4] = {0xffffffffU, 0xffffffffU, 0, 0};
  status_ = gl::Buffer::of<unsigned>(name + " status", fine);
}

void GarmentKernels::makeKernels(const TouchVariant& touch, bool fast) {
  const ClothParameters& p = plan_->parameters();
  const gl::Defines defines = gl::kernelDefines(fast);
  const bool keeps = p.keepsEnergy();
  if (p.air) air_ = gl::Kernel<GarmentAir>(defines, {.wind = touch.wind});
  predict_ = gl::Kernel<GarmentPredict>(defines, {.keeps = keeps, .air = p.air.has_value()});
  stretch_ = gl::Kernel<GarmentStretch>(defines, {.damped = p.damped()});
  if (!plan_->arrays().attachments.empty()) attach_ = gl::Kernel<GarmentAttach>(defines, {.keeps = keeps});
  if (!plan_->arrays().stitches.empty()) sew_ = gl::Kernel<GarmentSew>(defines);
  const auto settling = [&](bool again) {
    return gl::Kernel<GarmentSettle>(defines, {.touch = touch, .keeps = keeps, .again = again});
  };
  settle_ = settling(false);
  if (p.contact) settleAgain_ = settling(true);
  if (thin_.any()) findThin_ = gl::Kernel<GarmentThin>(defines);
  display_ = gl::Kernel<GarmentDisplay>(defines);
}

GarmentRings GarmentKernels::around(std::size_t bending) const {
  return {fans_[bending], rings_};
}

// Computes the air's forces on the faces.
void GarmentKernels::push(const Step& step, const FluidWindPart& wind) const {
  if (!plan_->parameters().air) return;
  const auto faces = static_cast<int>(plan_->arrays().corners.size());
  air_.dispatch(faces, {.garment = {faces, step},
                        .wind = wind,
                        .positions = positions_[0],
                        .velocities = velocities_,
                        .corners = corners_,
                        .forces = faceForces_});
}

// Writes the positions predicted by forces into positions_[1].
void GarmentKernels::accelerate(const Step& step, std::size_t bending) const {
  predict_.dispatch(vertices_, {.garment = {vertices_, step},
                                .around = around(bending),
                                .positions = positions_[0],
                                .velocities = velocities_,
                                .trends = trends_,
                                .elements = elements_,
                                .forces = faceForces_,
                                .entries = entries_[bending],
                                .next = positions_[1]});
}

// Applies the stretch and shear constraints to positions_[1], first in forward and then in reverse order.
void GarmentKernels::stretch(const Step& step) const {
  if (plan_->parameters().keepsEnergy())
    return;  // Cloth that keeps energy has no constraints to relax here, because accelerate() has already
             // applied their forces.
  for (const bool back : {false, true})
    inColours(plan_->arrays().colours, back, [&](int first, int count) {
      stretch_.dispatch(count, {.garment = {count, step},
                                .first = first,
                                .elements = elements_,
                                .corners = corners_,
                                .positions = positions_[0],
                                .next = positions_[1]});
    });
}

// Pulls back vertices whose distance from their pin exceeds the length of the cloth between them.
void GarmentKernels::attach(const Step& step) const {
  if (plan_->arrays().attachments.empty()) return;
  const auto count = static_cast<int>(plan_->arrays().attachments.size());
  attach_.dispatch(count, {.garment = {count, step},
                           .attachments = attachments_,
                           .positions = positions_[0],
                           .next = positions_[1],
                           .velocities = velocities_,
                           .trends = trends_});
}

// Closes seams, one colour of stitches at a time.
void GarmentKernels::sew(const Step& step) const {
  if (plan_->arrays().stitches.empty()) return;
  inColours(plan_->arrays().stitchColours, false, [&](int first, int count) {
    sew_.dispatch(count, {.garment = {count, step},
                          .first = first,
                          .stitches = stitches_,
                          .next = positions_[1],
                          .velocities = velocities_});
  });
}

// Computes velocities from positions_[1] and resolves collisions of the vertices.
void GarmentKernels::meet(const gl::Kernel<GarmentSettle>& settling, const Step& step,
                          const TouchPart& touch) const {
  settling.dispatch(vertices_, {.garment = {vertices_, step},
                                .touch = touch,
                                .status = status_,
                                .positions = positions_[0],
                                .next = positions_[1],
                                .velocities = velocities_,
                                .trends = trends_,
                                .left = left_});
  thin_.resolveThin(step, positions_[0], positions_[1], velocities_, [&](const ThinPart& thin) {
    findThin_.dispatch(vertices_, {.count = vertices_, .thin = thin, .around = around(0)});
  });
}

// Computes the drawn positions and normals.
void GarmentKernels::prepareDrawing(const Step& step) const {
  const auto count = static_cast<int>(plan_->arrays().copies.size());
  display_.dispatch(count, {.garment = {count, step},
                            .around = around(0),
                            .positions = positions_[0],
                            .copies = copies_,
                            .drawnPositions = drawnPositions_,
                            .drawnNormals = drawnNormals_});
  gl::barrier();
}

}  // namespace simreel::sim
