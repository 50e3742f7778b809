#include "sim/contact/lock_step.hpp"

#include <utility>

namespace simreel::sim {

namespace {

ContactPlan planOf(const std::vector<LockStep*>& members, double substepSeconds) {
  std::vector<ContactPart> parts;
  for (const LockStep* member : members) parts.push_back(member->contactPart());
  return {parts, substepSeconds};
}

}  // namespace

ContactGroup::ContactGroup(std::vector<LockStep*> members, int substeps, double frameSeconds, bool fast)
    : members_(std::move(members)),
      substeps_(substeps),
      contact_(planOf(members_, frameSeconds / substeps), substeps, fast) {}

void ContactGroup::step(double time, const std::function<void(std::size_t member, int step)>& watch) {
  contact_.beginFrame();
  for (LockStep* member : members_) member->beginFrame(time);
  for (int i = 0; i < substeps_; ++i) {
    std::vector<Contact::Part> parts;
    for (LockStep* member : members_) {
      member->predict(i);
      parts.push_back(member->arrays());
    }
    contact_.push(i, parts);
    for (LockStep* member : members_) member->settle(i);
    contact_.hold(i, parts);
    for (std::size_t m = 0; m < members_.size(); ++m) {
      members_[m]->finish();
      if (watch) watch(m, i + 1);
    }
  }
  for (LockStep* member : members_) member->endFrame(time);
}

}  // namespace simreel::sim
