#include "sim/kernels/parameters.hpp"

#include "base/error.hpp"
#include "kernels/kernels.hpp"
#include "scene/value/asset_path.hpp"
#include "sim/kernels/plan.hpp"
#include "sim/mesh/height_field.hpp"
#include "sim/ports/color_scale.hpp"
#include "sim/ports/field_source.hpp"
#include "sim/ports/landform.hpp"
#include "sim/ports/markers.hpp"
#include "sim/ports/measured.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

namespace simreel::sim {

namespace {

void describe(scene::Fields& f, KernelMemory& memory, bool texture) {
  f.formula("size", memory.size, "",
            texture
                ? "Texels along x, y and, of a volume or layers, z; or expressions of count(BUFFER) and "
                  "width(TEXTURE)."
                : "Elements, along x or x and y or x, y and z (x fastest); or expressions of "
                  "count(BUFFER) and width(TEXTURE).");
  f.leftOut("size", texture ? "the file's" : "the file's rows, or 1");
  f.formulas("start", memory.start,
             texture
                 ? "First values: one formula, or one for each channel, of x, y, z, i (the texel's place), "
                   "width, height, depth, random(k) and the columns of \"file\"."
                 : "First values by member of the struct, such as {\"position\": [\"x\", \"0\", \"y\"]}, "
                   "or of the element itself: formulas of i (its place), x, y, z, count, random(k) and "
                   "the columns of \"file\". What is left out is zero.");
  f.asset("file", memory.file,
          texture
              ? "Picture with the first values: linear red, green, blue, and opacity, as r, g, b, a."
              : "Table with first values: CSV (a column is called as its first line says), npy (c0, c1, "
                "...), or OBJ, PLY, glTF (vertices: x, y, z, nx, ny, nz, u, v).");
  if (texture) {
    f.text("field", memory.field,
           "Field of another object that a 2D texture takes: OBJECT, or OBJECT.PART such as \"smoke.u\".");
    f.choice("taken", memory.readTime, {"everyFrame", "start"},
             "Takes the field as it is at the beginning of each frame, or only at the start.");
    f.idleUnless(!memory.field.empty(), "field", {"taken"}, "a texture with a \"field\"");
    if (!memory.field.empty() && (f.given("file") || f.given("start")))
      f.error("field", "a texture has a \"field\", a \"file\" or a \"start\"");
    f.text("format", memory.format, "Format of a texel, such as \"rgba32f\" or \"r32ui\".");
    f.leftOut("format", "the shader's, or of 32 bits a channel");
    if (f.given("format") && memory.format.empty())
      f.error("format", "a format has a name, such as \"rgba32f\"");
    f.choice("filter", memory.filter, {"shader", "point", "linear"},
             "Reads between texels; \"shader\": as the sampler's name says (linear, point), else linear.");
    f.choice("wrap", memory.wrap, {"shader", "repeat", "clamp", "mirror"},
             "Reads beyond the edges; \"shader\": as the sampler's name says, else repeat.");
  } else {
    f.boolean("previous", memory.previous,
              "Kernels that read and write the buffer read it as it was before their dispatch, so no "
              "invocation sees "
              "what others write.");
    f.number("counter", memory.counter, {0, 4e9}, "",
             "First value of the counter of an append or consume buffer.");
  }
}

void describeEntry(scene::Fields& f, KernelEntry& entry) {
  f.text("kernel", entry.kernel, "Kernel to dispatch.");
  f.formula("threads", entry.threads, "",
            "Invocations along x, y, z: numbers or expressions of count(BUFFER), width(TEXTURE), ...");
  f.leftOut("threads", "one for each element or texel of the first memory that the kernel writes");
  f.integer("repeat", entry.repeat, {1, 1e6}, "", "Times in a row.");
  f.integer("every", entry.every, {1, 1e9}, "steps", "Runs in every n-th step, from the first one on.");
  f.text("indirect", entry.indirect, "Buffer that holds the numbers of work groups: three uints.");
  f.integer("offset", entry.offset, {0, 2e9}, "bytes", "Where they begin in that buffer, or in \"into\".");
  f.formula("swap", entry.swap, "",
            "Two buffers or textures that exchange their memory, after the kernel.");
  f.text("clear", entry.clear, "Buffer, counter (NAME.counter) or texture that becomes zero.");
  f.text("count", entry.count, "Append or consume buffer whose counter is copied to \"into\".");
  f.text("into", entry.into, "Buffer that gets a counter, at \"offset\".");
}

}  // namespace

void KernelsParameters::describe(scene::Fields& f) {
  f.asset("file", file, "Shader file: Unity's .compute, HLSL, or GLSL.");
  f.formula("keywords", keywords, "", "Keywords of multi_compile that hold.");
  f.boolean("fast", fast, "Runs the shader with the driver's own arithmetic, as it is written.");
  describeMemory(f);
  f.formulas(
      "constants", constants,
      "Values of the shader's constants: numbers, lists of them, keyframes, or expressions of dt, time, "
      "frame, steps, seed, count(BUFFER), width(TEXTURE), height(TEXTURE), depth(TEXTURE), and "
      "quantity(OBJECT.QUANTITY), a quantity of another object at the beginning of the frame. An array "
      "takes all its numbers, or the formulas of one element, in which i counts the elements from 0.");
  f.shorthand("constantFiles", "file");
  f.named(
      "constantFiles", constantFiles, "Files with the numbers of constants.", "constant",
      [](scene::Fields& c, KernelConstantFile& one) {
        c.asset("file", one.file,
                "Table with a row for each element of the array: CSV, npy (columns c0, c1, ...), a mesh or "
                "a picture. Formulas of the constant know the columns; without any, it takes them in their "
                "order. count(CONSTANT) is the number of rows.");
      },
      64);
  f.integer("steps", steps, {0, 100000}, "per frame", "Steps a frame takes; dt is their length.");
  f.shorthand("first", "kernel");
  f.list("first", first, "What runs once, before the first frame.",
         [](scene::Fields& e, KernelEntry& entry) { describeEntry(e, entry); });
  f.shorthand("step", "kernel");
  f.list("step", step, "What runs in each step, in this order.",
         [](scene::Fields& e, KernelEntry& entry) { describeEntry(e, entry); });
  f.leftOut("step", "all kernels of the file in its order");
  f.choice("bounds", bounds, {"stop", "ignore", "silent"},
           "Reads and writes out of bounds give zero and do nothing: the run stops there, or tells it once "
           "and goes on. "
           "\"silent\": kernels have no code that notes them, nor endless loops, and are faster.");
  if (f.version() > 1 && !f.given("nonFinite")) nonFinite = NonFinite::stop;
  if (f.version() > 1) defaultFit = FieldDisplay::Fit::contain;
  f.choice(
      "nonFinite", nonFinite, {"stop", "warn", "ignore"},
      "What is drawn, or blows as wind, is NaN or infinite: the run stops with exit code 4, or tells it "
      "once and goes on, or does not test it.");
  f.leftOut("nonFinite", "warn; in version 2 stop");
  f.integer("iterations", iterations, {0, 2e9}, "",
            "Most iterations of a loop, which then ends and stops the run; 0: no limit. Software drivers "
            "(llvmpipe) "
            "count up to 65,535.");
  describeDrawn(f);
  quantityList.clear();
  for (const KernelMeasure& measure : measured)
    quantityList.push_back({measure.name.c_str(), "", "As the scene says."});
  if (f.given("file")) compile(f);
}

void KernelsParameters::describeMemory(scene::Fields& f) {
  f.shorthand("buffers", "size");
  f.named(
      "buffers", buffers, "Buffers of the shader.", "buffer",
      [](scene::Fields& b, KernelMemory& buffer) { sim::describe(b, buffer, false); }, 64);
  f.shorthand("textures", "size");
  f.named(
      "textures", textures, "Textures and images of the shader.", "texture",
      [](scene::Fields& t, KernelMemory& texture) { sim::describe(t, texture, true); }, 64);
}

void KernelsParameters::compile(scene::Fields& f) {
  plan.reset();
  problem.clear();
  requests.clear();
  kernels::Request& request = requests.emplace_back();
  request.file = file;
  request.fast = fast;
  request.report = bounds != Bounds::silent;
  request.maxIterations = bounds == Bounds::silent ? 0 : static_cast<unsigned>(iterations);
  for (const auto& folder : scene::foldersAround(file)) request.folders.push_back(folder);
  for (const KernelMemory& buffer : buffers)
    if (buffer.previous) request.previous.push_back(buffer.name);
  for (const scene::Formula::Part& part : keywords.parts) request.keywords.push_back(part.text);
  try {
    const std::vector<std::string> known = kernels::kernelNames(request);
    if (!step.empty())
      for (const auto* entries : {&first, &step})
        for (const KernelEntry& entry : *entries)
          if (std::find(known.begin(), known.end(), entry.kernel) != known.end() &&
              std::find(request.kernels.begin(), request.kernels.end(), entry.kernel) ==
                  request.kernels.end())
            request.kernels.push_back(entry.kernel);
    makePlan(f, KernelPlan::shaderOf(request), known);
  } catch (const UserError& error) {
    keepProblem(error);
  }
}

void KernelsParameters::makePlan(scene::Fields& f, std::shared_ptr<const kernels::Shader> shader,
                                 const std::vector<std::string>& announced,
                                 const std::map<std::string, std::string>& aliases) {
  auto made = std::make_shared<KernelPlan>(*this, std::move(shader), announced, aliases);
  for (const KernelPlan::Mistake& mistake : made->mistakes())
    f.errorIn(mistake.path, mistake.begin, mistake.end, mistake.message);
  // The field that is shown by default becomes part of the description, which `explain` prints.
  if (!field && made->drawn().field) field = made->drawn().field;
  plan = std::move(made);
}

std::vector<MeasuredRange> KernelsParameters::measuredRanges() {
  std::vector<MeasuredRange> all;
  const auto add = [&](std::vector<MeasuredRange> ranges) {
    for (MeasuredRange& range : ranges) {
      // The drawing belongs to the plan, which also holds a copy of the range.
      range.set = [this, own = std::move(range.set)](double low, double high) {
        own(low, high);
        auto changed = std::make_shared<KernelPlan>(*plan);
        changed->setColorRanges(*this);
        plan = std::move(changed);
      };
      all.push_back(std::move(range));
    }
  };
  if (plan == nullptr) return all;
  if (field && plan->drawn().field) add(field->display.measuredRanges("field.display"));
  if (points && plan->drawn().points && points->colorBy != Instances::ColorBy::material)
    add(measuredRange("points", "colorFrom", "colorTo", points->autoColors, points->colorRange.x,
                      points->colorRange.y));
  return all;
}

std::vector<std::filesystem::path> KernelsParameters::shaderFiles() const {
  static std::map<std::filesystem::path, std::vector<std::filesystem::path>> last;
  static std::mutex mutex;
  const std::scoped_lock lock(mutex);
  std::vector<std::filesystem::path>& files = last[file];
  if (plan != nullptr) files.assign(plan->shader().files.begin(), plan->shader().files.end());
  return files;
}

void KernelsParameters::keepProblem(const UserError& error) {
  problem = error.what();
  problemIsReport = error.form() == UserError::Form::report;
}

void KernelsParameters::ports(Ports& ports) const {
  const bool drawsField = plan != nullptr && plan->drawn().field;
  if (drawsField) ports.provide<FieldSource>();
  const bool coloredPoints =
      plan != nullptr && plan->drawn().points && points && points->colorBy != Instances::ColorBy::material;
  ports.provide<ColorScale>(drawsField || coloredPoints,
                            " without a \"field\" or \"points\" with \"colorBy\"");
  for (const KernelMemory& texture : textures)
    if (!texture.field.empty())
      ports.requireFrom<FieldSource>(texture.field, {"textures", texture.name, "field"}, When::frameStart);
  if (plan != nullptr)
    for (const KernelPlan::Quantity& quantity : plan->quantities())
      ports.requireFrom<Measured>(quantity.name, quantity.path, When::frameStart);
  ports.provide<Landform>(plan != nullptr && (plan->drawn().terrain || plan->drawn().surface),
                          " without a \"terrain\" or a \"surface\"");
  ports.provide<FluidWind>(wind.has_value(), " without \"wind\"");
  const bool collides = terrain && terrain->collides;
  ports.provide<Touchable>(collides);
  ports.provide<HeightField>(collides, " without a \"terrain\" that \"collides\"").path = {"terrain",
                                                                                           "collides"};
}

const char* KernelsParameters::drawnWith() const {
  const bool onlyField = plan != nullptr && plan->drawn().field && !plan->drawn().inSpace();
  return onlyField ? "its \"field\"" : nullptr;
}

scene::Covering::Extent KernelsParameters::covering() const {
  if (plan == nullptr || !plan->drawn().field || !field) return Extent::none;
  const Extent extent = field->display.covering();
  return extent == Extent::whole ? Extent::part : extent;
}

std::optional<scene::Box> KernelsParameters::framed() const {
  return plan == nullptr ? std::nullopt : plan->box();
}

scene::Parameters::Looks KernelsParameters::looks() const {
  if (plan == nullptr) return Looks::solid;
  if (plan->drawn().points && plan->drawn().points->additive) return Looks::shining;
  return plan->drawn().surface ? Looks::cloth : Looks::solid;
}

bool KernelsParameters::motionIsUnpredictable() const {
  return plan != nullptr && (plan->drawn().surface || plan->drawn().points || plan->drawn().terrain);
}

}  // namespace simreel::sim
