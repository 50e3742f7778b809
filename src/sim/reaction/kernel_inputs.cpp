#include "base/error.hpp"
#include "sim/grid/field_part.hpp"
#include "sim/reaction/kernels.hpp"
#include "sim/reaction/rule/model.hpp"
#include "sim/reaction/sampling.hpp"

#include <algorithm>
#include <utility>

namespace simreel::sim {

struct ReactionPaint {
  static constexpr auto file = "reaction/paint.comp";
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"columns", int> columns;
  gl::Uniform<"plane", int> plane;
  StrokeUniforms stroke;
  gl::InOut<"cells"> cells;
  gl::In<"stamps"> stamps;
};

struct BrushKernel {
  static constexpr auto file = "reaction/brush.comp";
  struct Variant {
    gl::Flag<"MESH"> mesh;
  };
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"boxRows", glm::ivec4> boxRows;
  gl::Uniform<"columns", int> columns;
  gl::Uniform<"depth", int> depth;
  gl::Uniform<"plane", int> plane;
  gl::Uniform<"places", int> places;
  StrokeMembers stroke;
  gl::Uniform<"brush.from", glm::vec3> from;
  gl::Uniform<"brush.to", glm::vec3> to;
  gl::Uniform<"brush.radius2", float> radius2;
  gl::Uniform<"brush.perLength2", float> perLength2;
  gl::InOut<"cells"> cells;
  gl::In<"maps"> maps;
};

struct SampleKernel {
  static constexpr auto file = "reaction/sample.comp";
  struct Variant {
    FieldCells cells;
    gl::Flag<"LAYERS"> layers;
    gl::Flag<"MESH"> mesh;
  };
  FieldPart field;
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"columns", int> columns;
  gl::Uniform<"depth", int> depth;
  gl::Uniform<"plane", int> plane;
  gl::Uniform<"fieldLayers", int> fieldLayers;
  gl::Uniform<"storedGrain", float> storedGrain;
  gl::Uniform<"byCell", int> byCell;
  gl::In<"places"> places;
  gl::InOut<"maps"> maps;
};

namespace {

/// Packs the positions in the format of glsl/reaction/sample.comp.
std::vector<glm::uvec4> placeWords(const std::vector<glm::ivec2>& places) {
  std::vector<glm::uvec4> words((places.size() + 3) / 4, glm::uvec4(0));
  for (std::size_t i = 0; i < places.size(); ++i)
    words[i / 4][static_cast<int>(i % 4)] =
        static_cast<unsigned>(places[i].x) | static_cast<unsigned>(places[i].y) << 16;
  return words;
}

}  // namespace

void ReactionKernels::makeInputs(const std::string& name, const gl::Defines& defines) {
  const ReactionParameters& p = plan_.parameters();
  if (!plan_.places().empty() && p.readsFields())
    places_ = gl::WordsArray(name + " places", placeWords(plan_.places()));
  if (p.space() != RuleSpace::plane && !p.strokes.empty())
    brush_ = gl::Kernel<BrushKernel>(defines, {p.space() == RuleSpace::mesh});
  if (plan_.strokes().empty()) return;
  stamps_ = gl::WordsArray(name + " brush images", plan_.strokes().imageElements());
  paint_ = gl::Kernel<ReactionPaint>(defines);
}

const gl::Kernel<SampleKernel>& ReactionKernels::samplerOf(Field::Cells cells, bool layers) {
  const auto found = samplers_.find({cells, layers});
  if (found != samplers_.end()) return found->second;
  return samplers_
      .emplace(
          std::pair(cells, layers),
          gl::Kernel<SampleKernel>(gl::kernelDefines(false),
                                   {.cells = cells, .layers = layers, .mesh = plan_.links() != nullptr}))
      .first->second;
}

void ReactionKernels::setMap(int parameter, const Field& field, int layers) {
  if (std::max(field.size.x, field.size.y / layers) > maxSampledSide)
    fail(ExitCode::usage, "the field \"{}\" has {}x{} cells; as a parameter it may have up to {} across",
         *field.name, field.size.x, field.size.y, maxSampledSide);
  gl::barrier();
  samplerOf(field.cells, layers > 1)
      .dispatch({columns_, size_.y * (layers > 1 ? depth_ : 1)},
                {.field = partOf(field),
                 .size = size_,
                 .columns = columns_,
                 .depth = depth_,
                 .plane = parameter,
                 .fieldLayers = layers,
                 .storedGrain = storedGrain,
                 .byCell = field.size == size_ ? 1 : 0,  // Used only on meshes (MESH), where size_ is a
                                                         // single row of cells. A grid never has a single
                                                         // row, so a field of equal size belongs to the
                                                         // cells of the same mesh and is copied cell by
                                                         // cell.
                 .places = places_,
                 .maps = weights_});
}

void ReactionKernels::paint(const ReactionPlan::Painted& painted) {
  if (plan_.parameters().space() != RuleSpace::plane) return paintInSpace(painted);
  const glm::ivec4 box = Strokes::box(painted.stroke, size_);
  if (box.z == 0) return;
  paint_.dispatch({columns_, box.w}, {.size = size_,
                                      .columns = columns_,
                                      .plane = painted.species,
                                      .stroke = uniformsOf(painted.stroke, box),
                                      .cells = cells_[0],
                                      .stamps = stamps_});
}

void ReactionKernels::paintInSpace(const ReactionPlan::Painted& painted) {
  const Brush& brush = painted.brush;
  const bool mesh = plan_.links() != nullptr;
  const glm::ivec2 rows = mesh ? glm::ivec2(0, 1) : brushRange(brush, 1, size_.y);
  const glm::ivec2 layers = mesh ? glm::ivec2(0, 1) : brushRange(brush, 2, depth_);
  if (rows.y * layers.y == 0) return;
  brush_.dispatch({columns_, rows.y * layers.y},
                  {.size = size_,
                   .boxRows = glm::ivec4(rows, layers),
                   .columns = columns_,
                   .depth = depth_,
                   .plane = painted.species,
                   .places = static_cast<int>(plan_.parameters().parameters.size()),
                   .stroke = uniformsOf(painted.stroke),
                   .from = brush.from,
                   .to = brush.to,
                   .radius2 = brush.radius2,
                   .perLength2 = brush.perLength2,
                   .cells = cells_[0],
                   .maps = weights_});
}

}  // namespace simreel::sim
