#pragma once
#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::scene {
struct Object;
}

namespace simreel::sim {

class Links;
class Simulation;
class StepGroup;
struct ObjectParameters;
struct Setting;

/// Moment at which an object uses the state of a provider.
enum class When {
  beforeStep,  ///< The object reads the provider's state at the end of the frame, so the provider steps
               ///< first.
  frameStart,  ///< The object reads the provider's state at the start of the frame; the step order is free.
  afterFrame,  ///< The object reads the provider's state of the finished frame.
};

/// Kind of relation between scene objects, with its rules and the texts of its messages. Each class T that
/// objects provide to others has a `static const PortInfo port` in the header of T.
struct PortInfo {
  const char* name;   ///< Name of the port, such as "wind".
  const char* lacks;  ///< Text that continues the message `object "a" is a sphere`, such as ", which does
                      ///< not blow".
  const char* none;   ///< Message that follows an unknown name, such as "the scene has no
                      ///< fluid".
  When when = When::beforeStep;  ///< Time at which the provider's state is used, unless Ports::want() gives
                                 ///< another one.
  /// Noun for the parts that are named as in "smoke.u"; null if providers have no parts.
  const char* part = nullptr;
  bool partNeeded = false;  ///< True if a name must include a part; an object's name alone is invalid.
  /// Message if a second object provides the port, where {} is the name of the first; null if a scene may
  /// have several providers.
  const char* single = nullptr;
  /// Message for a provider that no object of the scene uses; null if a provider may be unused.
  const char* unused = nullptr;
  /// Message for an object that takes from all providers and requires at least one, when none exists.
  const char* missing = nullptr;
  /// Warning for an object that takes from all providers, about another object that could provide the port
  /// but does not. The two {} are the names of both objects.
  const char* skippedProviderText = nullptr;
  /// Appends to `parts` the parts that `provider` provides without declaring them. Returns true if
  /// `provider` provides the port in this way.
  bool (*implied)(const scene::Object& provider, std::vector<std::string>& parts) = nullptr;
  /// Exception for objects that do not provide the port. Returns true if `wanter` can use `provider`
  /// nevertheless.
  bool (*fits)(const ObjectParameters& provider, const ObjectParameters& wanter) = nullptr;
  /// Creates the group whose members step together. Null if objects cannot join this port.
  std::unique_ptr<StepGroup> (*group)(const Setting& setting, std::span<void* const> members,
                                      int steps) = nullptr;
};

/// Declarations of what an object provides to others and takes from them (ObjectParameters::ports).
class Ports {
 public:
  struct Offer {
    const PortInfo* port;
    bool given;  ///< False if the object does not provide the port. In this case, `unless` gives the
                 ///< reason.
    std::string unless;  ///< Text that continues the message `object "a" is a cloth`, such as " without
                         ///< \"contact\"".
    std::vector<std::string> parts = {};
    std::vector<std::string> path = {};  ///< JSON path used in messages, relative to the object's
                                         ///< parameters.
  };
  struct Want {
    const PortInfo* port;
    std::string name;               ///< Name of the provider, OBJECT or OBJECT.PART; empty if `all`.
    std::vector<std::string> path;  ///< JSON path of the name, relative to the object's parameters.
    When when;
    bool all = false;        ///< True if the object takes from every object that provides the port.
    bool needed = false;     ///< If `all` is true: true if at least one provider is required.
    std::string words = {};  ///< Text after the name in the message `no object is named "a"`. It describes
                             ///< what a scene can give instead of a provider.
    bool whole = false;      ///< True if only a whole object may be named, and not a part of it.
  };
  struct Join {
    const PortInfo* port;
    bool leads;  ///< True if the object can start the group. If false, the object only joins a group that
                 ///< another object starts.
  };

