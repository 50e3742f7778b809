#include "sim/cloth/coloring.hpp"

#include "base/log.hpp"
#include "sim/grid/color_choice.hpp"

namespace simreel::sim {

struct ClothColorKernel {
  static constexpr auto file = "cloth/color.comp";
  struct Variant {
    gl::Switch<"SPEED"> speed;
    gl::Switch<"MESH"> mesh;
  };
  gl::Uniform<"count", int> count;
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"perSpacing", float> perSpacing;
  gl::Uniform<"perDt", float> perDt;
  gl::Uniform<"trendShare", float> trendShare;
  gl::Uniform<"stopCount", int> stopCount;
  gl::Uniform<"low", float> low;
  gl::Uniform<"perRange", float> perRange;
  gl::In<"positions"> positions;
  gl::In<"before"> before;
  gl::In<"velocities"> velocities;
  gl::In<"trends"> trends;
  gl::In<"vertices"> vertices;
  gl::In<"edges"> edges;
  gl::In<"stops"> stops;
  gl::Out<"colors"> colors;
};

void ClothColoring::describe(scene::Fields& f) {
  f.choice(
      "colorBy", by, {"material", "strain", "speed"},
      "The object's material, or a colour map of the strain or the speed of each vertex. The strain is "
      "the mean of length / rest length - 1 over the links to the neighbours: up to four along rows "
      "and columns of a grid, or the edges of a mesh. Texture and weave are then not drawn.");
  if (used() && f.version() > 1 && !f.given("colorFrom") && !f.given("colorTo")) autoEnds = {true, true};
  describeEnd(
      f, "colorFrom", range.x, autoEnds.low, "",
      "Strain or speed (m/s) at the start of the colour map; \"auto\": the lowest of the whole run.");
  describeEnd(
      f, "colorTo", range.y, autoEnds.high, "",
      "Strain or speed (m/s) at the end of the colour map; \"auto\": the highest of the whole run.");
  f.leftOut("colorFrom", "0, or \"auto\" in version 2");
  f.leftOut("colorTo", "1, or 0.1 of a strain, or \"auto\" in version 2");
  if (by == By::strain && !f.given("colorTo") && !autoEnds.high) range.y = 0.1F;
  colors = describeColors(f, "cloth");
  if (used() && range.x == range.y && !autoEnds.any())
    f.error("colorTo", "colorFrom and colorTo must differ");
  f.idleUnless(used(), "colorBy", {"colorFrom", "colorTo", "colors", "colorStops"},
               "\"colorBy\": \"strain\" or \"speed\"");
}

std::vector<MeasuredRange> ClothColoring::measuredRanges() {
  if (!used()) return {};
  return measuredRange("", "colorFrom", "colorTo", autoEnds, range.x, range.y);
}

scene::Material ClothColoring::materialOf(const scene::Object& object) {
  scene::Material material = object.material;
  material.color = glm::vec3(1);
  material.texture.clear();
  material.skin.reset();
  material.finish.color = {};
  return material;
}

ClothColors::ClothColors(const std::string& name, const ClothColoring& coloring, int count,
                         double substepSeconds)
    : coloring_(coloring),
      count_(count),
      perDt_(static_cast<float>(1 / substepSeconds)),
      colors_(name + " colours", count) {
  std::vector<glm::vec4> stops;
  for (const glm::vec3& color : coloring.colors) stops.emplace_back(color, 1);
  stops_ = gl::Vec4Array(name + " colour map", stops);
}

ClothColors::ClothColors(const std::string& name, const ClothColoring& coloring, glm::ivec2 size,
                         float spacing, double substepSeconds, bool fast)
    : ClothColors(name, coloring, size.x * size.y, substepSeconds) {
  size_ = size;
  perSpacing_ = 1 / spacing;
  kernel_ = gl::Kernel<ClothColorKernel>(gl::kernelDefines(fast),
                                         {.speed = coloring.by == ClothColoring::By::speed, .mesh = false});
}

ClothColors::ClothColors(const std::string& name, const ClothColoring& coloring, const ClothEdges& edges,
                         double substepSeconds, bool fast)
    : ClothColors(name, coloring, static_cast<int>(edges.vertices.size()), substepSeconds) {
  vertices_ = gl::WordsArray(name + " edges of vertices", edges.vertices);
  edges_ = gl::WordsArray(name + " edges", edges.edges);
  kernel_ = gl::Kernel<ClothColorKernel>(gl::kernelDefines(fast),
                                         {.speed = coloring.by == ClothColoring::By::speed, .mesh = true});
}

void ClothColors::update(const State& state) const {
  kernel_.dispatch(count_, {.count = count_,
                            .size = size_,
                            .perSpacing = perSpacing_,
                            .perDt = perDt_,
                            .trendShare = state.trends != nullptr ? 0.5F : 0.0F,
                            .stopCount = static_cast<int>(coloring_.colors.size()),
                            .low = coloring_.range.x,
                            .perRange = 1 / (coloring_.range.y - coloring_.range.x),
                            .positions = *state.positions,
                            .before = *state.before,
                            .velocities = *state.velocities,
                            .trends = state.trends != nullptr ? *state.trends : *state.velocities,
                            .vertices = vertices_,
                            .edges = edges_,
                            .stops = stops_,
                            .colors = colors_});
  gl::barrier();
}

void ClothColors::applyTo(Surface& surface) const {
  surface.colors = &colors_.view();
  surface.stops = &coloring_.colors;
  surface.colorRange = coloring_.range;
}

}  // namespace simreel::sim
