#include "sim/world/port_check.hpp"

#include "scene/json/words.hpp"
#include "sim/core/kind.hpp"
#include "sim/ports/field_source.hpp"
#include "sim/ports/markers.hpp"
#include "sim/world/step_order.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

using Objects = std::span<const scene::Object>;

const ObjectParameters* parametersAt(const scene::Object& object) {
  return dynamic_cast<const ObjectParameters*>(object.parameters.get());
}

const scene::Object* named(Objects objects, std::string_view name) {
  const auto found =
      std::find_if(objects.begin(), objects.end(), [&](const scene::Object& o) { return o.name == name; });
  return found == objects.end() ? nullptr : &*found;
}

/// Result of the check whether one object provides a port to another object.
struct Offered {
  bool given = false;
  std::string unless;              ///< reason if the port is not provided
  std::vector<std::string> parts;  ///< full names of the provider's parts, OBJECT.PART
};

Offered offered(const scene::Object& provider, const scene::Object& wanter, const PortInfo& port) {
  Offered all;
  if (provider.parameters == nullptr) return all;
  std::vector<std::string> parts;
  if (port.implied != nullptr) all.given = port.implied(provider, parts);
  for (const Ports::Offer& offer : portsOf(provider).offers) {
    if (offer.port != &port) continue;
    const auto *theirs = parametersAt(provider), *ours = parametersAt(wanter);
    all.given = offer.given ||
                (port.fits != nullptr && theirs != nullptr && ours != nullptr && port.fits(*theirs, *ours));
    all.unless = offer.unless;
    parts.insert(parts.end(), offer.parts.begin(), offer.parts.end());
  }
  if (all.given)
    for (const std::string& part : parts) all.parts.push_back(provider.name + "." + part);
  return all;
}

/// Returns the names by which another object may refer to a provider or to its parts.
std::vector<std::string> namesOf(const scene::Object& provider, const Offered& offer,
                                 const Ports::Want& want) {
  std::vector<std::string> names;
  if (!offer.given) return names;
  if (!want.port->partNeeded) names.push_back(provider.name);
  if (!want.whole) names.insert(names.end(), offer.parts.begin(), offer.parts.end());
  return names;
}

/// Returns an error message for the name that an object refers to. Empty if the name is valid, or if the
/// named object itself has an error.
std::string mistakeOf(const Ports::Want& want, const scene::Object& wanter, Objects objects) {
  const PortInfo& port = *want.port;
  std::vector<std::string> names;
  for (const scene::Object& candidate : objects) {
    const auto more = namesOf(candidate, offered(candidate, wanter, port), want);
    names.insert(names.end(), more.begin(), more.end());
  }
  if (std::find(names.begin(), names.end(), want.name) != names.end()) return {};
  const std::string none = names.empty() ? std::string(port.none) : scene::suggestion(want.name, names);
  if (want.name.empty()) return fmt::format("it has no \"{}\"; {}", want.path.back(), none);
  const std::string owner = port.part != nullptr && !want.whole ? PartName(want.name).object : want.name;
  const scene::Object* provider = named(objects, owner);
  if (provider == nullptr)
    return fmt::format("no object is named {}{}; {}", scene::inQuotes(owner), want.words, none);
  if (provider->parameters == nullptr) return {};
  const Offered offer = offered(*provider, wanter, port);
  if (offer.given)
    return fmt::format("object \"{}\" has no {} {}; {}", owner, port.part, scene::inQuotes(want.name),
                       scene::suggestion(want.name, namesOf(*provider, offer, want)));
  return fmt::format("object \"{}\" is a {}{}; {}", owner, provider->kind,
                     offer.unless.empty() ? port.lacks : offer.unless, none);
}

std::vector<std::string> placed(const scene::Object& object, const std::vector<std::string>& path) {
  std::vector<std::string> whole = {object.kind};
  whole.insert(whole.end(), path.begin(), path.end());
  return whole;
}

/// Returns true if an object of the scene takes the port from all providers or from `provider` by name.
bool isTaken(const PortInfo& port, const std::string& provider, Objects objects) {
  return std::any_of(objects.begin(), objects.end(), [&](const scene::Object& object) {
    const Ports ports = portsOf(object);
    return std::any_of(ports.wants.begin(), ports.wants.end(), [&](const Ports::Want& want) {
      return want.port == &port && (want.all || PartName(want.name).object == provider);
    });
  });
}

