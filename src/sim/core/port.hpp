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

/// State of a provider that an object uses.
enum class When {
  beforeStep,  ///< the state at the end of the frame; the provider steps first
  frameStart,  ///< the state at the start of the frame, in any order
  afterFrame,  ///< the state of the finished frame
};

/// Kind of relation between objects of a scene: its rules, and the words of its messages. A class T that
/// objects provide to others has a `static const PortInfo port` in its own header.
struct PortInfo {
  const char* name;              ///< "wind"
  const char* lacks;             ///< after `object "a" is a sphere`: ", which does not blow"
  const char* none;              ///< after a name that is not known: "the scene has no fluid"
  When when = When::beforeStep;  ///< default of Ports::want
  /// Parts that a provider names with a dot, as "smoke.u": what one is called. Null: it has none.
  const char* part = nullptr;
  bool partNeeded = false;  ///< the name of an object alone is none of them
  /// Message at a second provider; {} is the name of the first. Null: a scene may have several.
  const char* single = nullptr;
  /// Message at a provider where no object of the scene takes it. Null: it may be unused.
  const char* unused = nullptr;
  /// Message of an object that takes all and must find one. {} twice: its name and kind.
  const char* missing = nullptr;
  /// Remark where an object takes all and one could provide it but does not. {} twice: the names.
  const char* passedBy = nullptr;
  /// Appends the parts that any object provides without saying so; returns whether it does.
  bool (*implied)(const scene::Object& provider, std::vector<std::string>& parts) = nullptr;
  /// Exception to an offer that is not given: returns true where `wanter` can use it all the same.
  bool (*fits)(const ObjectParameters& provider, const ObjectParameters& wanter) = nullptr;
  /// Makes the node of the step order in which all members step together. Null: members may not join it.
  std::unique_ptr<StepGroup> (*group)(const Setting& setting, std::span<void* const> members,
                                      int steps) = nullptr;
};

/// Declares what an object provides to others and what it takes from them (ObjectParameters::ports).
class Ports {
 public:
  struct Offer {
    const PortInfo* port;
    bool given;          ///< false: `unless` says why not
    std::string unless;  ///< after `object "a" is a cloth`: " without \"contact\""
    std::vector<std::string> parts = {};
    std::vector<std::string> path = {};  ///< place of messages, from the object's parameters
  };
  struct Want {
    const PortInfo* port;
    std::string name;               ///< OBJECT or OBJECT.PART; empty with `all`
    std::vector<std::string> path;  ///< place of the name, from the object's parameters
    When when;
    bool all = false;        ///< takes from every object that provides it
    bool needed = false;     ///< with `all`: at least one must be there
    std::string words = {};  ///< after "no object is named": words that may stand there
    bool whole = false;      ///< takes no part of an object
  };
  struct Join {
    const PortInfo* port;
    bool leads;  ///< false: joins only where another one leads
  };

  /// Offers T to objects that name this one or take from all.
  template <class T>
  Offer& provide(bool given = true, std::string unless = {}) {
    return offers.emplace_back(Offer{&T::port, given, std::move(unless)});
  }
  /// Takes T of the object of that name; no name: of none.
  template <class T>
  void want(const std::string& name, std::vector<std::string> path, std::string words = {}) {
    if (name.empty()) return;
    wants.push_back({&T::port, name, std::move(path), T::port.when, false, false, std::move(words)});
  }
  /// The same where a name must be given: its absence is a mistake.
  template <class T>
  void mustWant(const std::string& name, std::vector<std::string> path, When when = T::port.when) {
    wants.push_back({&T::port, name, std::move(path), when});
  }
  /// Takes T of every object that provides it. `needed`: at least one must.
  template <class T>
  void wantAll(bool needed = false) {
    wants.push_back({&T::port, {}, {}, T::port.when, true, needed});
  }
  /// Steps together with all others that join T. `leads`: the group exists because of it.
  template <class T>
  void join(bool leads) {
    joins.push_back({&T::port, leads});
  }

  std::vector<Offer> offers;
  std::vector<Want> wants;
  std::vector<Join> joins;
};

/// Object that several objects step as; World steps it as one node of the step order.
class StepGroup {
 public:
  virtual ~StepGroup() = default;
  /// Called after each step of a member, counted from 1.
  using Watch = std::function<void(std::size_t member, int step)>;
  /// Advances all members by the frame that starts at `time` (s).
  virtual void step(double time, const Watch& watch) = 0;
};

/// State of a group that objects may join (Ports::join).
struct Together {
  bool led = false;  ///< an object of the scene leads it
  int steps = 0;     ///< per frame, the most that a member takes; 0: each takes its own number
};

/// Finds the outlets of a scene's objects.
class Links {
 public:
  virtual ~Links() = default;
  /// Returns the outlet of `object` for a port; null if it has none (yet). An empty name: returns the
  /// outlet of the scene itself, else the first outlet of an object.
  [[nodiscard]] virtual void* find(const PortInfo& port, std::string_view object) const = 0;
  /// Returns all outlets of objects, in step order.
  [[nodiscard]] virtual std::vector<void*> all(const PortInfo& port) const = 0;
  [[nodiscard]] virtual Together together(const PortInfo& port) const = 0;
  /// Returns the simulation and the declaration of an object; the simulation is null until it is made.
  [[nodiscard]] virtual const Simulation* simulation(std::string_view object) const = 0;
  [[nodiscard]] virtual const scene::Object* declared(std::string_view object) const = 0;
  /// Time of the present frame, s.
  [[nodiscard]] virtual double now() const = 0;

  template <class T>
  [[nodiscard]] T* get(std::string_view object = {}) const {
    return static_cast<T*>(find(T::port, object));
  }
  /// Returns the outlet of an object. The check of the scene has found it (checkPorts).
  template <class T>
  [[nodiscard]] T& of(std::string_view object) const {
    return *static_cast<T*>(checked(find(T::port, object), T::port, object));
  }

 private:
  static void* checked(void* outlet, const PortInfo& port, std::string_view object);
};

/// Takes the outlets of one object (Simulation::connect).
class Outlets {
 public:
  using Find = std::function<void*()>;

  /// Provides T; `outlet` lives as long as the simulation.
  template <class T>
  void provide(T* outlet) {
    add(T::port, [outlet] { return outlet; });
  }
  /// The same, where `find` is called whenever another object uses it.
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

/// Splits "smoke.u" into object and part; the part is empty where there is no dot.
struct PartName {
  explicit PartName(std::string_view name)
      : object(name.substr(0, name.find('.'))),
        part(name.substr(std::min(name.size(), object.size() + 1))) {}
  std::string object, part;
};

}  // namespace simreel::sim
