#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/shader_code.hpp"

#include <cstdint>
#include <string>

namespace simreel::shader {
#include "glsl/contour/types.glsl"
static_assert(sizeof(ContourDraw) == 48);
}  // namespace simreel::shader

namespace simreel::sim {

struct TallySums;
struct TallyTotal;
struct TallySpread;

/// Of what a field asks for, known to the GPU alone: tallies become the sums of those before each, by three
/// kernels of glsl/contour, and their total the arguments of an indirect draw. For solids of squares and
/// surfaces of cubes.
class Totals {
 public:
  Totals() = default;
  /// `count` tallies: x points, y sheets, z triangles, w anything.
  Totals(const std::string& name, int count);
  Totals(const Totals&) = delete;
  Totals& operator=(const Totals&) = delete;
  Totals(Totals&& other) noexcept { *this = std::move(other); }
  Totals& operator=(Totals&& other) noexcept;
  ~Totals() { glDeleteSync(fence_); }

  struct Room {
    std::int64_t fixed = 0;                ///< indices that are there anyway
    unsigned perSheet = 0, perPoint = 0;   ///< indices; a triangle has three
    std::int64_t points = 0, indices = 0;  ///< that there is memory for
  };
  /// Waits for nothing.
  void run(const gl::WordsArray& tallies, const Room& room);
  /// Waits for the latest run; false: there was none. Throws UserError(device).
  [[nodiscard]] bool wait();
  /// After wait().
  [[nodiscard]] const shader::ContourDraw& found() const {
    return *static_cast<const shader::ContourDraw*>(counted_.memory());
  }
  [[nodiscard]] const gl::Buffer& draw() const { return draw_; }

 private:
  std::string name_;
  int count_ = 0, tiles_ = 0;
  gl::WordsArray tileSums_;
  gl::Buffer draw_, counted_;
  gl::Kernel<TallySums> sums_;
  gl::Kernel<TallyTotal> total_;
  gl::Kernel<TallySpread> spread_;
  GLsync fence_ = nullptr;
};

/// Room for `now` that a field took: a quarter more than that if the device has buffers of `limit`, since
/// what grows would need more in each of the next frames.
[[nodiscard]] std::int64_t grownRoom(std::int64_t now, std::int64_t room, std::int64_t limit);

/// Throws UserError(device) where a buffer of `count` elements of that size is beyond a limit; `whose`:
/// "the solid of", `smaller`: what to do.
void checkBufferRoom(const char* whose, const std::string& name, const char* what, std::int64_t count,
                     int bytes, const char* smaller);

}  // namespace simreel::sim
