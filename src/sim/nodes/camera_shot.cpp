#include "sim/nodes/camera_shot.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/packed.hpp"
#include "scene/json/words.hpp"
#include "sim/mesh/file/builder.hpp"
#include "sim/mesh/file/mesh_file.hpp"
#include "sim/nodes/gltf_nodes.hpp"
#include "sim/nodes/sample.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

/// Camera as stored in a file.
struct FileCamera {
  std::string name;  ///< name of the camera itself, which may differ from the name of its node
  int node = 0;
  bool perspective = true;
  double fieldOfView = 0;    ///< vertical field of view in radians
  double height = 0;         ///< height of an orthographic camera's view in metres
  double near = 0, far = 0;  ///< distances of the near and far planes in metres; far = 0 stands for
                             ///< infinity

  template <class Archive>
  void pack(Archive& archive) {
    archive(name);
    archive(node);
    archive(perspective);
    archive(fieldOfView);
    archive(height);
    archive(near);
    archive(far);
  }
};

struct CameraNodes {
  std::vector<FigureNode> nodes;
  std::vector<FigureAnimation> animations;
  std::vector<FileCamera> cameras;

  template <class Archive>
  void pack(Archive& archive) {
    archive(nodes);
    archive(animations);
    archive(cameras);
  }
};

FileCamera fileCameraOf(const GltfDocument& document, std::uint64_t number, int node) {
  const JsonValue described = document.item("cameras", number);
  FileCamera camera;
  if (described.has("name")) camera.name = described.at("name").text();
  camera.node = node;
  const std::string type = described.at("type").text();
  if (type != "perspective" && type != "orthographic")
    throw JsonError(fmt::format("a camera of type \"{}\"", type));
  camera.perspective = type == "perspective";
  const JsonValue lens = described.at(camera.perspective ? "perspective" : "orthographic");
  if (camera.perspective)
    camera.fieldOfView = lens.at("yfov").number();
  else
    camera.height = 2 * std::abs(lens.at("ymag").number());
  camera.near = lens.at("znear").number();
  if (lens.has("zfar")) camera.far = lens.at("zfar").number();
  return camera;
}

CameraNodes readCameraNodes(const std::filesystem::path& file, std::string_view text) {
  try {
    const GltfDocument document(file, text);
    GltfNodes nodes(document);
    CameraNodes read;
    nodes.walk([&](const JsonValue& node, std::uint64_t /*number*/, int here) {
      if (node.has("camera"))
        read.cameras.push_back(fileCameraOf(document, GltfDocument::number(node, "camera"), here));
    });
    read.nodes = nodes.nodes();
    read.animations = nodes.animations();
    return read;
  } catch (const JsonError& error) {
    refuseMesh(file, fmt::format("is not valid glTF: {}", error.what()));
  }
}

class FileShot final : public scene::CameraShot {
 public:
  FileShot(const scene::CameraFile& wanted, CameraNodes read)
      : speed_(wanted.speed), start_(wanted.start), loop_(wanted.loop) {
    const FileCamera& camera = chosen(read, wanted.name);
    name_ = read.nodes[static_cast<std::size_t>(camera.node)].name;
    constexpr double minimum = 1, maximum = 170;
    angle_ = camera.fieldOfView * (180 / std::numbers::pi);
    if (!camera.perspective) {
      height_ = camera.height;
      if (!(*height_ >= scene::positive.min && *height_ < scene::positive.max))
        fail(ExitCode::usage, "camera \"{}\" of the file has a view {:g} m high, which cannot be drawn",
             name_, *height_);
    } else if (!(angle_ >= minimum && angle_ <= maximum))
      fail(ExitCode::usage,
           "camera \"{}\" of the file has a field of view of {:.4g} degrees; it must be {} to {}", name_,
           angle_, minimum, maximum);
    near_ = camera.near;
    // The near plane of an orthographic camera may be at the eye. The minimum distance makes no visible
    // difference.
    if (!camera.perspective) near_ = std::max(near_, 1e-4);
    if (camera.far > 0) far_ = camera.far;
    if (!(near_ >= scene::positive.min && near_ < scene::positive.max))
      fail(ExitCode::usage, "camera \"{}\" of the file has its near plane at {:g} m, which cannot be drawn",
           name_, near_);
    for (int node = camera.node; node >= 0; node = read.nodes[static_cast<std::size_t>(node)].parent) {
      Link& link = links_.emplace_back();
      link.number = node;
      link.node = read.nodes[static_cast<std::size_t>(node)];
    }
    takeMotion(read, wanted.animation);
  }

