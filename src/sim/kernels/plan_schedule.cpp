// The part of KernelPlan that plans schedules: which kernels run, with how many invocations, and the
// operations between them.
#include "base/file.hpp"
#include "kernels/source/files.hpp"
#include "scene/json/words.hpp"
#include "sim/kernels/plan.hpp"
#include "sim/kernels/threads.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>

namespace simreel::sim {

void KernelPlan::everyKernel() {
  for (std::size_t i = 0; i < shader_->kernels.size(); ++i) {
    PlannedEntry entry;
    entry.kernel = static_cast<int>(i);
    useUsualThreads({"file"}, entry);
    step_.push_back(std::move(entry));
  }
}

void KernelPlan::useUsualThreads(std::vector<std::string> path, PlannedEntry& entry) {
  const kernels::Kernel& kernel = shader_->kernels[static_cast<std::size_t>(entry.kernel)];
  const KernelSizes sizes = {
      .texture = [this](const kernels::Texture& texture) { return sizeOf(texture.name); },
      .buffer = [this](const kernels::Buffer& buffer) { return sizeOf(buffer.name); },
      .counted =
          [this](const kernels::Buffer& buffer) { return bufferNamed(buffer.name + ".counter") >= 0; }};
  const std::optional<glm::ivec3> threads = usualThreads(kernel, sizes);
  if (!threads)
    return mistake(std::move(path), fmt::format("kernel {} has groups of {} x {} x {}, and what it writes "
                                                "does not tell how many threads it needs; give "
                                                "\"threads\": [x, y, z]",
                                                scene::inQuotes(kernel.name), kernel.threads[0],
                                                kernel.threads[1], kernel.threads[2]));
  entry.threads = {{1.0 * threads->x, nullptr}, {1.0 * threads->y, nullptr}, {1.0 * threads->z, nullptr}};
}

void KernelPlan::planEntries(const std::vector<KernelEntry>& given, const char* list,
                             const std::vector<std::string>& announced, int perFrame,
                             std::vector<PlannedEntry>& planned) {
  constexpr double maxDispatches = 100000;
  double dispatches = 0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const KernelEntry& from = given[i];
    const std::vector<std::string> path = {list, std::to_string(i)};
    const auto at = [&](const char* key) {
      std::vector<std::string> longer = path;
      longer.emplace_back(key);
      return longer;
    };
    PlannedEntry entry;
    entry.repeat = from.repeat;
    entry.every = from.every;
    entry.offset = static_cast<std::size_t>(from.offset);
    if (!from.kernel.empty()) {
      const auto& kernels = shader_->kernels;
      const auto found = std::find_if(kernels.begin(), kernels.end(), [&](const kernels::Kernel& kernel) {
        return kernel.name == from.kernel;
      });
      if (found == kernels.end()) {
        if (const std::string file = announcedIn(from.kernel); !file.empty())
          mistake(at("kernel"),
                  fmt::format("the kernel {} is announced in {}, which the shader includes; as in "
                              "Unity, \"#pragma kernel\" counts in the shader itself alone",
                              scene::inQuotes(from.kernel), file));
        else
          unknown(at("kernel"), from.kernel, announced, "kernel");
        continue;
      }
      entry.kernel = static_cast<int>(found - kernels.begin());
      planThreads(from, path, entry);
    }
    planBetween(from, path, entry);
    if ((dispatches += 1.0 * perFrame * from.repeat / from.every) > maxDispatches)
      mistake(at("repeat"),
              fmt::format("{:.0f} dispatches a frame are more than {:.0f}; give fewer repeats, or "
                          "longer loops in the kernel",
                          dispatches, maxDispatches));
    if (from.kernel.empty() && from.swap.empty() && from.clear.empty() && from.count.empty())
      mistake(path, "an entry has a \"kernel\", a \"swap\", a \"clear\" or a \"count\"");
    planned.push_back(std::move(entry));
  }
}

std::string KernelPlan::announcedIn(const std::string& kernel) const {
  for (const std::string& file : shader_->files) {
    std::istringstream lines(kernels::withoutComments(readFile(file, "shader", kernels::maxFileBytes)));
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string pragma, word, name;
      words >> pragma >> word >> name;
      if (pragma == "#pragma" && word == "kernel" && name == kernel)
        return std::filesystem::path(file).filename().string();
    }
  }
  return {};
}

