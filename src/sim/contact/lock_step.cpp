#include "sim/contact/lock_step.hpp"

#include "base/log.hpp"
#include "sim/contact/crossings.hpp"

#include <utility>

namespace simreel::sim {

namespace {

ContactPlan planOf(const std::vector<LockStep*>& members, const std::vector<ContactSolid*>& solids,
                   double substepSeconds) {
  std::vector<ContactPart> parts;
  parts.reserve(members.size() + solids.size());
  for (const LockStep* member : members) parts.push_back(member->contactPart());
  for (const ContactSolid* solid : solids) parts.push_back(solid->contactPart());
  ContactPlan plan(parts, substepSeconds);
  std::vector<glm::vec4> positions;
  for (const ContactPart& part : parts)
    positions.insert(positions.end(), part.positions.begin(), part.positions.end());
  if (const long crossings = crossingsOf(plan, positions); crossings > 0)
    warn(
        "cloths in contact intersect each other{} or themselves at the start, {} times an edge through a "
        "face, and contact cannot separate them there; place them apart",
        solids.empty() ? "" : ", a solid", crossings);
  return plan;
}

std::unique_ptr<StepGroup> makeGroup(const Setting& setting, std::span<void* const> outlets, int steps) {
  std::vector<LockStep*> members;
  for (void* outlet : outlets) members.push_back(static_cast<LockStep*>(outlet));
  std::vector<ContactSolid*> solids;
  for (void* outlet : setting.links->all(ContactSolid::port))
    solids.push_back(static_cast<ContactSolid*>(outlet));
  return std::make_unique<ContactGroup>(members, solids, steps, setting.frameSeconds, setting.fast);
}

}  // namespace

constinit const PortInfo LockStep::port = {
    .name = "contact",
    .lacks = ", which is not in contact",
    .none = "nothing in the scene is in contact",
    .group = makeGroup,
};

constinit const PortInfo ContactCloth::port = {
    .name = "cloth in contact",
    .lacks = ", which is no cloth",
    .none = "give a \"cloth\" of this scene \"contact\": {}",
    .when = When::afterFrame,
    .skippedProviderText =
        "particles \"{}\" collide, but pass through cloth \"{}\", which has no contact; give the cloth "
        "\"contact\": true, or the particles \"cloths\": \"none\"",
};

ContactGroup::ContactGroup(std::vector<LockStep*> members, std::vector<ContactSolid*> solids, int substeps,
                           double frameSeconds, bool fast)
    : members_(std::move(members)),
      solids_(std::move(solids)),
      substeps_(substeps),
      contact_(planOf(members_, solids_, frameSeconds / substeps), substeps, fast) {}

std::vector<Contact::Part> ContactGroup::parts() const {
  std::vector<Contact::Part> parts;
  parts.reserve(members_.size() + solids_.size());
  for (const LockStep* member : members_) parts.push_back(member->arrays());
  for (const ContactSolid* solid : solids_) parts.push_back({&solid->now(), &solid->next(), nullptr});
  return parts;
}

void ContactGroup::substeps(const Watch& watch) {
  for (int i = 0; i < substeps_; ++i) {
    for (ContactSolid* solid : solids_) solid->moveTo(i, substeps_);
    for (LockStep* member : members_) member->predict(i);
    contact_.push(i, parts());
    for (LockStep* member : members_) member->settle(i);
    contact_.hold(i, parts());
    for (std::size_t m = 0; m < members_.size(); ++m) {
      members_[m]->finish();
      if (watch) watch(m, i + 1);
    }
  }
}

void ContactGroup::step(double time, const Watch& watch) {
  contact_.beginFrame(parts());
  for (LockStep* member : members_) member->beginFrame(time);
  substeps({});
  bool enough = contact_.endFrame();
  while (!enough || watch) {  // Repeats the frame until the memory suffices. `watch` is called only in a
                              // last repetition for which the memory suffices.
    contact_.restore(parts());
    for (LockStep* member : members_) member->restored();
    substeps(enough ? watch : Watch());
    if (enough) break;
    enough = contact_.endFrame();
    if (enough && !watch) break;
  }
  for (LockStep* member : members_) member->endFrame(time);
}

}  // namespace simreel::sim