  [[nodiscard]] scene::CameraPose at(double seconds) const override {
    const double moved = motionTime(seconds);
    glm::dmat4 world(1);
    for (const Link& link : links_) world = matrixOf(link, moved) * world;
    scene::CameraPose pose;
    pose.eye = glm::dvec3(world[3]);
    const auto unit = [&](const glm::dvec3& v) {
      const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
      if (!(length > 1e-12 && length < 1e12))
        fail(ExitCode::usage,
             "camera \"{}\" of the file has no direction at {:g} s: the scale of a node is close to 0 or "
             "too large",
             name_, seconds);
      return v / length;
    };
    pose.back = unit(glm::dvec3(world[2]));
    const glm::dvec3 up(world[1]);
    pose.up = unit(up - pose.back * glm::dot(up, pose.back));
    pose.right = glm::cross(pose.up, pose.back);
    if (!(std::abs(pose.eye.x) + std::abs(pose.eye.y) + std::abs(pose.eye.z) < 1e9))
      fail(ExitCode::usage, "camera \"{}\" of the file is farther than 1e9 m at {:g} s", name_, seconds);
    return pose;
  }
  [[nodiscard]] double fieldOfView() const override { return angle_; }
  [[nodiscard]] std::optional<double> height() const override { return height_; }
  [[nodiscard]] double near() const override { return near_; }
  [[nodiscard]] std::optional<double> far() const override { return far_; }

 private:
  /// Node of the camera or an ancestor of that node, with the animation channels of the node.
  struct Link {
    int number = 0;
    FigureNode node;
    std::vector<FigureChannel> channels;
  };

  static const FileCamera& chosen(const CameraNodes& read, const std::string& name) {
    const std::vector<FileCamera>& cameras = read.cameras;
    if (cameras.empty()) fail(ExitCode::usage, "the file has no camera in its default scene");
    std::vector<std::string> names;
    names.reserve(cameras.size());
    for (const FileCamera& camera : cameras)
      names.push_back(read.nodes[static_cast<std::size_t>(camera.node)].name);
    if (name.empty()) {
      if (cameras.size() == 1) return cameras.front();
      fail(ExitCode::usage, "the file has {} cameras; say which by its \"name\": {}", cameras.size(),
           fmt::join(names, ", "));
    }
    for (std::size_t i = 0; i < cameras.size(); ++i)
      if (names[i] == name) return cameras[i];
    for (const FileCamera& camera : cameras)
      if (camera.name == name) return camera;
    fail(ExitCode::usage, "the file has no camera {}; {}", scene::inQuotes(name),
         scene::suggestion(name, names));
  }

  void takeMotion(const CameraNodes& read, const std::string& name) {
    std::vector<std::string> names;
    for (const FigureAnimation& animation : read.animations) {
      names.push_back(animation.name);
      if (!name.empty() && animation.name != name) continue;
      bool moves = false;
      for (const FigureChannel& channel : animation.channels)
        for (Link& link : links_)
          if (link.number == channel.node) {
            link.channels.push_back(channel);
            moves = true;
          }
      length_ = animation.seconds;
      if (moves || !name.empty()) return;
    }
    if (name.empty()) return;
    fail(ExitCode::usage, "the file has no animation {}; {}", scene::inQuotes(name),
         names.empty() ? std::string("it has none") : scene::suggestion(name, names));
  }

  [[nodiscard]] double motionTime(double seconds) const {
    const double at = start_ + speed_ * seconds;
    if (!loop_ || !(length_ > 0)) return std::clamp(at, 0.0, length_);
    return at - std::floor(at / length_) * length_;
  }

  static glm::dmat4 matrixOf(const Link& link, double moved) {
    if (link.node.hasMatrix) return link.node.matrix;
    FigureNode node = link.node;
    for (const FigureChannel& channel : link.channels) move(node, channel, moved);
    return transformOf(node.translation, node.rotation, node.scale);
  }

  std::string name_;
  double speed_, start_;
  bool loop_;
  double angle_ = 0, near_ = 0, length_ = 0;
  std::optional<double> height_, far_;
  std::vector<Link> links_;  ///< chain of nodes, starting with the camera's node
};

}  // namespace

std::shared_ptr<const scene::CameraShot> readCamera(const scene::CameraFile& wanted,
                                                    std::string_view text) {
  return std::make_shared<const FileShot>(wanted, readCameraNodes(wanted.file, text));
}

std::shared_ptr<const scene::CameraShot> openCamera(const scene::CameraFile& wanted) {
  if (!isGltf(wanted.file))
    fail(ExitCode::usage, "{} is neither .gltf nor .glb; cameras need one of these formats",
         wanted.file.string());
  const std::string text = readFile(wanted.file, "camera");
  CameraNodes read = unpacked<CameraNodes>(readInSeparateProcess(wanted.file, [&] {
    auto made = readCameraNodes(wanted.file, text);
    return packed(std::move(made));
  }));
  return std::make_shared<const FileShot>(wanted, std::move(read));
}

}  // namespace simreel::sim
