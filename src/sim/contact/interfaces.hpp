#pragma once
#include "gl/kernel/kernel.hpp"
#include "sim/contact/plan.hpp"

/// Interfaces of the contact kernels (glsl/contact).
namespace simreel::sim {

/// Part of a kernel interface: members of glsl/contact/kernel.glsl.
struct ContactShared {
  gl::Block<"StepBlock", shader::ContactStep> step;
  gl::InOut<"points"> points;
  gl::InOut<"ControlBlock"> control;
};
/// Part of a kernel interface: members of glsl/contact/near_list.glsl.
struct ContactNearList {
  gl::In<"corners"> corners;
  gl::InOut<"nears"> nears;
  gl::InOut<"TallyBlock"> tallies;
  gl::In<"tallyTexels"> tallyTexels;  // Texel view of the tallies.
};
/// Index range of a part's vertices among all vertices.
struct ContactRange {
  gl::Uniform<"first", int> first;
  gl::Uniform<"count", int> count;
};
/// Selects the kind of pairs: edge-edge or vertex-face.
struct ContactPairs {
  gl::Flag<"EDGES"> edges;
};

/// Interface of a kernel that accesses only the memory in ContactShared.
template <gl::Name path>
struct ContactPlain {
  static constexpr auto file = path.text;
  ContactShared shared;
};

/// Interface of a kernel with one invocation per near pair.
template <gl::Name path>
struct ContactNears {
  static constexpr auto file = path.text;
  ContactShared shared;
  ContactNearList near;
};

struct ContactGather {
  static constexpr auto file = "contact/gather.comp";
  ContactShared shared;
  ContactRange range;
  gl::In<"partNow"> now;
  gl::In<"partNext"> next;
  gl::InOut<"TallyBlock"> tallies;
};

struct ContactReadBack {
  static constexpr auto file = "contact/take.comp";
  ContactShared shared;
  ContactRange range;
  gl::In<"partNext"> next;
};

struct ContactHand {
  static constexpr auto file = "contact/hand.comp";
  ContactShared shared;
  ContactRange range;
  gl::InOut<"partNext"> next;
  gl::InOut<"partVelocities"> velocities;
};

struct ContactLeave {
  static constexpr auto file = "contact/leave.comp";
  ContactShared shared;
  ContactRange range;
  gl::InOut<"partNext"> next;
  gl::InOut<"partVelocities"> velocities;
  gl::InOut<"TallyBlock"> tallies;
};

struct ContactLists {
  static constexpr auto file = "contact/lists.comp";
  struct Variant {
    gl::Flag<"NEAR"> near;
    gl::Flag<"CANDIDATES"> candidates;
  };
  ContactShared shared;
};

struct ContactLeaves {
  static constexpr auto file = "contact/leaves.comp";
  ContactShared shared;
  gl::Uniform<"levels", int> levels;
  gl::In<"leaves"> leaves;
  gl::Out<"BoxBlock"> boxes;
};

struct ContactRefit {
  static constexpr auto file = "contact/refit.comp";
  struct Variant {
    gl::Range<"AT_ONCE", 1, 3> atOnce;
  };
  ContactShared shared;
  gl::Uniform<"level", int> level;
  gl::Uniform<"levels", int> levels;
  gl::InOut<"boxes"> boxes;
};

struct ContactSearch {
  static constexpr auto file = "contact/search.comp";
  using Variant = ContactPairs;
  ContactShared shared;
  gl::Uniform<"levels", int> levels;
  gl::In<"leaves"> leaves;
  gl::In<"boxes"> boxes;
  gl::Out<"CandidateBlock"> candidates;
};

struct ContactSift {
  static constexpr auto file = "contact/sift.comp";
  using Variant = ContactPairs;
  ContactShared shared;
  gl::In<"candidates"> candidates;
  gl::Out<"PairBlock"> pairs;
};

struct ContactNear {
  static constexpr auto file = "contact/near.comp";
  using Variant = ContactPairs;
  ContactShared shared;
  gl::In<"pairs"> pairs;
  gl::Out<"CornerBlock"> corners;
  gl::Out<"NearBlock"> nears;
  gl::InOut<"TallyBlock"> tallies;
};

struct ContactTallied {
  static constexpr auto file = "contact/apply.comp";
  ContactShared shared;
  gl::InOut<"TallyBlock"> tallies;
};

struct ContactStart {
  static constexpr auto file = "contact/start.comp";
  ContactShared shared;
  gl::In<"TallyBlock"> tallies;
};

struct ContactHold {
  static constexpr auto file = "contact/hold.comp";
  ContactShared shared;
  ContactNearList near;
  gl::Uniform<"round", int> round;
};

}  // namespace simreel::sim