  /// Provides T to objects that name this object or that take from all providers.
  template <class T>
  Offer& provide(bool given = true, std::string unless = {}) {
    return offers.emplace_back(Offer{&T::port, given, std::move(unless)});
  }
  /// Takes T from the named object. Does nothing if the name is empty.
  template <class T>
  void want(const std::string& name, std::vector<std::string> path, std::string words = {}) {
    if (name.empty()) return;
    wants.push_back({&T::port, name, std::move(path), T::port.when, false, false, std::move(words)});
  }
  /// Takes T from the named object. An empty name is an error.
  template <class T>
  void requireFrom(const std::string& name, std::vector<std::string> path, When when = T::port.when) {
    wants.push_back({&T::port, name, std::move(path), when});
  }
  /// Takes T from every object that provides it.
  template <class T>
  void wantAll() {
    wants.push_back({&T::port, {}, {}, T::port.when, true, false});
  }
  /// Takes T from every object that provides it. A scene without such an object is an error at `path`.
  template <class T>
  void requireAny(std::vector<std::string> path) {
    wants.push_back({&T::port, {}, std::move(path), T::port.when, true, true});
  }
  /// Makes the object step together with all other objects that join T. The group exists only if at least
  /// one member has `leads` set.
  template <class T>
  void join(bool leads) {
    joins.push_back({&T::port, leads});
  }

  std::vector<Offer> offers;
  std::vector<Want> wants;
  std::vector<Join> joins;
};

/// Group of objects that step together; World steps it as one node of the step order.
class StepGroup {
 public:
  virtual ~StepGroup() = default;
  /// Callback after each step of a member; steps are counted from 1.
  using Watch = std::function<void(std::size_t member, int step)>;
  /// Advances all members by the frame that starts at `time` (seconds).
  virtual void step(double time, const Watch& watch) = 0;
};

/// State of a step group (Ports::join): whether it exists, and its number of steps.
struct GroupState {
  bool led = false;  ///< True if an object of the scene leads the group.
  int steps = 0;     ///< Steps per frame: the maximum of all members' step counts; 0 if each member uses
                     ///< its own step count.
};

/// Looks up the outlets of a scene's objects.
class Links {
 public:
  virtual ~Links() = default;
  /// Returns the outlet of `object` for a port, or null if it has none (yet). For an empty name, returns
  /// the outlet of the scene itself, or if none exists, the first outlet of an object.
  [[nodiscard]] virtual void* find(const PortInfo& port, std::string_view object) const = 0;
  /// Returns the outlets of all objects for a port, in step order.
  [[nodiscard]] virtual std::vector<void*> all(const PortInfo& port) const = 0;
  [[nodiscard]] virtual GroupState together(const PortInfo& port) const = 0;
  /// Returns the simulation of an object; null until it is created.
  [[nodiscard]] virtual const Simulation* simulation(std::string_view object) const = 0;
  [[nodiscard]] virtual const scene::Object* declared(std::string_view object) const = 0;
  /// Returns the time of the current frame in seconds.
  [[nodiscard]] virtual double now() const = 0;

  template <class T>
  [[nodiscard]] T* get(std::string_view object = {}) const {
    return static_cast<T*>(find(T::port, object));
  }
  /// Returns an object's outlet, which must exist. checkPorts() has checked the scene for it.
  template <class T>
  [[nodiscard]] T& of(std::string_view object) const {
    return *static_cast<T*>(checked(find(T::port, object), T::port, object));
  }

 private:
  static void* checked(void* outlet, const PortInfo& port, std::string_view object);
};

/// Collects the outlets of one object (Simulation::connect).
class Outlets {
 public:
  using Find = std::function<void*()>;

  /// Provides T; `outlet` must live as long as the simulation.
  template <class T>
  void provide(T* outlet) {
    add(T::port, [outlet] { return outlet; });
  }
  /// Provides T through a function, which is called each time another object uses T.
  template <class T>
  void provideBy(std::function<T*()> find) {
    add(T::port, [find = std::move(find)]() -> void* { return find(); });
  }

  struct Outlet {
    const PortInfo* port;
    Find find;
  };
  std::vector<Outlet> list;

 private:
  void add(const PortInfo& port, Find find) { list.push_back({&port, std::move(find)}); }
};

/// Splits "smoke.u" into object and part; the part is empty if there is no dot.
struct PartName {
  explicit PartName(std::string_view name)
      : object(name.substr(0, name.find('.'))),
        part(name.substr(std::min(name.size(), object.size() + 1))) {}
  std::string object, part;
};

}  // namespace simreel::sim
