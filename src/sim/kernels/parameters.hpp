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

/// Parameters of the kind kernels.
struct KernelsParameters : ObjectParameters, KernelDescription {
  /// Made by describe() where a scene is read; null: the file cannot be compiled.
  std::shared_ptr<const KernelPlan> plan;
  kernels::Request request;  ///< that its shader was made of
  /// Message of the compiler; empty: there is none.
  std::string problem;
  bool problemIsReport = false;  ///< it says places and carets itself

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override { return quantityList; }
  [[nodiscard]] const char* drawnWith() const override;
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  [[nodiscard]] Looks looks() const override;
  [[nodiscard]] bool wanders() const override;
  /// Returns the files of its shaders, with what they include.
  [[nodiscard]] std::vector<std::filesystem::path> shaderFiles() const;

 protected:
  /// Makes the plan of a shader, and reports its mistakes.
  void makePlan(scene::Fields& fields, std::shared_ptr<const kernels::Shader> shader,
                const std::vector<std::string>& announced,
                const std::map<std::string, std::string>& aliases = {});
  /// Keeps the message of a compiler.
  void keepProblem(const UserError& error);

 private:
  void describeMemory(scene::Fields& fields);
  void describeDrawn(scene::Fields& fields);
  void compile(scene::Fields& fields);
  std::vector<scene::Quantity> quantityList;
};

}  // namespace simreel::sim
