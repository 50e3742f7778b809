#include "sim/kernels/programs.hpp"

#include "base/error.hpp"
#include "scene/json/words.hpp"
#include "sim/kernels/arithmetic.hpp"

#include <algorithm>
#include <filesystem>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

KernelPrograms::KernelPrograms(const std::string& name, const std::vector<kernels::Request>& requests)
    : name_(name) {
  for (kernels::Request request : requests) {
    request.careful = !request.fast && kernelArithmetic() == Arithmetic::careful;
    const auto shader = KernelPlan::shaderOf(request);
    const std::string file =
        shader->files.empty() ? name : std::filesystem::path(shader->files.front()).filename().string();
    for (const kernels::Kernel& kernel : shader->kernels) {
      const std::string label = fmt::format("{}: kernel {}", file, kernel.name);
      programs_.push_back(request.fast ? gl::Program::computeText(label, kernel.body())
                                       : kernelProgram(label, kernel.body()));
      std::vector<UniformBlock>& blocks = blocks_.emplace_back();
      for (const kernels::Block& block : kernel.blocks)
        blocks.push_back({gl::Buffer(fmt::format("{} constants of {}", name, kernel.name),
                                     std::max<std::size_t>(16, block.bytes)),
                          {}});
      kernels_.push_back(kernel);
    }
  }
}

/// Throws for more than 2^31 invocations, because a dispatch of that size would occupy a machine for hours.
void KernelPrograms::checkGroupCount(const kernels::Kernel& kernel, const glm::uvec3& groups) const {
  constexpr double invocationLimit = 2147483648.0;
  const double invocations =
      1.0 * groups.x * groups.y * groups.z * kernel.threads[0] * kernel.threads[1] * kernel.threads[2];
  if (invocations <= invocationLimit) return;
  fail(ExitCode::device,
       "kernels {}: a dispatch of kernel {} has {} x {} x {} groups of {} x {} x {} threads, but at most "
       "{:.0f} threads are allowed; check \"threads\", or the buffer that \"indirect\" names",
       scene::inQuotes(name_), scene::inQuotes(kernel.name), groups.x, groups.y, groups.z,
       kernel.threads[0], kernel.threads[1], kernel.threads[2], invocationLimit);
}

glm::uvec3 KernelPrograms::groups(const KernelPlan& plan, const PlannedEntry& entry,
                                  const KernelPlan::Now& now) {
  return entry.indirect >= 0 ? glm::uvec3(1) : plan.groups(entry, now);
}

void KernelPrograms::dispatch(KernelStore& store, const PlannedEntry& entry, const KernelPlan::Now& now) {
  const auto place = static_cast<std::size_t>(entry.kernel);
  const kernels::Kernel& kernel = kernels_[place];
  for (std::size_t b = 0; b < kernel.blocks.size(); ++b) {
    UniformBlock& block = blocks_[place][b];
    // A write makes a card wait for the dispatches that read the block.
    if (std::vector<std::byte> bytes = store.plan().blockBytes(kernel.blocks[b], now);
        bytes != block.bytes) {
      block.buffer.write(0, bytes);
      block.bytes = std::move(bytes);
    }
    block.buffer.bindUniform(static_cast<GLuint>(kernel.blocks[b].binding), 0, block.buffer.bytes());
  }
  store.bind(kernel);
  gl::AccessLog::barrier(GL_ALL_BARRIER_BITS);
  if (entry.indirect >= 0) {
    glm::uvec3 counts;
    store.buffer(entry.indirect).read(entry.offset, std::as_writable_bytes(std::span(&counts, 1)));
    checkGroupCount(kernel, counts);
    return programs_[place].dispatchIndirect(store.buffer(entry.indirect), entry.offset);
  }
  const glm::uvec3 groups = store.plan().groups(entry, now);
  checkGroupCount(kernel, groups);
  if (groups.x > 0 && groups.y > 0 && groups.z > 0)
    programs_[place].dispatchGroups(groups.x, groups.y, groups.z);
}

}  // namespace simreel::sim
