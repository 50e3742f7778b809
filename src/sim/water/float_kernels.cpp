#include "sim/water/float_kernels.hpp"

#include "base/log.hpp"

#include <filesystem>
#include <map>
#include <utility>

namespace simreel::sim {

struct FloatMove {
  static constexpr auto file = "water/floats.comp";
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"stepNumber", int> stepNumber;
  gl::Uniform<"cellCount", int> cellCount;
  gl::Block<"FloatBlock", shader::FloatStep> step;
  gl::InOut<"StatusBlock"> status;
  gl::In<"cells"> cells;
  gl::In<"bodies"> bodies;
  gl::Out<"nextBodies"> next;
  gl::In<"floatInput"> floatInput;
  gl::In<"points"> points;
  gl::InOut<"FloatSumBlock"> sums;
};

struct FloatPress {
  static constexpr auto file = "water/float_press.comp";
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"side", int> side;
  gl::Uniform<"first", int> first;
  gl::Block<"FloatBlock", shader::FloatStep> step;
  gl::InOut<"cells"> cells;
  gl::In<"bodies"> bodies;
  gl::In<"floatInput"> floatInput;
  gl::InOut<"FloatSumBlock"> sums;
};

struct FloatDisplay {
  static constexpr auto file = "water/float_show.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"body", int> body;
  gl::Uniform<"origin", glm::vec3> origin;
  gl::In<"bodies"> bodies;
  gl::In<"hullPositions"> hullPositions;
  gl::In<"hullNormals"> hullNormals;
  gl::Out<"placedPositions"> positions;
  gl::Out<"placedNormals"> normals;
};

namespace {

namespace fs = std::filesystem;

std::vector<glm::vec4> texelsOf(const std::vector<glm::vec3>& vectors) {
  std::vector<glm::vec4> texels;
  texels.reserve(vectors.size());
  for (const glm::vec3& v : vectors) texels.emplace_back(v, 0.0F);
  return texels;
}

}  // namespace

FloatKernels::Drawn::Drawn(const std::string& name, const Hull& hull)
    : topology(name, hull.mesh),
      rest(name + " rest", texelsOf(hull.mesh.positions)),
      restNormals(name + " rest normals", texelsOf(hull.mesh.normals)),
      positions(name + " positions", texelsOf(hull.mesh.positions)),
      normals(name + " normals", texelsOf(hull.mesh.normals)),
      count(static_cast<int>(hull.mesh.positions.size())) {}

FloatKernels::FloatKernels(const std::string& name, const WaterPlan& plan, bool fast)
    : plan_(&plan), steps_(name + " floats' step", 1) {
  const FloatPlan& floats = plan.floats();
  const glm::ivec2 size = plan.parameters().size;
  std::map<fs::path, std::shared_ptr<const MovingMeshMaterials>> ofFiles;
  for (std::size_t i = 0; i < floats.hulls().size(); ++i) {
    const WaterFloat& body = plan.parameters().floats[i];
    const Mesh& mesh = floats.hulls()[i].mesh;
    const std::string its = name + " float " + std::to_string(i);
    const scene::Object object = body.shownAs(its);
    Drawn& drawn = drawn_.emplace_back(its, floats.hulls()[i]);
    drawn.doubleSided = !body.drawn.empty();
    const bool own = !body.materialKeys.empty() || body.drawnFile().empty();
    if (!own) drawn.looks = ofFiles[body.drawnFile()];
    if (drawn.looks) continue;
    drawn.looks = std::make_shared<const MovingMeshMaterials>(object, mesh);
    if (own) continue;
    ofFiles[body.drawnFile()] = drawn.looks;
    if (const std::string ignored = ignoredLooks(object, mesh); !ignored.empty())
      warn("water \"{}\": {} has features that are not drawn: {}", name, body.drawnFile().string(),
           ignored);
  }
  for (gl::Vec4Array& bodies : bodies_) bodies = gl::Vec4Array(name + " floats", floats.first());
  points_ = gl::Vec4Array(name + " floats' points", floats.points());
  parameters_ = gl::Vec4Array(name + " floats told", floats.parametersAt(0));
  sums_ = gl::Buffer::of<glm::ivec4>(
      name + " floats' sums",
      std::vector<glm::ivec4>(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)));
  steps_.upload(std::vector<shader::FloatStep>{floats.step()});
  const gl::Defines defines = gl::kernelDefines(fast);
  move_ = gl::Kernel<FloatMove>(defines);
  press_ = gl::Kernel<FloatPress>(defines);
  display_ = gl::Kernel<FloatDisplay>(defines);
}

void FloatKernels::startFrame(double time) {
  parameters_.write(plan_->floats().parametersAt(time));
}

void FloatKernels::step(int index, const gl::Vec4Array& cells, const gl::Buffer& status) {
  const glm::ivec2 size = plan_->parameters().size;
  const int side = plan_->floats().side(), count = static_cast<int>(drawn_.size());
  move_.dispatch(count * shader::floatLanes, {.size = size,
                                              .stepNumber = index,
                                              .cellCount = size.x * size.y,
                                              .step = steps_.at(0),
                                              .status = status,
                                              .cells = cells,
                                              .bodies = bodies_[0],
                                              .next = bodies_[1],
                                              .floatInput = parameters_,
                                              .points = points_,
                                              .sums = sums_});
  press_.dispatch({side, side * count}, {.size = size,
                                         .side = side,
                                         .first = index < 0 ? 1 : 0,
                                         .step = steps_.at(0),
                                         .cells = cells,
                                         .bodies = bodies_[0],
                                         .floatInput = parameters_,
                                         .sums = sums_});
  std::swap(bodies_[0], bodies_[1]);
}

void FloatKernels::prepareDrawing() const {
  for (std::size_t i = 0; i < drawn_.size(); ++i)
    display_.dispatch(drawn_[i].count, {.count = drawn_[i].count,
                                        .body = static_cast<int>(i),
                                        .origin = plan_->parameters().position,
                                        .bodies = bodies_[0],
                                        .hullPositions = drawn_[i].rest,
                                        .hullNormals = drawn_[i].restNormals,
                                        .positions = drawn_[i].positions,
                                        .normals = drawn_[i].normals});
  gl::barrier();
}

void FloatKernels::publish(Drawables& drawables) const {
  for (const Drawn& drawn : drawn_) {
    Surface surface = drawn.topology.surface();
    surface.positions = &drawn.positions.view();
    surface.normals = &drawn.normals.view();
    surface.doubleSided = drawn.doubleSided;
    drawn.looks->publish(surface, drawables);
  }
}

void FloatKernels::visitCheckpointData(CarryOver& carry) {
  carry.array("floats", bodies_[0].buffer());
  carry.array("displaced", sums_);
}

void FloatKernels::addState(std::vector<StateArray>& arrays) const {
  arrays.push_back({"floats", &bodies_[0].buffer()});
  arrays.push_back({"displaced", &sums_, true});
}

}  // namespace simreel::sim
