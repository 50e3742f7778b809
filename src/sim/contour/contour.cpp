#include "sim/contour/contour.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "sim/contour/parameters.hpp"
#include "sim/contour/solid.hpp"
#include "sim/contour/walls.hpp"
#include "sim/grid/picture_file.hpp"
#include "sim/ports/color_scale.hpp"
#include "sim/ports/field_source.hpp"

#include <cstring>

#include <glm/gtc/matrix_transform.hpp>

namespace simreel::sim {

namespace {

/// Returns the palette with five shades per class. A face beside a wall that rises from it is darkened,
/// because it is in the wall's shadow.
std::vector<glm::vec4> contourPalette(const std::vector<glm::vec3>& classes) {
  std::vector<glm::vec4> colors;
  for (const glm::vec3& color : classes)
    for (const float shade : {1.0F, 0.6F, 1.15F, 0.45F, 0.85F}) colors.emplace_back(color * shade, 1);
  return colors;
}

/// Image that is used as a field of floats between 0 and 1.
class ImageField {
 public:
  ImageField(const std::string& name, const std::filesystem::path& file) {
    const Picture picture = loadPicture(file, "image", maxSolidImageSide);
    std::vector<glm::vec4> four(
        (static_cast<std::size_t>(picture.size.x) * static_cast<std::size_t>(picture.size.y) + 3) / 4);
    std::size_t i = 0;
    for (int y = 0; y < picture.size.y; ++y)
      for (int x = 0; x < picture.size.x; ++x, ++i)
        four[i / 4][static_cast<int>(i % 4)] = static_cast<float>(picture.level(x, y)) / 255.0F;
    values_ = gl::Buffer::of<glm::vec4>(name + " picture", four);
    words_ = gl::Texture::view(name + " picture", GL_RGBA32UI, values_);
    field_.size = picture.size;
    field_.rowWords = picture.size.x;
  }
  [[nodiscard]] Field field() const {
    Field field = field_;
    field.words = &words_;
    return field;
  }

 private:
  gl::Buffer values_;
  gl::Texture words_;
  Field field_;
};

class Contour final : public Simulation, public HasColorScale {
 public:
  Contour(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        material_(object.material),
        parameters_(parametersOf<ContourParameters>(object)),
        frameSeconds_(setting.frameSeconds),
        links_(setting.links),
        palette_(name_ + " colours", contourPalette(parameters_.colors())) {
    if (!parameters_.image.empty()) image_.emplace(name_, parameters_.image);
    solid_.emplace(name_, parameters_.shape(source(), setting.startTime));
    walls_.emplace(name_, *solid_, parameters_.position, parameters_.grip);
    make(setting.startTime);
  }

  void step(double time, const StepWatch& watch) override {
    make(time + frameSeconds_);
    if (watch) watch(1);
  }
  void pass(double time) override {
    if (met_) make(time + frameSeconds_);
  }
  void resumed(double time) override { make(time); }
  bool grow() override { return solid_->grow(); }
  void connect(Outlets& outlets) override {
    outlets.provideBy<Walls>([this] {
      met_ = true;
      return &*walls_;
    });
  }

  void publish(double /*time*/, Drawables& drawables) const override {
    if (!parameters_.visible) return;
    Surface surface = solid_->surface();
    surface.model = glm::translate(glm::mat4(1), parameters_.position);
    surface.palette = &palette_.view();
    surface.material = &material_;
    drawables.surfaces.push_back(surface);
  }
  [[nodiscard]] std::vector<StateArray> state() const override {
    return {{"tallies", &solid_->tallies(), true}};
  }
  [[nodiscard]] std::optional<MeshTable> mesh() const override {
    MeshTable table = solid_->unwrapped();
    for (glm::vec3& position : table.positions) position += parameters_.position;
    return table;
  }
  [[nodiscard]] ColorScale colorScale() const override {
    return {parameters_.colors(), parameters_.colorRange(source()), false, {}};
  }
  [[nodiscard]] std::optional<ContourLines> lines() const override { return solid_->lines(); }

 private:
  [[nodiscard]] Field source() const {
    return image_ ? image_->field() : fieldNamed(*links_, parameters_.field);
  }
  void make(double time) { solid_->make(source(), parameters_.heightsAt(time)); }

  std::string name_;
  scene::Material material_;
  ContourParameters parameters_;
  double frameSeconds_;
  const Links* links_;
  gl::Vec4Array palette_;
  std::optional<ImageField> image_;
  std::optional<Solid> solid_;
  std::optional<Walls> walls_;
  bool met_ = false;  ///< True if another object collides with the solid.
};

}  // namespace

SimulationKind contourKind() {
  return kindOf<ContourParameters>(
      "contour", "Contours of a field or a picture, standing up as terraces.",
      [](const scene::Object& object, const Setting& /*setting*/) {
        const auto& parameters = parametersOf<ContourParameters>(object);
        if (!parameters.image.empty())
          static_cast<void>(loadPicture(parameters.image, "image", maxSolidImageSide));
      },
      makeSimulation<Contour>);
}

}  // namespace simreel::sim
