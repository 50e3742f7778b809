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

/// Counts the geometry of a field on the GPU. Three kernels of glsl/contour turn tallies into prefix sums,
/// and the totals into the arguments of an indirect draw. Used for solids of squares and for surfaces of
/// cubes.
class Totals {
 public:
  Totals() = default;
  /// `count` is the number of tallies. x of a tally counts points, y sheets, z triangles; w is unused.
  Totals(const std::string& name, int count);
  Totals(const Totals&) = delete;
  Totals& operator=(const Totals&) = delete;
  Totals(Totals&& other) noexcept { *this = std::move(other); }
  Totals& operator=(Totals&& other) noexcept;
  ~Totals() { glDeleteSync(fence_); }

  struct Room {
    std::int64_t fixed = 0;  ///< Number of constant indices.
    unsigned perSheet = 0,
             perPoint = 0;  ///< Number of indices per sheet and per point. A triangle always has three.
    std::int64_t points = 0, indices = 0;  ///< Capacity of the buffers in points and in indices.
  };
  /// Dispatches the kernels without waiting for them.
  void run(const gl::WordsArray& tallies, const Room& room);
  /// Waits for the latest run; returns false if there was none. Throws UserError(device).
  [[nodiscard]] bool wait();
  /// Returns the counts; valid after wait().
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

/// Returns the new capacity for `now` elements. If the capacity `room` suffices, it is kept. Otherwise the
/// new capacity is 1.25 times `now`, because a growing field would need more in each of the next frames. It
/// is at most `limit`, but at least `now`.
[[nodiscard]] std::int64_t grownRoom(std::int64_t now, std::int64_t room, std::int64_t limit);

/// Throws UserError(device) if a buffer of `count` elements of `bytes` bytes exceeds a device limit.
/// `whose` is the beginning of the message, such as "the solid of"; `smaller` is advice for the user.
void checkBufferRoom(const char* whose, const std::string& name, const char* what, std::int64_t count,
                     int bytes, const char* smaller);

}  // namespace simreel::sim
