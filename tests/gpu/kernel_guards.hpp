#pragma once
// Runs user kernels on buffers of words.
#include "gl/buffer.hpp"
#include "gl/element_array.hpp"
#include "gl/program.hpp"
#include "gpu/context.hpp"
#include "kernels/kernels.hpp"
#include "sim/kernels/arithmetic.hpp"

#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <climits>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::test {

using Numbers = std::vector<std::uint32_t>;
using Buffers = std::map<std::string, Numbers>;

inline kernels::Kernel guarded(const std::string& text, kernels::Request request,
                               const std::string& name = "guards.hlsl") {
  const auto path = temporaryFile(name);
  std::ofstream(path) << text;
  request.file = path;
  request.careful = !request.fast && sim::kernelArithmetic() == sim::Arithmetic::careful;
  kernels::Shader shader = kernels::loadHere(request);
  std::filesystem::remove(path);
  return std::move(shader.kernels.at(0));
}

inline kernels::Request reporting(unsigned maxIterations = 0) {
  kernels::Request request;
  request.report = true;
  request.maxIterations = maxIterations;
  return request;
}

inline Numbers untouched(std::size_t places) {
  Numbers words;
  for (std::size_t i = 0; i < places; ++i)
    words.insert(words.end(),
                 {0, UINT32_MAX, static_cast<std::uint32_t>(INT_MAX), static_cast<std::uint32_t>(INT_MIN)});
  return words;
}

/// Returns the initial words of a buffer: the words of `given`, followed by guard elements. A shadow buffer
/// starts with the words in `given`, or with zeros.
inline Numbers start(const kernels::Kernel& kernel, const kernels::Buffer& buffer, const Buffers& given) {
  if (!buffer.shadowOf.empty()) {
    if (given.contains(buffer.name)) return given.at(buffer.name);
    for (const kernels::Buffer& other : kernel.buffers)
      if (other.name == buffer.shadowOf)
        return Numbers(start(kernel, other, given).size() * static_cast<std::size_t>(buffer.shadowWords));
    return Numbers(1024);  // words of the shadow of an image
  }
  Numbers words = given.at(buffer.previousOf.empty() ? buffer.name : buffer.previousOf);
  words.resize(words.size() + static_cast<std::size_t>(buffer.guards) *
                                  (buffer.members.back().stride / sizeof(std::uint32_t)));
  return words;
}

/// Runs a kernel on buffers of words, to which it appends the guard elements. Returns the final buffers,
/// and the report as "report".
inline Buffers ran(const kernels::Kernel& kernel, const Buffers& given, GLuint groups) {
  std::vector<std::pair<const kernels::Buffer*, gl::Buffer>> bound;
  for (const kernels::Buffer& buffer : kernel.buffers) {
    bound.emplace_back(&buffer, gl::Buffer::of<std::uint32_t>(buffer.name, start(kernel, buffer, given)));
    bound.back().second.bindStorage(static_cast<GLuint>(buffer.binding));
  }
  const gl::Buffer report = gl::Buffer::of<std::uint32_t>(
      "report", given.contains("report") ? given.at("report") : untouched(kernel.places.size() + 1));
  if (kernel.report >= 0) report.bindStorage(static_cast<GLuint>(kernel.report));
  sim::kernelProgram("kernel", kernel.body()).dispatchGroups(groups, 1, 1);
  gl::barrier();
  Buffers made;
  for (const auto& one : bound) {
    Numbers words = one.second.readAll<std::uint32_t>();
    if (given.contains(one.first->name)) words.resize(given.at(one.first->name).size());
    made[one.first->name] = std::move(words);
  }
  made["report"] = report.readAll<std::uint32_t>();
  return made;
}

/// Returns "kind what.part:line count invocation min max" for each source position with a reported fault.
inline std::string faults(const kernels::Kernel& kernel, const Buffers& made) {
  std::vector<std::string> lines;
  const Numbers& words = made.at("report");
  for (std::size_t i = 0; i < kernel.places.size(); ++i) {
    const kernels::Place& place = kernel.places[i];
    if (words[4 * i] != 0)
      lines.push_back(fmt::format("{} {}{}:{} {} {} {} {}", place.kind, place.what,
                                  place.part.empty() ? "" : "." + place.part, place.line, words[4 * i],
                                  words[4 * i + 1], static_cast<int>(words[4 * i + 2]),
                                  static_cast<int>(words[4 * i + 3])));
  }
  return fmt::format("{}", fmt::join(lines, "; "));
}

inline std::string text(const Numbers& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

/// Returns the races of a dispatch. The dispatch runs twice from equal states, first to record accesses and
/// then to check them. `prepare` sets state other than buffers, such as images.
template <class Prepare>
std::string racesWith(Prepare prepare, const std::string& source, const Buffers& given, GLuint groups,
                      const std::string& name = "guards.hlsl") {
  kernels::Request request;
  request.race = kernels::Race::record;
  const kernels::Kernel records = guarded(source, request, name);
  prepare(records);
  Buffers again = given;
  for (auto& [buffer, words] : ran(records, given, groups))
    if (buffer.ends_with(".shadow")) again[buffer] = std::move(words);
  request.race = kernels::Race::check;
  const kernels::Kernel checks = guarded(source, request, name);
  prepare(checks);
  return faults(checks, ran(checks, again, groups));
}
inline std::string races(const std::string& source, const Buffers& given, GLuint groups,
                         const std::string& name = "guards.hlsl") {
  return racesWith([](const kernels::Kernel&) {}, source, given, groups, name);
}

inline Numbers counted(std::uint32_t n, std::uint32_t from = 0) {
  Numbers words(n);
  for (std::uint32_t i = 0; i < n; ++i) words[i] = from + i;
  return words;
}

}  // namespace simreel::test
