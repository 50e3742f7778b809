#include "sim/kernels/races.hpp"

#include "scene/json/words.hpp"

#include <algorithm>
#include <map>

#include <climits>
#include <fmt/format.h>

namespace simreel::sim {

namespace {

std::vector<kernels::Request> variant(kernels::Request request, kernels::Race race) {
  request.race = race;
  request.report = race == kernels::Race::check;
  return {request};
}

constexpr unsigned unknown = UINT_MAX;

std::string invocation(unsigned linear, const glm::uvec3& all) {
  return fmt::format("({}, {}, {})", linear % all.x, linear / all.x % all.y, linear / all.x / all.y);
}

/// Returns a description of an element's position: coordinates for a texture or a buffer with several axes,
/// otherwise an index.
std::string elementText(const KernelPlan& plan, const std::string& of, unsigned index) {
  glm::ivec3 size(0);
  if (const int buffer = plan.bufferNamed(of); buffer >= 0)
    size = plan.buffers()[static_cast<std::size_t>(buffer)].size;
  if (const int texture = plan.textureNamed(of); texture >= 0)
    size = plan.textures()[static_cast<std::size_t>(texture)].size;
  if (size.y <= 1) return fmt::format("element {}", index);
  const auto width = static_cast<unsigned>(size.x), height = static_cast<unsigned>(size.y);
  if (size.z <= 1) return fmt::format("element ({}, {})", index % width, index / width);
  return fmt::format("element ({}, {}, {})", index % width, index / width % height, index / width / height);
}

/// Returns true if `of` is the name of shared memory of a workgroup.
bool isShared(const KernelPlan& plan, const std::string& of) {
  return plan.textureNamed(of) < 0 && plan.bufferNamed(of) < 0;
}

/// Returns the advice at the end of a race message.
const char* cureOf(const KernelPlan& plan, const std::string& of) {
  if (plan.textureNamed(of) >= 0) return "write to a second texture, and \"swap\" them";
  if (isShared(plan, of)) return "put a barrier between: GroupMemoryBarrierWithGroupSync() or barrier()";
  return "write to a second buffer and \"swap\" them, or give the buffer \"previous\": true";
}

/// Shadow buffers by name, used by both the recording and the checking variant of a kernel.
using Shadows = std::map<std::string, gl::Buffer>;

void bindShadows(const KernelPlan& plan, const kernels::Kernel& kernel, Shadows& shadows) {
  for (const kernels::Buffer& buffer : kernel.buffers) {
    if (buffer.shadowOf.empty()) continue;
    gl::Buffer& shadow = shadows[buffer.name];
    if (shadow.bytes() == 0) {
      const int of = plan.bufferNamed(buffer.shadowOf);
      const std::size_t words =
          of >= 0 ? plan.buffers()[static_cast<std::size_t>(of)].bytes() / 4
                  : plan.textures()[static_cast<std::size_t>(plan.textureNamed(buffer.shadowOf))].count();
      shadow = gl::Buffer("shadow of " + buffer.shadowOf,
                          words * 4 * static_cast<std::size_t>(std::max(1, buffer.shadowWords)));
    }
    shadow.bindStorage(static_cast<GLuint>(buffer.binding));
  }
}

}  // namespace

KernelRaces::KernelRaces(const std::string& name, const kernels::Request& request)
    : name_(name),
      record_(name, variant(request, kernels::Race::record)),
      check_(name, variant(request, kernels::Race::check)) {}

void KernelRaces::dispatch(KernelStore& store, const PlannedEntry& entry, const KernelPlan::Now& now) {
  Shadows shadows;
  const bool again = searches_[&entry]++ >= 2;
  const KernelStore::Saved before = again ? KernelStore::Saved{} : store.save();
  bindShadows(store.plan(), record_.kernel(entry.kernel), shadows);
  record_.dispatch(store, entry, now);
  if (again) return;
  store.restore(before);
  const kernels::Kernel& kernel = check_.kernel(entry.kernel);
  const std::vector<glm::uvec4> none(std::max<std::size_t>(1, kernel.places.size()),
                                     {0, UINT_MAX, INT_MAX, 0x80000000U});
  gl::Buffer reports = gl::Buffer::of(name_ + " races", std::span<const glm::uvec4>(none));
  bindShadows(store.plan(), kernel, shadows);
  if (kernel.report >= 0) reports.bindStorage(static_cast<GLuint>(kernel.report));
  check_.dispatch(store, entry, now);
  gl::AccessLog::barrier(GL_ALL_BARRIER_BITS);
  const auto counted = reports.readAll<glm::uvec4>();
  if (std::none_of(counted.begin(), counted.end(), [](const glm::uvec4& place) { return place.x > 0; }))
    return;
  // Runs the check again and counts only the first invocation at each source position, to get the element
  // indices of that invocation.
  std::vector<glm::uvec4> first = none;
  for (std::size_t i = 0; i < first.size(); ++i)
    first[i] = {0x80000000U, counted[i].y, INT_MAX, 0x80000000U};
  reports.write(0, std::as_bytes(std::span(first)));
  store.restore(before);
  check_.dispatch(store, entry, now);
  gl::AccessLog::barrier(GL_ALL_BARRIER_BITS);
  std::vector<glm::uvec4> met = reports.readAll<glm::uvec4>();
  for (std::size_t i = 0; i < met.size(); ++i) {
    // The second run may miss an access of the first run, because a race changes what invocations do.
    const bool known = static_cast<int>(met[i].w) >= 0;
    met[i] = {counted[i].x, counted[i].y, known ? met[i].z : unknown, known ? met[i].w : unknown};
  }
  collect(store, entry, now, met);
}

void KernelRaces::collect(const KernelStore& store, const PlannedEntry& entry, const KernelPlan::Now& now,
                          const std::vector<glm::uvec4>& words) {
  const kernels::Kernel& kernel = check_.kernel(entry.kernel);
  const glm::uvec3 all = glm::max(KernelPrograms::groups(store.plan(), entry, now) *
                                      glm::uvec3(kernel.threads[0], kernel.threads[1], kernel.threads[2]),
                                  glm::uvec3(1));
  for (std::size_t i = 0; i < kernel.places.size(); ++i) {
    const kernels::Place& place = kernel.places[i];
    if (words[i].x == 0 || !place.kind.starts_with("race") || !reported_.emplace(entry.kernel, i).second)
      continue;
    const bool reads = place.kind == "race-read", shared = isShared(store.plan(), place.what);
    const std::string member = place.part.empty() ? "" : scene::inQuotes(place.part) + " of ";
    const std::string element =
        words[i].w == unknown ? "" : elementText(store.plan(), place.what, words[i].w) + " of ";
    const std::string other =
        words[i].z == unknown ? "another invocation" : "invocation " + invocation(words[i].z, all);
    found_.push_back(
        fmt::format("kernels {}: {}:{}: kernel {} races: invocation {} {} {}{}{}, which {} {} in the same "
                    "dispatch ({} invocation{} in all); {}",
                    scene::inQuotes(name_), place.file, place.line, scene::inQuotes(kernel.name),
                    invocation(words[i].y, all), reads ? "reads" : "writes", member, element,
                    scene::inQuotes(place.what), other, reads || !shared ? "writes" : "reads", words[i].x,
                    words[i].x == 1 ? "" : "s", cureOf(store.plan(), place.what)));
  }
}

}  // namespace simreel::sim
