#include "draw/exact/rays/ray_count.hpp"

#include "draw/exact/rays/bindings.hpp"
#include "draw/exact/visibility.hpp"

#include <array>
#include <span>

namespace simreel::draw {

namespace {

RayCount* living = nullptr;

}  // namespace

RayCount::RayCount()
    : total_("count of rays", 16), kernel_(gl::Program::compute("draw/exact/rays/count_rays.comp", {})) {
  living = this;
}

RayCount::~RayCount() {
  living = nullptr;
}

RayCount* RayCount::current() {
  return living;
}

void RayCount::add(const gl::Texture& rays, int first, int count) {
  constexpr GLuint zero = 0;
  glClearNamedBufferData(total_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  rays.bind(rayUnit);
  total_.bindStorage(outCountBinding);
  kernel_.set("firstRay", first);
  kernel_.set("rayCount", count);
  dispatchRows(kernel_, count);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::array<GLuint, 1> counted{};
  total_.read(0, std::as_writable_bytes(std::span(counted)));
  rays_ += counted[0];
}

}  // namespace simreel::draw
