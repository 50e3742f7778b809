#include "sim/kernels/wind.hpp"

#include <cstddef>

namespace simreel::sim {

struct KernelWindKernel {
  static constexpr auto file = "kernels/run/wind.comp";
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"scale", float> scale;
  gl::In<"cells"> cells;
  gl::Out<"WindBlock"> wind;
};

namespace {

std::size_t ringed(glm::ivec2 size) {
  return static_cast<std::size_t>(size.x + 2) * static_cast<std::size_t>(size.y + 2);
}

}  // namespace

KernelWindSource::KernelWindSource(const std::string& name, const KernelPlan& plan,
                                   const KernelWatch& watch)
    : given_(*plan.drawn().wind),
      size_(plan.sizeOf(given_.of)),
      watch_(watch),
      kernel_(gl::kernelDefines(false)),
      cells_(name + " velocities of the wind", size_.x * size_.y),
      flow_(name + " wind", 16 * ringed(size_)),
      flowViews_(name + " wind", {&flow_, 0, flow_.bytes()}),
      wind_(given_.plane, size_, given_.speed / given_.plane.cell,
            [this]() -> const FluidArray& { return flowViews_; }) {}

KernelWindSource::~KernelWindSource() = default;

void KernelWindSource::update(const KernelStore& store) {
  gather_.run(numbersOf(store, given_.of, given_.velocity, 2),
              {.member = KernelNumbers::chosen, .watch = watch_}, cells_);
  gl::barrier();
  kernel_.dispatch(
      static_cast<int>(ringed(size_)),
      {.size = size_, .scale = given_.scale / given_.plane.cell, .cells = cells_, .wind = flow_});
  gl::barrier();
}

}  // namespace simreel::sim
