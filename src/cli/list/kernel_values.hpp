#pragma once
#include "kernels/shader/shader.hpp"
#include "sim/kernels/slots.hpp"

#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace simreel::cli {

/// Guesses sizes of memory and values of constants from the names that a shader uses, for a first scene.
class KernelGuess {
 public:
  explicit KernelGuess(const kernels::Shader& shader);

  /// Returns the number of elements along each axis for a buffer that has no length in the shader. The
  /// buffer is a 2-D grid if the shader has constants for the width of a grid and no textures.
  [[nodiscard]] glm::ivec3 bufferSize() const { return bufferSize_; }
  [[nodiscard]] static glm::ivec3 textureSize(const kernels::Texture& texture);
  /// Returns the value of a constant that `kernel` reads. This is the time, a size of the memory that the
  /// kernel writes, a seed and so on, and otherwise 1. One number or expression sets all components.
  [[nodiscard]] nlohmann::ordered_json value(const kernels::Kernel& kernel,
                                             const sim::KernelSlot& constant) const;

 private:
  [[nodiscard]] nlohmann::ordered_json sizeValue(const kernels::Kernel& kernel,
                                                 const sim::KernelSlot& constant) const;
  [[nodiscard]] std::string countValue(const kernels::Kernel& kernel, const std::string& name) const;
  /// Returns the name of the grid whose size a constant of `kernel` may be. Returns an empty text if there
  /// is no such grid.
  [[nodiscard]] std::string gridOf(const kernels::Kernel& kernel) const;

  const kernels::Shader& shader_;
  glm::ivec3 bufferSize_{1024, 1, 1};
};

/// True for an array without a length in the shader.
[[nodiscard]] bool isOpen(const kernels::Buffer& buffer);

}  // namespace simreel::cli
