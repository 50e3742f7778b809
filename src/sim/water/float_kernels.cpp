#include "sim/water/float_kernels.hpp"

#include "base/log.hpp"
#include "sim/water/bindings.hpp"

#include <filesystem>
#include <map>
#include <utility>

namespace simreel::sim {

namespace {

namespace at = shader::water;
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
  std::map<fs::path, std::shared_ptr<const MovingLooks>> ofFiles;
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
    drawn.looks = std::make_shared<const MovingLooks>(object, mesh);
    if (own) continue;
    ofFiles[body.drawnFile()] = drawn.looks;
    if (const std::string ignored = ignoredLooks(object, mesh); !ignored.empty())
      warn("water \"{}\": {} has what is not drawn: {}", name, body.drawnFile().string(), ignored);
  }
  for (gl::Vec4Array& bodies : bodies_) bodies = gl::Vec4Array(name + " floats", floats.first());
  points_ = gl::Vec4Array(name + " floats' points", floats.points());
  told_ = gl::Vec4Array(name + " floats told", floats.toldAt(0));
  sums_ = gl::Buffer::of<glm::ivec4>(
      name + " floats' sums",
      std::vector<glm::ivec4>(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)));
  steps_.upload(std::vector<shader::FloatStep>{floats.step()});
  const gl::Defines defines = gl::kernelDefines(fast);
  move_ = gl::Program::compute("water/floats.comp", defines);
  move_.checkUniformBlock("FloatBlock", sizeof(shader::FloatStep));
  move_.set("size", size);
  move_.set("cellCount", size.x * size.y);
  press_ = gl::Program::compute("water/float_press.comp", defines);
  press_.set("size", size);
  press_.set("side", floats.side());
  show_ = gl::Program::compute("water/float_show.comp", defines);
  show_.set("origin", plan.parameters().position);
}

void FloatKernels::startFrame(double time) {
  told_.write(plan_->floats().toldAt(time));
}

void FloatKernels::begin(gl::Vec4Array& cells, const gl::Buffer& status) {
  press_.set("first", 1);
  run(-1, cells, status);
  press_.set("first", 0);
}

void FloatKernels::step(int index, gl::Vec4Array& cells, const gl::Buffer& status) {
  run(index, cells, status);
}

void FloatKernels::run(int index, gl::Vec4Array& cells, const gl::Buffer& status) {
  steps_.bind(0);
  status.bindStorage(shader::statusBinding);
  cells.bindInput(at::cellsBinding);
  bodies_[0].bindInput(at::floatsBinding);
  bodies_[1].bindState(at::nextFloatsBinding);
  told_.bindInput(at::floatToldBinding);
  points_.bindInput(at::floatPointsBinding);
  sums_.bindStorage(at::floatSumsBinding);
  move_.set("stepNumber", index);
  gl::barrier();
  move_.dispatch(static_cast<int>(drawn_.size()) * shader::floatLanes);
  cells.bindState(at::cellsBinding);
  bodies_[0].bindInput(at::floatsBinding);
  const int side = plan_->floats().side();
  gl::barrier();
  press_.dispatch(side, side * static_cast<int>(drawn_.size()));
  std::swap(bodies_[0], bodies_[1]);
}

void FloatKernels::show() {
  gl::barrier();
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    const Drawn& drawn = drawn_[i];
    bodies_[0].bindInput(at::floatsBinding);
    drawn.rest.bindInput(at::hullPositionsBinding);
    drawn.restNormals.bindInput(at::hullNormalsBinding);
    drawn.positions.bindState(at::placedPositionsBinding);
    drawn.normals.bindState(at::placedNormalsBinding);
    show_.set("count", drawn.count);
    show_.set("body", static_cast<int>(i));
    show_.dispatch(drawn.count);
  }
  gl::barrier();
}

void FloatKernels::publish(Drawables& drawables) const {
  for (const Drawn& drawn : drawn_) {
    Surface surface = drawn.topology.surface();
    surface.positions = &drawn.positions.view();
    surface.normals = &drawn.normals.view();
    surface.doubleSided = drawn.doubleSided;
    drawn.looks->show(surface, drawables);
  }
}

void FloatKernels::carryOver(CarryOver& carry) {
  carry.array("floats", bodies_[0].buffer());
  carry.array("displaced", sums_);
}

void FloatKernels::addState(std::vector<StateArray>& arrays) const {
  arrays.push_back({"floats", &bodies_[0].buffer()});
  arrays.push_back({"displaced", &sums_, true});
}

}  // namespace simreel::sim
