#include "sim/kernels/image.hpp"

#include "kernels/source/files.hpp"
#include "scene/json/words.hpp"
#include "scene/value/asset_path.hpp"
#include "sim/kernels/kernels.hpp"
#include "sim/kernels/parameters.hpp"
#include "sim/kernels/plan.hpp"
#include "sim/ports/field_source.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Input channel of a pass: an image file, or the output of another pass.
struct ImageChannel {
  std::string name;  ///< number of the channel, "0" to "3"
  std::filesystem::path file;
  std::string buffer, field;
  KernelMemory::Filter filter = KernelMemory::Filter::linear;
  KernelMemory::Wrap wrap = KernelMemory::Wrap::clamp;
};

/// Pass of a ShaderToy program.
struct ImagePass {
  std::string name;  ///< name of the pass: "A" to "D", or "Image"
  std::filesystem::path file;
  std::vector<ImageChannel> channels;

  void describe(scene::Fields& f) {
    f.asset("file", file, "Shader with mainImage(out vec4, in vec2), as ShaderToy has it.");
    f.shorthand("channels", "file");
    f.named(
        "channels", channels, "What iChannel0 to iChannel3 read, by number.", "channel",
        [](scene::Fields& c, ImageChannel& channel) {
          c.asset("file", channel.file, "Picture.");
          c.text("buffer", channel.buffer,
                 "Name of a buffer: what it wrote last; of itself, in the step before.");
          c.text("field", channel.field,
                 "Field of another object at the beginning of the frame: OBJECT or OBJECT.PART.");
          c.choice("filter", channel.filter, {"shader", "point", "linear"}, "Reads between texels.");
          c.choice("wrap", channel.wrap, {"shader", "repeat", "clamp", "mirror"},
                   "Reads beyond the edges.");
        },
        4);
  }
};

/// Parameters of the object kind "image": passes with mainImage() that compute a picture.
struct ImageParameters : KernelsParameters {
  glm::ivec2 pixels{960, 540};
  ImagePass image;
  std::vector<ImagePass> passes;
  scene::Formula mouse;
  FieldDisplay display;

  void describe(scene::Fields& f) override {
    image.name = "Image";
    image.describe(f);
    f.pair("size", pixels, {1, 16384}, "pixels",
           "Width and height; as large as the picture where it fills that.");
    f.named(
        "buffers", passes, "Passes that run before the image, in this order: A to D.", "buffer",
        [](scene::Fields& p, ImagePass& pass) { pass.describe(p); }, 8);
    f.formula("mouse", mouse, "pixels", "iMouse: two or four numbers, which may move.");
    if (const std::size_t count = mouse.components(); count != 0 && count != 2 && count != 4)
      f.error("mouse", fmt::format("iMouse is two or four numbers, found {}", count));
    f.group("display", "Placement over the picture.", [&](scene::Fields& d) { display.describe(d); });
    if (!image.file.empty() && f.given("file")) build(f);
  }
  void ports(Ports& ports) const override {
    ports.provide<FieldSource>();
    for (const ImagePass& pass : passes) wantFields(ports, pass, {"buffers", pass.name});
    wantFields(ports, image, {});
  }
  [[nodiscard]] const char* drawnWith() const override { return "its \"display\""; }
  void leaveRoom(glm::vec2 room) override { display.room = room; }
  [[nodiscard]] Extent covering() const override { return display.covering(); }
  /// An image computes its colours, so it has no colour range.
  [[nodiscard]] std::vector<MeasuredRange> measuredRanges() override { return {}; }

 private:
  void build(scene::Fields& f);
  static void wantFields(Ports& ports, const ImagePass& pass, const std::vector<std::string>& path);
  void addPass(scene::Fields& f, const ImagePass& pass);
  void checkChannelCount(scene::Fields& f, const kernels::Shader& shader,
                         const std::vector<ImagePass>& all);
  std::map<std::string, std::string> aliases_;
};

KernelMemory textureOf(const std::string& name, glm::ivec2 size) {
  KernelMemory texture;
  texture.name = name;
  texture.size.parts = {{1.0 * size.x}, {1.0 * size.y}};
  texture.format = "rgba32f";
  return texture;
}

