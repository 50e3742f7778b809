#pragma once
#include "base/error.hpp"
#include "kernels/kernels.hpp"
#include "sim/core/kind.hpp"
#include "sim/kernels/description.hpp"
#include "sim/kernels/plan.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Parameters of the object kind "kernels".
struct KernelsParameters : ObjectParameters, HasColorRange, KernelDescription, scene::Covering {
  /// Created by describe() while a scene is loaded; null if the file cannot be compiled.
  std::shared_ptr<const KernelPlan> plan;
  /// Requests from which the shader was compiled: one per pass of an image, otherwise one.
  std::vector<kernels::Request> requests;
  /// Error message of the compiler; empty if none exists.
  std::string problem;
  bool problemIsReport = false;  ///< true if the message already contains source positions and carets

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  [[nodiscard]] std::vector<MeasuredRange> measuredRanges() override;
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override { return quantityList; }
  [[nodiscard]] const char* drawnWith() const override;
  /// Returns `part` for a field over the whole picture, too, because such kernels may also draw things in
  /// the world.
  [[nodiscard]] Extent covering() const override;
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  [[nodiscard]] Looks looks() const override;
  [[nodiscard]] bool motionIsUnpredictable() const override;
  /// Returns the files of the shaders, including the files that they include.
  [[nodiscard]] std::vector<std::filesystem::path> shaderFiles() const;

 protected:
  /// Creates the plan of a shader and reports errors in the scene.
  void makePlan(scene::Fields& fields, std::shared_ptr<const kernels::Shader> shader,
                const std::vector<std::string>& announced,
                const std::map<std::string, std::string>& aliases = {});
  /// Stores the message of a compiler error.
  void keepProblem(const UserError& error);

 private:
  void describeMemory(scene::Fields& fields);
  void describeDrawn(scene::Fields& fields);
  void compile(scene::Fields& fields);
  std::vector<scene::Quantity> quantityList;
};

}  // namespace simreel::sim
