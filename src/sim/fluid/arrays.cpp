#include "sim/fluid/arrays.hpp"

#include "base/error.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <vector>

namespace simreel::sim {

struct FluidGather {
  static constexpr auto file = "fluid/gather.comp";
  struct Variant {
    gl::Flag<"SCATTER"> scatter;
  };
  gl::Uniform<"planes", int> planes;
  gl::Uniform<"elements", int> elements;
  gl::InOut<"PlaneBlock"> planeWords;
  gl::InOut<"ElementBlock"> together;
};

namespace {

std::size_t bytesOf(int floats) {
  return static_cast<std::size_t>(floats) * 4;
}

/// Converts vec4 elements to planes: all x components, then all y, z and w.
std::vector<float> planesOf(std::span<const glm::vec4> elements) {
  std::vector<float> planes;
  planes.reserve(4 * elements.size());
  for (int i = 0; i < 4; ++i)
    for (const glm::vec4& element : elements) planes.push_back(element[i]);
  return planes;
}

}  // namespace

FluidArray::FluidArray(const std::string& label, const gl::BufferPart& part)
    : part_(part), words_(gl::Texture::view(label + " words", GL_RGBA32UI, part)) {
  if (gl::memoryPath() == gl::MemoryPath::texel) texels_ = gl::Texture::view(label, GL_RGBA32F, part);
}

FluidArrays::FluidArrays(const std::string& name, const FluidPlan& plan, std::span<const glm::vec4> flow)
    : texels_(gl::memoryPath() == gl::MemoryPath::texel), elements_(plan.elements()) {
  const std::string labels[] = {name + " flow", name + " dye", name + " scratch", name + " more scratch"};
  const FluidLevels& levels = plan.levels();
  const int finest = levels.levels().front().elements(), all = levels.elements();
  const std::size_t pool = 16 * static_cast<std::size_t>(2 * finest + all);
  const std::size_t raised = 16 * static_cast<std::size_t>(2 * all);
  const std::size_t element = 4 * bytesOf(elements_), three = 3 * bytesOf(elements_);
  if (texels_) {
    SIMREEL_CHECK(std::max(pool, raised) <= element);
    buffers_[0] = gl::Buffer::of(labels[0], flow);
    for (int i = 1; i < 4; ++i) buffers_[i] = gl::Buffer(labels[i], element);
    for (int i = 0; i < 4; ++i) arrays_[i] = FluidArray(labels[i], {&buffers_[i], 0, element});
    return;
  }
  const std::vector<float> planes = planesOf(flow);
  buffers_[0] = gl::Buffer::of<float>(labels[0], planes);
  arrays_[flow_] = FluidArray(labels[0], {&buffers_[0], 0, element});
  planeBesideSums_ = 8 * finest;
  const std::size_t end = gl::BufferPart::aligned(std::max(three, raised));
  const std::size_t middle =
      gl::BufferPart::aligned(std::max({pool, three, bytesOf(planeBesideSums_ + elements_)}));
  gl::Buffer& shared = buffers_[1];
  shared = gl::Buffer::inParts(name + " dye and scratch", 2 * end + middle);
  arrays_[dye_] = FluidArray(labels[1], {&shared, 0, end});
  arrays_[scratch_] = FluidArray(labels[2], {&shared, end, middle});
  arrays_[spare_] = FluidArray(labels[3], {&shared, end + middle, end});
  free_[0] = FluidArray(name + " shown", {&shared, 0, element});
  free_[1] = FluidArray(name + " shown", {&shared, end, element});
}

const FluidArray& FluidArrays::shown() const {
  if (texels_) return scratch();
  return spare().part().offset == 0 ? free_[0] : free_[1];
}

void FluidArrays::swapFlow(bool withScratch) {
  SIMREEL_CHECK(alike());
  std::swap(flow_, withScratch ? scratch_ : spare_);
}

StateArray FluidArrays::stateOf(int array, const char* name, int planes) const {
  const gl::BufferPart& part = arrays_[array].part();
  StateArray state{name, part.buffer};
  if (!texels_) state.planes = {part, planes, elements_};
  return state;
}

void FluidArrays::visitCheckpointData(CarryOver& carry) {
  visitCheckpointData(carry, flow_, "flow", 4);
  visitCheckpointData(carry, dye_, "dye", 3);
}

void FluidArrays::visitCheckpointData(CarryOver& carry, int array, const char* name, int planes) {
  if (texels_) return carry.array(name, buffers_[array]);
  if (!gather_) {
    gather_ = gl::Kernel<FluidGather>(gl::kernelDefines(false));
    scatter_ = gl::Kernel<FluidGather>(gl::kernelDefines(false), {.scatter = true});
  }
  const auto run = [&](const gl::Kernel<FluidGather>& kernel, const gl::Buffer& elements) {
    gl::barrier();
    kernel.dispatch(elements_, {planes, elements_, arrays_[array].part(), elements});
    gl::barrier();
  };
  gl::Buffer elements(std::string(name) + " for a file", 4 * bytesOf(elements_));
  run(gather_, elements);
  gl::beforeWrites();
  carry.array(name, elements);
  run(scatter_, elements);
}

}  // namespace simreel::sim