scene::Formula formulaOf(std::initializer_list<scene::Formula::Part> parts) {
  scene::Formula formula;
  formula.parts = parts;
  return formula;
}

void ImageParameters::wantFields(Ports& ports, const ImagePass& pass,
                                 const std::vector<std::string>& path) {
  for (const ImageChannel& channel : pass.channels) {
    if (channel.field.empty()) continue;
    std::vector<std::string> whole = path;
    whole.insert(whole.end(), {"channels", channel.name, "field"});
    ports.requireFrom<FieldSource>(channel.field, std::move(whole), When::frameStart);
  }
}

void ImageParameters::addPass(scene::Fields& f, const ImagePass& pass) {
  const bool last = pass.name == "Image";
  textures.push_back(textureOf(pass.name, pixels));
  if (!last) textures.push_back(textureOf(pass.name + "_Next", pixels));
  aliases_[pass.name + "_Output"] = last ? pass.name : pass.name + "_Next";
  scene::Formula resolutions;
  resolutions.parts.resize(12);
  for (const ImageChannel& channel : pass.channels) {
    std::vector<std::string> path = {"channels", channel.name};
    if (!last) path.insert(path.begin(), {"buffers", pass.name});
    if (channel.name.size() != 1 || channel.name[0] < '0' || channel.name[0] > '3') {
      f.errorIn(path, 0, 1, "channels are called \"0\" to \"3\"");
      continue;
    }
    const std::string reads = fmt::format("{}_Channel{}", pass.name, channel.name);
    std::string memory = fmt::format("{}_Picture{}", pass.name, channel.name);
    const auto known = [&](const ImagePass& other) { return other.name == channel.buffer; };
    if (!channel.buffer.empty() && std::none_of(passes.begin(), passes.end(), known)) {
      std::vector<std::string> names;
      for (const ImagePass& other : passes) names.push_back(other.name);
      f.errorIn(path, 0, 1,
                fmt::format("no buffer is called {}; {}", scene::inQuotes(channel.buffer),
                            names.empty() ? "there is none" : scene::suggestion(channel.buffer, names)));
      continue;
    }
    if ((channel.buffer.empty() ? 0 : 1) + (channel.file.empty() ? 0 : 1) +
            (channel.field.empty() ? 0 : 1) !=
        1) {
      f.errorIn(path, 0, 1, "a channel reads a \"file\", a \"buffer\" or a \"field\"");
      continue;
    }
    if (channel.buffer.empty()) {
      KernelMemory& picture = textures.emplace_back(textureOf(memory, pixels));
      if (channel.field.empty()) picture.size = {};
      picture.file = channel.file;
      picture.field = channel.field;
      picture.upward = true;
      picture.filter = channel.filter;
      picture.wrap = channel.wrap;
    } else {
      memory = channel.buffer;
      for (KernelMemory& texture : textures)
        if (texture.name == memory || texture.name == memory + "_Next") {
          texture.filter = channel.filter;
          texture.wrap = channel.wrap;
        }
    }
    aliases_[reads] = memory;
    const auto place = std::size_t{3} * static_cast<std::size_t>(channel.name[0] - '0');
    resolutions.parts[place] = {0, fmt::format("width({})", memory)};
    resolutions.parts[place + 1] = {0, fmt::format("height({})", memory)};
    resolutions.parts[place + 2] = {1};
  }
  constants.list.push_back({pass.name + "_ChannelResolution", resolutions});
  KernelEntry entry;
  entry.kernel = pass.name;
  entry.threads = formulaOf({{1.0 * pixels.x}, {1.0 * pixels.y}});
  if (!last) entry.swap = formulaOf({{0, pass.name}, {0, pass.name + "_Next"}});
  step.push_back(entry);
}