/// Reports a second provider of a port that allows only one, and providers that no object uses.
void checkOffers(Objects objects, const scene::Report& report) {
  std::vector<std::pair<const PortInfo*, const scene::Object*>> firsts;
  for (const scene::Object& object : objects)
    for (const Ports::Offer& offer : portsOf(object).offers) {
      if (!offer.given) continue;
      const PortInfo& port = *offer.port;
      const auto first =
          std::find_if(firsts.begin(), firsts.end(), [&](const auto& one) { return one.first == &port; });
      if (first == firsts.end())
        firsts.emplace_back(&port, &object);
      else if (port.single != nullptr)
        report(object, placed(object, offer.path),
               fmt::format(fmt::runtime(port.single), first->second->name));
      if (port.unused != nullptr && !isTaken(port, object.name, objects))
        report(object, placed(object, offer.path), port.unused);
    }
}

/// Appends an error message, after its JSON path, if a name to which the scene itself refers is invalid.
template <class Port>
void checkNamed(const char* where, const std::string& name, Objects objects,
                std::vector<std::string>& mistakes) {
  const Ports::Want want{&Port::port, name, {"object"}, When::afterFrame};
  const std::string mistake = mistakeOf(want, scene::Object{}, objects);
  if (!mistake.empty()) mistakes.push_back(fmt::format("{}.object: {}", where, mistake));
}

/// Reports objects that take from all providers and require one, if the scene has none.
void checkNeeds(Objects objects, bool hasGround, const scene::Report& report) {
  const auto unread = [](const scene::Object& object) { return object.parameters == nullptr; };
  if (std::any_of(objects.begin(), objects.end(), unread)) return;  // such an object may be the provider
  for (const scene::Object& object : objects)
    for (const Ports::Want& want : portsOf(object).wants) {
      if (!want.all || !want.needed || (hasGround && want.port == &Touchable::port)) continue;
      const bool found = std::any_of(objects.begin(), objects.end(), [&](const scene::Object& other) {
        return provides(other, *want.port);
      });
      if (!found) report(object, placed(object, want.path), want.port->missing);
    }
}

}  // namespace

void checkPorts(Objects objects, bool hasGround, const scene::Report& report) {
  for (const scene::Object& object : objects) {
    if (object.material.skin && object.materialKeys.contains("skin")) {
      Ports::Want skin{&FieldSource::port, object.material.skin->field, {"field"}, When::afterFrame};
      skin.whole = true;
      const std::string mistake = mistakeOf(skin, object, objects);
      if (!mistake.empty()) report(object, {"material", "skin", "field"}, mistake);
    }
    for (const Ports::Want& want : portsOf(object).wants) {
      const std::string mistake = want.all ? std::string() : mistakeOf(want, object, objects);
      if (!mistake.empty()) report(object, placed(object, want.path), mistake);
    }
  }
  checkOffers(objects, report);
  checkNeeds(objects, hasGround, report);
  checkOrder(objects, report);
}

std::vector<std::string> portMistakes(const scene::Scene& scene) {
  std::vector<std::string> mistakes;
  const Objects objects = scene.objects;
  if (scene.camera.track)
    checkNamed<CentrePort>("camera.track", scene.camera.track->object, objects, mistakes);
  if (scene.camera.follow)
    checkNamed<PathPort>("camera.follow", scene.camera.follow->object, objects, mistakes);
  for (const scene::Light& light : scene.lights)
    if (light.follow)
      checkNamed<PathPort>(("lights." + light.name + ".follow").c_str(), light.follow->object, objects,
                           mistakes);
  return mistakes;
}

std::vector<std::string> portRemarks(const scene::Scene& scene) {
  std::vector<std::string> remarks;
  for (const scene::Object& provider : scene.objects)
    for (const Ports::Offer& offer : portsOf(provider).offers) {
      if (offer.given || offer.port->skippedProviderText == nullptr) continue;
      const scene::Object* wanter = nullptr;
      for (const scene::Object& object : scene.objects)
        for (const Ports::Want& want : portsOf(object).wants)
          if (want.port == offer.port && want.all) wanter = &object;
      if (wanter != nullptr)
        remarks.push_back(
            fmt::format(fmt::runtime(offer.port->skippedProviderText), wanter->name, provider.name));
    }
  return remarks;
}

}  // namespace simreel::sim
