// The module simreel._native: libsimreel for Python. The classes of the package simreel wrap it.
#include "dlpack.hpp"
#include "unlocked.hpp"

#include <chrono>
#include <cstring>
#include <memory>
#include <optional>
#include <pthread.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <simreel/simreel.hpp>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace {

using namespace simreel::python;

/// Returns the device of the process. close() destroys it. C++ destructors at the end of the process would
/// be too late, because the driver ends before them.
std::optional<simreel::Device>& device() {
  static auto* held = new std::optional<simreel::Device>();
  return *held;
}

py::dtype typeOf(simreel::NumberType type) {
  switch (type) {
    case simreel::NumberType::float64:
      return py::dtype::of<double>();
    case simreel::NumberType::int32:
      return py::dtype::of<std::int32_t>();
    case simreel::NumberType::uint32:
      return py::dtype::of<std::uint32_t>();
    case simreel::NumberType::uint8:
      return py::dtype::of<std::uint8_t>();
    case simreel::NumberType::float32:
      break;
  }
  return py::dtype::of<float>();
}

/// Returns the type of structures with these members, each `bytes` long; without members, that of a number.
py::dtype typeOf(simreel::NumberType type, const std::vector<simreel::Member>& members, std::size_t bytes) {
  if (members.empty()) return typeOf(type);
  py::list names, formats, offsets;
  for (const simreel::Member& member : members) {
    names.append(member.name);
    formats.append(py::make_tuple(typeOf(member.type), py::tuple(py::cast(member.shape))));
    offsets.append(member.offset);
  }
  return {names, formats, offsets, static_cast<py::ssize_t>(bytes)};
}

