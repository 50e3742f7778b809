#include "draw/exact/rays/ray_count.hpp"

#include "draw/exact/visibility.hpp"

#include <array>
#include <span>

namespace simreel::draw {

struct CountRays {
  static constexpr auto file = "draw/exact/rays/count_rays.comp";
  gl::In<"rays"> rays;
  gl::Uniform<"firstRay", int> firstRay;
  gl::Uniform<"rayCount", int> rayCount;
  gl::InOut<"CountBlock"> total;
};

namespace {

RayCount* living = nullptr;

}  // namespace

RayCount::RayCount() : total_("count of rays", 16), kernel_(gl::Defines()) {
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
  kernel_.dispatch(inRows(count), {.rays = rays, .firstRay = first, .rayCount = count, .total = total_});
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::array<GLuint, 1> counted{};
  total_.read(0, std::as_writable_bytes(std::span(counted)));
  rays_ += counted[0];
}

}  // namespace simreel::draw
