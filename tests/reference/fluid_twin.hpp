#pragma once
#include "sim/fluid/plan.hpp"

#include <memory>
#include <vector>

#include <glm/vec4.hpp>

/// CPU twin of a fluid. It runs the kernels' own arithmetic (glsl/fluid compiled as C++) cell by cell. The
/// multigrid solver is a series of plain sweeps over its levels. Equals the GPU bit for bit in exact mode.
class FluidTwin {
 public:
  /// Creates the first state, at the time `start` (seconds).
  explicit FluidTwin(simreel::sim::FluidPlan plan, double start = 0);

  /// Steps one frame that starts at `time` (seconds).
  void step(double time);

  /// Sets the uniforms of the substep that the following functions compute.
  void setStep(const simreel::shader::FluidStep& step) { step_ = step; }

  // The following functions are the stages of a substep.
  /// Gives the obstacles their state after `step` substeps of the frame that starts at `time` (seconds).
  void place(double time, int step);
  void advect();  ///< Advects the flow, and applies forces.
  void paint(double time, int step);
  void project();
  void moveDye();

  /// Returns the displayed cells: colour in rgb, and the value in a.
  [[nodiscard]] std::vector<glm::vec4> shown() const;
  /// Returns the brightness of the flow lines at `time` (seconds), with lineDetail samples per cell along
  /// each axis.
  [[nodiscard]] std::vector<float> lines(double time) const;
  [[nodiscard]] const simreel::sim::FluidPlan& plan() const { return plan_; }
  [[nodiscard]] const simreel::sim::FluidSolids& solids() const { return *solids_; }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>((y + 1) * (plan_.size().x + 2) + x + 1);
  }
  /// Returns the maximum over the cells of the absolute flow imbalance, divided by max|u|.
  [[nodiscard]] double divergence() const;

  std::vector<glm::vec4> flow, dye;  ///< one element per cell, including the ring of border cells, x
                                     ///< fastest
  long cycles = 0;                   ///< number of multigrid cycles so far

 private:
  /// One level of the multigrid solver, with face weights, right-hand side and solution.
  struct Level {
    glm::ivec2 cells;
    bool wrapsX, wrapsY;
    std::vector<glm::vec2> faces;  ///< face weights, (cells.x + 1) x (cells.y + 1)
    std::vector<float> rhs, value;

    [[nodiscard]] std::size_t index(int x, int y) const {
      return static_cast<std::size_t>(y * cells.x + x);
    }
    [[nodiscard]] glm::vec4 weights(int x, int y) const {
      const auto face = [&](int i, int j) {
        return faces.at(static_cast<std::size_t>(j * (cells.x + 1) + i));
      };
      return {face(x, y).x, face(x + 1, y).x, face(x, y).y, face(x, y + 1).y};
    }
    /// Returns the value of a cell, or 0 outside the grid.
    [[nodiscard]] float at(const std::vector<float>& of, int x, int y) const {
      if (wrapsX) x = (x + cells.x) % cells.x;
      if (wrapsY) y = (y + cells.y) % cells.y;
      return x < 0 || y < 0 || x >= cells.x || y >= cells.y ? 0 : of[index(x, y)];
    }
    [[nodiscard]] float sumAround(const std::vector<float>& of, int x, int y) const {
      return simreel::shader::neighbours(weights(x, y), at(of, x - 1, y), at(of, x + 1, y),
                                         at(of, x, y - 1), at(of, x, y + 1));
    }
    [[nodiscard]] float leftIn(int x, int y) const {
      return simreel::shader::residual(rhs[index(x, y)], weights(x, y), value[index(x, y)],
                                       at(value, x - 1, y), at(value, x + 1, y), at(value, x, y - 1),
                                       at(value, x, y + 1));
    }
    template <class Change>
    void eachOf(int color, const Change& change) {
      const std::vector<float> before = value;
      for (int y = 0; y < cells.y; ++y)
        for (int x = 0; x < cells.x; ++x)
          if ((x + y) % 2 == color) change(x, y, before);
    }
    /// Relaxes the cells of one colour of a red-black checkerboard, based on the values before the call.
    void relax(int color) {
      eachOf(color, [&](int x, int y, const std::vector<float>& before) {
        value[index(x, y)] = simreel::shader::relaxed(rhs[index(x, y)], sumAround(before, x, y),
                                                      simreel::shader::diagonal(weights(x, y)));
      });
    }
    void sweep() {
      for (const int color : {0, 1}) relax(color);
    }
    /// Runs a level's first sweep on the way from fine to coarse levels, starting with a zero solution.
    void begin() {
      eachOf(0, [&](int x, int y, const std::vector<float>&) {
        value[index(x, y)] =
            simreel::shader::begun(rhs[index(x, y)], simreel::shader::diagonal(weights(x, y)));
      });
      relax(1);
    }
  };
  void cycle();
  void descend(std::size_t level);
  void bottom();
  void ascend(std::size_t level);

  simreel::sim::FluidPlan plan_;
  std::shared_ptr<const simreel::sim::FluidSolids> solids_;
  simreel::shader::FluidStep step_{};
  std::vector<glm::vec4> carried_;
  std::vector<glm::vec2> sum_;  ///< x: sum of the corrections of each cell; y: rounding error of the sum
  std::vector<Level> levels_;
};
