#include "sim/kernels/reports.hpp"

#include "gl/element_array.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <array>

#include <climits>
#include <fmt/format.h>

namespace simreel::sim {

struct ReportsKernel {
  static constexpr auto file = "kernels/run/reports.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"first", int> first;
  gl::Uniform<"frame", unsigned> frame;
  gl::Uniform<"goesOn", bool> goesOn;
  gl::In<"reports"> reports;
  gl::InOut<"caught"> caught;
  gl::InOut<"StatusBlock"> status;
};

namespace {

constexpr glm::uvec4 nothing{0, UINT_MAX, INT_MAX, 0x80000000U};

/// Returns the number of valid indices of a buffer or of one axis of a texture; 0 if the number is known
/// only inside the shader.
std::size_t lengthOf(const KernelPlan& plan, const kernels::Place& place) {
  if (const int buffer = plan.bufferNamed(place.what); buffer >= 0)
    return plan.buffers()[static_cast<std::size_t>(buffer)].count();
  const int texture = plan.textureNamed(place.what);
  if (texture < 0) return 0;
  const glm::ivec3 size = plan.textures()[static_cast<std::size_t>(texture)].size;
  return static_cast<std::size_t>(place.part == "y" ? size.y : place.part == "z" ? size.z : size.x);
}

std::string indices(const KernelPlan& plan, const kernels::Place& place, const glm::uvec4& words) {
  const auto low = static_cast<int>(words.z), high = static_cast<int>(words.w);
  const std::string range = low == high ? std::to_string(low) : fmt::format("{} to {}", low, high);
  const std::size_t length = lengthOf(plan, place);
  const std::string axis = place.part.empty() ? "" : place.part + " = ";
  return length == 0 ? fmt::format("at {}{}, out of bounds", axis, range)
                     : fmt::format("at {}{}, but it has {} {}", axis, range, length,
                                   place.part.empty() ? "elements" : "texels there");
}

}  // namespace

KernelReports::KernelReports(const std::string& name, const KernelPlan& plan, const KernelFinite& finite,
                             bool goesOn)
    : name_(name), plan_(plan), finite_(finite), goesOn_(goesOn) {
  for (const kernels::Kernel& kernel : plan.shader().kernels) {
    const std::vector<glm::uvec4> words(std::max<std::size_t>(1, kernel.places.size()), nothing);
    reports_.push_back(gl::Buffer::of(fmt::format("{} reports of {}", name, kernel.name),
                                      std::span<const glm::uvec4>(words)));
    places_ += kernel.places.size();
  }
  threads_.resize(reports_.size(), glm::uvec3(1));
  const std::array<unsigned, 4> well = {UINT_MAX, UINT_MAX, 0, UINT_MAX};
  status_ = gl::Buffer::of(name + " status", std::span<const unsigned>(well));
  caught_ = gl::Buffer(name + " caught reports", (places_ + KernelFinite::parts) * 16);
  kernel_ = gl::Kernel<ReportsKernel>(gl::kernelDefines(false));
}

KernelReports::~KernelReports() = default;

void KernelReports::bind(std::size_t kernel, glm::uvec3 threads) {
  threads_[kernel] = threads;
  const int binding = plan_.shader().kernels[kernel].report;
  if (binding >= 0) reports_[kernel].bindStorage(static_cast<GLuint>(binding));
}

void KernelReports::collect(long frame) {
  if (status() == nullptr) return;
  const auto collectFrom = [&](const gl::Buffer& reports, int count, int first, bool goesOn) {
    kernel_.dispatch(1, {.count = count,
                         .first = first,
                         .frame = static_cast<unsigned>(std::max(0L, frame)),
                         .goesOn = goesOn,
                         .reports = reports,
                         .caught = caught_,
                         .status = status_});
  };
  int first = 0;
  for (std::size_t i = 0; i < reports_.size(); ++i) {
    const auto count = static_cast<int>(plan_.shader().kernels[i].places.size());
    if (count > 0) collectFrom(reports_[i], count, first, goesOn_);
    first += count;
  }
  if (finite_.watches()) collectFrom(finite_.reports(), KernelFinite::parts, first, finite_.goesOn());
  gl::barrier();
}

std::string KernelReports::message() const {
  const auto words = caught_.readAll<glm::uvec4>();
  const auto caught = std::find_if(words.begin(), words.end(), [](const glm::uvec4& w) { return w.x > 0; });
  return message(static_cast<unsigned>(caught - words.begin()));
}

std::string KernelReports::message(unsigned report) const {
  const auto words = caught_.readAll<glm::uvec4>();
  const unsigned frame = status_.readAll<unsigned>()[3];
  if (report < places_ || report >= words.size()) return messageOfKernels(words, frame);
  return finite_.message(static_cast<int>(report - places_), words[report], frame);
}

std::string KernelReports::messageOfKernels(std::span<const glm::uvec4> words, unsigned frame) const {
  std::size_t at = 0;
  std::string line;
  int others = 0;
  std::string kind;
  for (std::size_t k = 0; k < reports_.size(); ++k) {
    const kernels::Kernel& kernel = plan_.shader().kernels[k];
    for (const kernels::Place& place : kernel.places) {
      const glm::uvec4& caught = words[at++];
      if (caught.x == 0) continue;
      if (!line.empty()) {
        ++others;
        continue;
      }
      kind = place.kind;
      const glm::uvec3 all = glm::max(threads_[k], glm::uvec3(1));
      const unsigned i = caught.y;
      const std::string deed =
          kind == "loop" ? "has a loop that did not end within \"iterations\""
          : kind == "loops"
              ? "has loops that this driver ended: it counts 65,535 iterations of all loops together"
              : fmt::format("{}s {} {}", kind, scene::inQuotes(place.what), indices(plan_, place, caught));
      line = fmt::format(
          "kernels {}, frame {}: {}:{}: kernel {} {} ({} invocation{}; the first is ({}, {}, {}))",
          scene::inQuotes(name_), frame, place.file, place.line, scene::inQuotes(kernel.name), deed,
          caught.x, caught.x == 1 ? "" : "s", i % all.x, i / all.x % all.y, i / all.x / all.y);
    }
  }
  if (others > 0) line += fmt::format(", and {} more place{}", others, others == 1 ? "" : "s");
  if (kind == "loop") return line + "; mend the loop, or raise \"iterations\"";
  if (kind == "loops") return line + "; do fewer in one dispatch, or run on a GPU";
  return line + (goesOn_ ? "; such reads give 0, such writes do nothing"
                         : "; test the index in the kernel, or give \"bounds\": \"ignore\"");
}

}  // namespace simreel::sim