void KernelPlan::planThreads(const KernelEntry& given, const std::vector<std::string>& path,
                             PlannedEntry& entry) {
  const auto at = [&](const char* key) {
    std::vector<std::string> longer = path;
    longer.emplace_back(key);
    return longer;
  };
  if (!given.indirect.empty()) {
    entry.indirect = bufferNamed(given.indirect);
    if (entry.indirect < 0) {
      std::vector<std::string> known;
      for (const PlannedBuffer& buffer : buffers_) known.push_back(buffer.name);
      return unknown(at("indirect"), given.indirect, known, "buffer");
    }
    const PlannedBuffer& buffer = buffers_[static_cast<std::size_t>(entry.indirect)];
    if (buffer.allFloats)
      return mistake(at("indirect"), fmt::format("{} holds floats; the numbers of groups are three uints",
                                                 scene::inQuotes(given.indirect)));
    if (entry.offset % 4 != 0 || entry.offset + 12 > buffer.header + buffer.count() * buffer.stride)
      mistake(at("offset"), fmt::format("three uints at byte {} are beyond the buffer of {} bytes",
                                        entry.offset, buffer.header + buffer.count() * buffer.stride));
    if (!given.threads.empty())
      mistake(at("threads"), "an \"indirect\" dispatch has its number of work groups in the buffer");
    return;
  }
  if (given.threads.moving || given.threads.components() > 3)
    return mistake(at("threads"), "\"threads\" is one to three numbers or expressions");
  for (const scene::Formula::Part& part : given.threads.parts) {
    const PlannedNumber number = compiled(part, at("threads"));
    constexpr double frame = 1.0 / 60;
    const double threads =
        number.expression ? number.expression->at(values({frame, 0, 0, 0, 1})) : number.number;
    const bool whole = number.expression || (threads >= 1 && threads == std::floor(threads));
    if (!whole || std::isnan(threads))
      return mistake(at("threads"), fmt::format("a number of threads is a whole number from 1, found {}",
                                                std::isnan(threads) ? "NaN" : fmt::format("{}", threads)));
    entry.threads.push_back(number);
  }
  if (!entry.threads.empty()) return;
  useUsualThreads(path, entry);
}

void KernelPlan::planBetween(const KernelEntry& given, const std::vector<std::string>& path,
                             PlannedEntry& entry) {
  const auto at = [&](const char* key) {
    std::vector<std::string> longer = path;
    longer.emplace_back(key);
    return longer;
  };
  std::vector<std::string> known;
  for (const PlannedBuffer& buffer : buffers_) known.push_back(buffer.name);
  for (const PlannedTexture& texture : textures_) known.push_back(texture.name);
  const auto isKnown = [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  };
  if (!given.clear.empty()) {
    if (!isKnown(given.clear)) return unknown(at("clear"), given.clear, known, "buffer or texture");
    entry.clear = given.clear;
  }
  if (!given.swap.empty()) {
    if (given.swap.parts.size() != 2 || given.swap.parts[0].text.empty() ||
        given.swap.parts[1].text.empty())
      return mistake(at("swap"), "\"swap\" is a list of two names");
    entry.swapA = given.swap.parts[0].text;
    entry.swapB = given.swap.parts[1].text;
    if (entry.swapA == entry.swapB)
      return mistake(at("swap"), fmt::format("{} is named twice; give the two that are exchanged",
                                             scene::inQuotes(entry.swapA)));
    for (const std::string& name : {entry.swapA, entry.swapB})
      if (!isKnown(name)) return unknown(at("swap"), name, known, "buffer or texture");
    const int a = bufferNamed(entry.swapA), b = bufferNamed(entry.swapB);
    const int c = textureNamed(entry.swapA), d = textureNamed(entry.swapB);
    const auto place = [](int i) { return static_cast<std::size_t>(i); };
    if (c >= 0 && d >= 0) {
      // A texture that is only read gets the format of the texture with which it is swapped.
      PlannedTexture &one = textures_[place(c)], &other = textures_[place(d)];
      if (!one.formatted) one.format = other.format;
      if (!other.formatted) other.format = one.format;
    }
    const bool buffers = a >= 0 && b >= 0 && buffers_[place(a)].bytes() == buffers_[place(b)].bytes();
    const bool textures = c >= 0 && d >= 0 && textures_[place(c)].size == textures_[place(d)].size &&
                          textures_[place(c)].format == textures_[place(d)].format &&
                          textures_[place(c)].type == textures_[place(d)].type;
    if (!buffers && !textures)
      mistake(at("swap"),
              fmt::format("{} and {} are not alike: only memory of one size and kind is exchanged",
                          scene::inQuotes(entry.swapA), scene::inQuotes(entry.swapB)));
  }
  if (given.count.empty()) return;
  entry.count = bufferNamed(given.count + ".counter");
  entry.into = bufferNamed(given.into);
  std::vector<std::string> counted, targets;
  for (const PlannedBuffer& buffer : buffers_)
    (buffer.counterOf.empty() ? targets : counted)
        .push_back(buffer.counterOf.empty() ? buffer.name : buffer.counterOf);
  if (entry.count < 0) return unknown(at("count"), given.count, counted, "append or consume buffer");
  if (entry.into < 0) return unknown(at("into"), given.into, targets, "buffer");
  const PlannedBuffer& into = buffers_[static_cast<std::size_t>(entry.into)];
  if (entry.offset % 4 != 0 || entry.offset + 4 > into.header + into.count() * into.stride)
    mistake(at("offset"), fmt::format("byte {} is beyond the buffer of {} bytes", entry.offset,
                                      into.header + into.count() * into.stride));
}

glm::uvec3 KernelPlan::groups(const PlannedEntry& entry, const Now& now) const {
  const std::vector<double> all = values(now);
  glm::uvec3 groups(1);
  const kernels::Kernel& kernel = shader_->kernels[static_cast<std::size_t>(entry.kernel)];
  for (std::size_t i = 0; i < entry.threads.size(); ++i) {
    const PlannedNumber& part = entry.threads[i];
    const double threads = part.expression ? part.expression->at(all) : part.number;
    groups[static_cast<int>(i)] =
        threads > 0
            ? static_cast<unsigned>(std::ceil(std::min(std::ceil(threads), 4e9) / kernel.threads[i]))
            : 0U;
  }
  return groups;
}

}  // namespace simreel::sim