/// Reports channels that a shader reads but the scene does not define. Removes constants that no pass uses.
void ImageParameters::checkChannelCount(scene::Fields& f, const kernels::Shader& shader,
                                        const std::vector<ImagePass>& all) {
  std::vector<std::string> read;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const kernels::Texture& texture : shader.kernels[i].textures) {
      const std::size_t at = texture.name.find("_Channel");
      if (at == std::string::npos || aliases_.contains(texture.name)) continue;
      std::vector<std::string> path = {"channels"};
      if (all[i].name != "Image") path = {"buffers", all[i].name};
      const std::string number = texture.name.substr(at + 8);
      f.errorIn(path, 0, 1,
                fmt::format("{} reads iChannel{}; give \"channels\": {{\"{}\": ...}}",
                            all[i].file.filename().string(), number, number));
    }
    for (const kernels::Block& block : shader.kernels[i].blocks)
      for (const kernels::Member& member : block.members) read.push_back(member.name);
  }
  std::erase_if(constants.list, [&](const scene::Formulas::Named& one) {
    return std::find(read.begin(), read.end(), one.name) == read.end();
  });
  const auto used = [&](const std::string& name) {
    return std::any_of(shader.kernels.begin(), shader.kernels.end(), [&](const kernels::Kernel& kernel) {
      return std::any_of(kernel.textures.begin(), kernel.textures.end(),
                         [&](const kernels::Texture& texture) {
                           const auto alias = aliases_.find(texture.name);
                           return alias != aliases_.end() && alias->second == name;
                         });
    });
  };
  std::erase_if(textures, [&](const KernelMemory& texture) {
    return !used(texture.name) && texture.name.find("_Next") == std::string::npos;
  });
}

void ImageParameters::build(scene::Fields& f) {
  textures.clear();
  step.clear();
  constants = {};
  aliases_.clear();
  plan.reset();
  problem.clear();
  KernelsParameters::file = image.file;
  std::vector<ImagePass> all = passes;
  all.push_back(image);
  for (const ImagePass& pass : all) addPass(f, pass);
  // The image passes run once before the first step, so that the first frame has an image.
  first = step;
  const auto constant = [&](const char* name, const scene::Formula& value) {
    constants.list.push_back({name, value});
  };
  constant("iResolution", formulaOf({{1.0 * pixels.x}, {1.0 * pixels.y}, {1}}));
  constant("iTime", formulaOf({{0, "time"}}));
  constant("iTimeDelta", formulaOf({{0, "dt"}}));
  constant("iFrameRate", formulaOf({{0, "1 / dt"}}));
  constant("iFrame", formulaOf({{0, "frame"}}));
  constant("iDate", formulaOf({{2026}, {0}, {1}, {0, "time"}}));
  constant("iSampleRate", formulaOf({{44100}}));
  constant("iChannelTime", formulaOf({{0, "time"}}));
  scene::Formula held = mouse.empty() ? formulaOf({{0}, {0}, {0}, {0}}) : mouse;
  if (held.moving)
    held.width = 4;
  else
    held.parts.resize(4);
  constant("iMouse", held);
  KernelField& shown = field.emplace();
  shown.of = "Image";
  shown.encoded = true;
  shown.display = display;
  auto shader = std::make_shared<kernels::Shader>();
  requests.clear();
  std::vector<std::string> names;
  try {
    for (const ImagePass& pass : all) {
      if (pass.file.empty())
        return f.errorIn({"buffers", pass.name}, 0, 1, "a buffer needs \"file\", its shader");
      kernels::Request& one = requests.emplace_back();
      one.file = pass.file;
      for (const auto& folder : scene::foldersAround(pass.file)) one.folders.push_back(folder);
      one.pass = pass.name;
      one.upsideDown = pass.name == "Image";
      one.report = true;
      one.maxIterations = static_cast<unsigned>(iterations);
      const auto made = KernelPlan::shaderOf(one);
      shader->kernels.push_back(made->kernels.front());
      shader->files.insert(shader->files.end(), made->files.begin(), made->files.end());
      names.push_back(pass.name);
    }
    checkChannelCount(f, *shader, all);
    makePlan(f, std::move(shader), names, aliases_);
  } catch (const UserError& error) {
    keepProblem(error);
  }
}

}  // namespace

SimulationKind imageKind() {
  return kindOf<ImageParameters>("image",
                                 "A picture that a shader computes pixel by pixel, as on ShaderToy.",
                                 checkKernels, makeKernels);
}

}  // namespace simreel::sim