/// Hands bytes over to a numpy array without a copy. The array is read-only, because a change would reach
/// neither the device nor the next array.
template <class Bytes>
py::array handOver(const py::dtype& type, const std::vector<std::size_t>& shape,
                   const std::vector<std::size_t>& strides, Bytes&& bytes) {
  auto* owned = new std::decay_t<Bytes>(std::forward<Bytes>(bytes));
  const py::capsule owner(owned, [](void* data) { delete static_cast<std::decay_t<Bytes>*>(data); });
  py::array array(type, shape, strides, owned->data(), owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

py::array toNumpy(simreel::Array&& array) {
  const py::dtype type =
      typeOf(array.type, array.members, array.strides.empty() ? 0 : array.strides.back());
  return handOver(type, array.shape, array.strides, std::move(array.bytes));
}

py::array toNumpy(simreel::Picture&& picture) {
  const std::vector<std::size_t> shape = {static_cast<std::size_t>(picture.height),
                                          static_cast<std::size_t>(picture.width),
                                          static_cast<std::size_t>(picture.channels)};
  return handOver(typeOf(simreel::NumberType::uint8), shape, {shape[1] * shape[2], shape[2], 1},
                  std::move(picture.bytes));
}

/// Stops daemon threads when they enter or leave the library at the end of the interpreter, and waits until
/// no thread is inside.
void endCalls() {
  endsPython = true;
  ending = true;
  if (inside > 0 && device()) device()->interrupt();
  const py::gil_scoped_release release;
  while (inside > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// Runs in a waiting call: passes the library's messages on as warnings. Returns true if the running call
/// must end, because a signal handler raised, a warning is an error, or the interpreter ends.
bool signalled() {
  if (ending && !endsPython) return true;
  const py::gil_scoped_acquire acquire;
  if (PyErr_CheckSignals() != 0) return true;
  try {
    py::module_::import("simreel._messages").attr("report")();
  } catch (py::error_already_set& raised) {
    raised.restore();
    return true;
  }
  return false;
}

const char* nameOf(simreel::ErrorKind kind) {
  using Kind = simreel::ErrorKind;
  switch (kind) {
    case Kind::scene:
      return "scene";
    case Kind::usage:
      return "usage";
    case Kind::device:
      return "device";
    case Kind::different:
      return "different";
    case Kind::inputOutput:
      return "inputOutput";
    case Kind::process:
      return "process";
    case Kind::interrupted:
      return "interrupted";
    case Kind::internal:
      break;
  }
  return "internal";
}

/// Raises simreel.Error. If a signal handler interrupted the call, keeps its exception, or raises
/// KeyboardInterrupt if it raised none.
void raise(const simreel::Error& error) {
  if (error.kind() == simreel::ErrorKind::interrupted) {
    if (PyErr_Occurred() == nullptr) PyErr_SetNone(PyExc_KeyboardInterrupt);
    return;
  }
  py::list mistakes;
  for (const simreel::Mistake& one : error.mistakes())
    mistakes.append(py::make_tuple(one.file, one.line, one.column, one.path, one.message, one.suggestion));
  const py::object type = py::module_::import("simreel._errors").attr("Error");
  const py::object made = type(error.what(), nameOf(error.kind()), mistakes);
  PyErr_SetObject(type.ptr(), made.ptr());
}

/// Returns the options with which the device was last opened. Scenes that are loaded later use them.
simreel::DeviceOptions& chosen() {
  static simreel::DeviceOptions options;
  return options;
}

/// Opens a device. If no scene uses the current device, closes it first; otherwise `options` must equal the
/// current options.
simreel::Device& openDevice(const simreel::DeviceOptions& options) {
  unlocked([&] {
    device().reset();
    device() = simreel::Device::open(options);
  });
  device()->whileWaiting(signalled);
  chosen() = options;
  return *device();
}

simreel::Device& presentDevice() {
  return device() ? *device() : openDevice(chosen());
}

simreel::LoadOptions optionsOf(const std::vector<std::pair<std::string, std::string>>& changes,
                               std::vector<std::string> assets, bool motion) {
  simreel::LoadOptions options;
  for (const auto& [path, value] : changes) options.changes.push_back({path, value});
  options.assets = std::move(assets);
  options.motion = motion;
  return options;
}

/// A scene for Python. close() releases it while the Python object still exists.
class Held {
 public:
  explicit Held(simreel::Scene scene) : scene_(std::make_shared<simreel::Scene>(std::move(scene))) {}
  ~Held() { close(); }
  Held(Held&&) = default;
  Held& operator=(Held&&) = default;
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;

  /// Returns the scene. The returned pointer keeps it alive even if another thread closes it.
  [[nodiscard]] std::shared_ptr<simreel::Scene> get() const {
    if (!scene_) throw simreel::Error(simreel::ErrorKind::usage, "the scene is closed");
    return scene_;
  }
  void close() {
    std::shared_ptr<simreel::Scene> scene = std::move(scene_);
    if (scene) unlocked([&] { scene.reset(); });
  }

 private:
  std::shared_ptr<simreel::Scene> scene_;
};

template <class T>
void writeAs(const Held& held, const std::string& object, const std::string& array,
             const py::array& values) {
  const auto scene = held.get();
  const std::span<const T> all(static_cast<const T*>(values.data()),
                               static_cast<std::size_t>(values.nbytes()) / sizeof(T));
  unlocked([&] { scene->write(object, array, all); });
}

/// Writes an array without gaps, whose type is the state array's.
void write(const Held& held, const std::string& object, const std::string& array, const py::array& values) {
  if ((values.flags() & py::array::c_style) == 0)
    throw simreel::Error(simreel::ErrorKind::usage, "the values have gaps");
  switch (values.dtype().kind()) {
    case 'V':
      return writeAs<std::byte>(held, object, array, values);
    case 'u':
      return writeAs<std::uint32_t>(held, object, array, values);
    case 'i':
      return writeAs<std::int32_t>(held, object, array, values);
    default:
      return values.itemsize() == sizeof(double) ? writeAs<double>(held, object, array, values)
                                                 : writeAs<float>(held, object, array, values);
  }
}

py::list describeArrays(const Held& held) {
  const auto scene = held.get();
  py::list all;
  for (const simreel::ArrayInfo& one : unlocked([&] { return scene->arrays(); }))
    all.append(py::make_tuple(one.object, one.name, one.unit,
                              typeOf(one.type, one.members, one.elementBytes),
                              py::tuple(py::cast(one.shape)), one.writable));
  return all;
}

py::dict layers(const Held& held, const std::vector<std::string>& names) {
  const auto scene = held.get();
  py::dict all;
  for (simreel::Array& array : unlocked([&] { return scene->layers(names); })) {
    const py::str name(array.name);
    all[name] = toNumpy(std::move(array));
  }
  return all;
}

py::dict meshOf(const Held& held, const std::string& object) {
  const auto scene = held.get();
  simreel::Mesh mesh = unlocked([&] { return scene->mesh(object); });
  py::dict parts;
  for (simreel::Array* part : {&mesh.positions, &mesh.normals, &mesh.uvs, &mesh.triangles})
    parts[py::str(part->name)] = toNumpy(std::move(*part));
  return parts;
}

py::list check(const Held& held, const std::vector<int>& frames) {
  const auto scene = held.get();
  py::list all;
  for (const simreel::CheckResult& one : unlocked([&] { return scene->check(frames); }))
    all.append(py::make_tuple(one.what, one.frame, one.value, one.passed, one.problem));
  return all;
}

/// Adds the methods that read and write the state.
void addState(py::class_<Held>& type) {
  type.def("arrays", describeArrays)
      .def("read",
           [](const Held& held, const std::string& object, const std::string& array) {
             const auto scene = held.get();
             return toNumpy(unlocked([&] { return scene->read(object, array); }));
           })
      .def("read_on_device",
           [](const Held& held, const std::string& object, const std::string& array,
              const std::string& member) -> py::object {
             const auto scene = held.get();
             auto copy = unlocked([&] { return scene->readOnDevice(object, array, member); });
             if (!copy) return py::none();
             const int number = copy->device;
             return py::make_tuple(dlpackCapsule(*std::move(copy)), number);
           })
      .def("write", write)
      .def("field",
           [](const Held& held, const std::string& name) {
             const auto scene = held.get();
             return toNumpy(unlocked([&] { return scene->field(name); }));
           })
      .def("measure",
           [](const Held& held, const std::string& object) {
             const auto scene = held.get();
             py::dict values;
             for (const simreel::Quantity& one : unlocked([&] { return scene->measure(object); }))
               values[py::str(one.name)] = one.value;
             return values;
           })
      .def("mesh", meshOf)
      .def("save_state",
           [](const Held& held, const std::string& file) {
             const auto scene = held.get();
             unlocked([&] { scene->saveState(file); });
           })
      .def("restore", [](const Held& held, const simreel::Snapshot& snapshot) {
        const auto scene = held.get();
        unlocked([&] { scene->restore(snapshot); });
      });
}

/// Renders to files and returns their names. `onFrames`: function that gets the number of frames before the
/// first one, and 0 for each; or None.
std::string render(const Held& held, const std::string& output, const py::dict& values,
                   const py::object& onFrames) {
  const auto scene = held.get();
  simreel::RenderOptions options;
  options.frames = values["frames"].cast<std::optional<std::string>>();
  options.existing = values["resume"].cast<bool>()      ? simreel::Existing::resume
                     : values["overwrite"].cast<bool>() ? simreel::Existing::overwrite
                                                        : simreel::Existing::error;
  options.manifest = values["manifest"].cast<bool>();
  options.fields = values["fields"].cast<std::optional<std::string>>();
  options.layers = values["layers"].cast<std::vector<std::string>>();
  options.bits = values["bits"].cast<std::optional<int>>();
  std::exception_ptr failure;
  const auto tell = [&](int frames) {
    if (failure || ending) return;
    const py::gil_scoped_acquire acquire;
    try {
      onFrames(frames);
    } catch (...) {
      failure = std::current_exception();
      device()->interrupt();
    }
  };
  simreel::RenderEvents events;
  if (!onFrames.is_none()) {
    events.start = tell;
    events.frame = [&](int /*number*/, const simreel::StageTimes& /*times*/) { tell(0); };
  }
  try {
    return unlocked([&] { return scene->render(output, options, events); }).files;
  } catch (const simreel::Error&) {
    if (!failure) throw;
  }
  std::rethrow_exception(failure);
}

void addScene(py::module_& module) {
  using simreel::Scene;
  py::class_<simreel::Snapshot>(module, "Snapshot")
      .def_property_readonly("frame", &simreel::Snapshot::frame)
      .def_property_readonly("nbytes", &simreel::Snapshot::bytes);
  // Returns a Python method that calls a function of the scene without the interpreter's lock.
  const auto call = [](auto function) {
    return [function](const Held& held) {
      const auto scene = held.get();
      return unlocked([&] { return ((*scene).*function)(); });
    };
  };
  py::class_<Held> type(module, "Scene");
  addState(type);
  type.def("close", &Held::close)
      .def("title", call(&Scene::title))
      .def("fps", call(&Scene::fps))
      .def("frame_count", call(&Scene::frameCount))
      .def("size",
           [](const Held& held) { return py::make_tuple(held.get()->width(), held.get()->height()); })
      .def("remarks", call(&Scene::remarks))
      .def("is_changed", call(&Scene::isChanged))
      .def("restart", call(&Scene::restart))
      .def("state_hash", call(&Scene::stateHash))
      .def("fields", call(&Scene::fields))
      .def("layer_objects", call(&Scene::layerObjects))
      .def("snapshot", call(&Scene::snapshot))
      .def("objects",
           [](const Held& held) {
             py::dict kinds;
             for (const simreel::ObjectInfo& one : held.get()->objects())
               kinds[py::str(one.name)] = one.kind;
             return kinds;
           })
      .def("frame",
           [](const Held& held) {
             const auto scene = held.get();
             const simreel::Frame frame = unlocked([&] { return scene->frame(); });
             return py::make_tuple(frame.number, frame.time);
           })
      .def("advance_by",
           [](const Held& held, int frames) {
             const auto scene = held.get();
             const simreel::Frame frame = unlocked([&] { return scene->advanceBy(frames); });
             return py::make_tuple(frame.number, frame.time);
           })
      .def("advance_to",
           [](const Held& held, int number) {
             const auto scene = held.get();
             const simreel::Frame frame = unlocked([&] { return scene->advanceTo(number); });
             return py::make_tuple(frame.number, frame.time);
           })
      .def("picture",
           [](const Held& held) {
             const auto scene = held.get();
             return toNumpy(unlocked([&] { return scene->picture(); }));
           })
      .def("layers", layers)
      .def("check", check)
      .def("render", render);
}

py::bytes encodePng(const py::array_t<std::uint8_t, py::array::c_style>& pixels) {
  if (pixels.ndim() != 3)
    throw simreel::Error(simreel::ErrorKind::usage,
                         "a picture is an array of (height, width, 3 or 4) uint8");
  const auto extent = [&](int axis) { return static_cast<int>(pixels.shape(axis)); };
  simreel::Picture picture{extent(1), extent(0), extent(2), {}};
  picture.bytes.assign(pixels.data(), pixels.data() + pixels.size());
  const auto file = unlocked([&] { return simreel::encodePng(picture); });
  return {reinterpret_cast<const char*>(file.data()), file.size()};
}

}  // namespace

PYBIND11_MODULE(_native, module) {
  py::register_exception_translator([](std::exception_ptr failure) {
    try {
      if (failure) std::rethrow_exception(failure);
    } catch (const simreel::Error& error) {
      raise(error);
    }
  });
  module.def("prepare", simreel::prepareEnvironment);
  module.def("version", simreel::libraryVersion);
  module.def("schema", simreel::sceneSchema);
  module.def("open", [](const std::string& name, const std::string& path) {
    const simreel::Device& opened = openDevice({name, path});
    return py::make_tuple(opened.name(), opened.driver(), opened.isSoftware());
  });
  ::pthread_atfork(nullptr, nullptr, [] { inside = 0; });
  module.def("close", [] {
    endCalls();
    device().reset();
  });
  module.def("why_through_host", [] {
    const simreel::Device on = presentDevice();
    return unlocked([&] { return on.whyThroughHost(); });
  });
  module.def("messages", [] {
    py::list all;
    if (device())
      for (const simreel::Message& one : device()->takeMessages())
        all.append(py::make_tuple(one.level, one.text));
    return all;
  });
  module.def("load",
             [](const std::string& file, const std::vector<std::pair<std::string, std::string>>& changes,
                std::vector<std::string> assets, bool motion) {
               const simreel::Device on = presentDevice();
               const simreel::LoadOptions options = optionsOf(changes, std::move(assets), motion);
               return Held(unlocked([&] { return simreel::Scene::load(on, file, options); }));
             });
  module.def("parse", [](const std::string& text, const std::string& name,
                         const std::vector<std::pair<std::string, std::string>>& changes,
                         std::vector<std::string> assets, bool motion) {
    const simreel::Device on = presentDevice();
    const simreel::LoadOptions options = optionsOf(changes, std::move(assets), motion);
    return Held(unlocked([&] { return simreel::Scene::parse(on, text, name, options); }));
  });
  module.def("validate", [](const std::string& file, const std::optional<std::string>& text,
                            const std::vector<std::pair<std::string, std::string>>& changes,
                            std::vector<std::string> assets) {
    const simreel::LoadOptions options = optionsOf(changes, std::move(assets), false);
    return unlocked([&] { return simreel::validate(file, options, text); });
  });
  module.def("encode_png", encodePng);
  addScene(module);
}
