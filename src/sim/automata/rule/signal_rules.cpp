#include "sim/automata/rule/signal_rules.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace simreel::sim {

namespace {

enum class Kind { ground, sensitized, ordinary, special, confluent };
constexpr int firstArrow = 9, firstSpecial = 17, firstConfluent = 25;
constexpr int alongX = 29, alongY = 30, alongBoth = 31;  ///< states of crossings that carry signals
using Around = std::array<int, 4>;  ///< states to the east, north, west and south; the indices are the
                                    ///< directions 0 to 3

Kind kindOf(int state) {
  return state == 0               ? Kind::ground
         : state < firstArrow     ? Kind::sensitized
         : state < firstSpecial   ? Kind::ordinary
         : state < firstConfluent ? Kind::special
                                  : Kind::confluent;
}
bool isArrow(int state) {
  return state >= firstArrow && state < firstConfluent;
}
int directionOf(int arrow) {
  return (arrow - firstArrow) % 4;
}
bool isExcited(int state) {
  return isArrow(state) && ((state - firstArrow) & 4) != 0;
}
int excited(int arrow) {
  return isExcited(arrow) ? arrow : arrow + 4;
}
int quiet(int arrow) {
  return isExcited(arrow) ? arrow - 4 : arrow;
}
int arrowOf(Kind kind, int direction) {
  return (kind == Kind::ordinary ? firstArrow : firstSpecial) + direction % 4;
}
int opposite(int direction) {
  return (direction + 2) % 4;
}

/// Returns true if the neighbour in this direction is an arrow that points to this cell.
bool pointsHere(int state, int direction) {
  return isArrow(state) && directionOf(state) == opposite(direction);
}
/// Returns true if the cell `middle` is an arrow of this kind that points to the neighbour in this
/// direction.
bool faces(int middle, Kind kind, int direction) {
  return kindOf(middle) == kind && directionOf(middle) == direction;
}
/// Returns true if the neighbour in this direction is a confluent cell that now sends a signal to this
/// cell.
bool emits(int state, int direction) {
  const bool horizontal = direction % 2 == 0;
  return state == 27 || state == 28 || state == alongBoth || (state == alongX && horizontal) ||
         (state == alongY && !horizontal);
}

/// Inputs of a cell on which all three rules depend.
struct Inputs {
  bool ordinary = false, special = false;  ///< true if excited ordinary or special arrows point to the cell
  bool quietOrdinary = false;              ///< true if a quiet ordinary arrow points to the cell
  bool x = false, y = false;               ///< true if excited ordinary arrows point to the cell along the
                                           ///< axis

  [[nodiscard]] int crossing() const {
    return x && y ? alongBoth : y ? alongY : x ? alongX : firstConfluent;
  }
};

Inputs inputsOf(const Around& around) {
  Inputs in;
  for (int d = 0; d < 4; ++d) {
    const int state = around[static_cast<std::size_t>(d)];
    if (!pointsHere(state, d)) continue;
    if (kindOf(state) == Kind::special) {
      in.special = in.special || isExcited(state);
    } else if (!isExcited(state)) {
      in.quietOrdinary = true;
    } else {
      in.ordinary = true;
      (d % 2 == 0 ? in.x : in.y) = true;
    }
  }
  return in;
}

/// Returns the next of the four confluent states, which have memory. The first bit of a state is the signal
/// that leaves now, the second bit is the signal that leaves next.
int confluentAfter(int state, bool arrives) {
  const bool leavesNext = state == 26 || state == 28;
  return firstConfluent + (leavesNext ? 2 : 0) + (arrives ? 1 : 0);
}

/// Returns the next state of a sensitized cell from the bits that it has received and whether it receives a
/// signal now.
int sensitizedAfter(int state, bool signal) {
  constexpr std::array<int, 9> complete = {11, 12, 17, 18, 19, 20, firstConfluent, 9, 10};
  const int code = 2 * state + (signal ? 1 : 0);
  return code < firstArrow ? code : complete[static_cast<std::size_t>(code - firstArrow)];
}

int confluentOutcome(bool crosses, int middle, const Around& around, const Inputs& in) {
  if (in.special) return 0;
  if (!crosses) return confluentAfter(middle, in.ordinary && !in.quietOrdinary);
  std::array<bool, 2> entered{}, left{};
  for (int d = 0; d < 4; ++d) {
    const int state = around[static_cast<std::size_t>(d)];
    if (!isArrow(state)) continue;
    const auto axis = static_cast<std::size_t>(d % 2);
    if (!pointsHere(state, d)) left[axis] = true;
    if (pointsHere(state, d) && kindOf(state) == Kind::ordinary) entered[axis] = true;
  }
  if (entered[0] && entered[1] && left[0] && left[1]) return in.crossing();
  const int memory = middle >= alongX ? firstConfluent : middle;
  if (in.ordinary && !in.quietOrdinary) return confluentAfter(memory, true);
  return left[0] || left[1] ? confluentAfter(memory, false) : memory;
}

/// Returns the next state by von Neumann's rule, with Nobili's crossings if `crosses` is true.
int neumannOutcome(bool crosses, int middle, const Around& around) {
  const Inputs in = inputsOf(around);
  const Kind kind = kindOf(middle);
  if (kind == Kind::ground || kind == Kind::sensitized)
    return sensitizedAfter(middle, in.ordinary || in.special);
  if (kind == Kind::confluent) return confluentOutcome(crosses, middle, around, in);
  if (kind == Kind::ordinary ? in.special : in.ordinary) return 0;
  // Arrows that face each other do not excite each other, and confluent cells do not send signals
  // backwards.
  bool signal = false;
  for (int d = 0; d < 4; ++d) {
    const int state = around[static_cast<std::size_t>(d)];
    if (directionOf(middle) == d) continue;
    signal = signal || emits(state, d) || (isExcited(state) && pointsHere(state, d));
  }
  return signal ? excited(middle) : quiet(middle);
}

/// Neighbourhood of a cell in Hutton's rule.
class HuttonCell {
 public:
  HuttonCell(int middle, const Around& around) : c_(middle), around_(around), in_(inputsOf(around)) {}

  [[nodiscard]] int outcome() const {
    switch (kindOf(c_)) {
      case Kind::ground:
        return arrow(Kind::ordinary)  ? 1
               : arrow(Kind::special) ? arrowOf(Kind::ordinary, directionOf(input()))
                                      : 0;
      case Kind::sensitized:
        return sensitized();
      case Kind::ordinary:
        return ordinary();
      case Kind::special:
        return special();
      default:
        return confluent();
    }
  }

 private:
  /// Returns true if an excited arrow of this kind points to the cell and the cell does not face that
  /// arrow.
  [[nodiscard]] bool arrow(Kind kind) const {
    for (int d = 0; d < 4; ++d)
      if (isArrowHere(d, kind) && !faces(c_, kind, d)) return true;
    return false;
  }
  /// Returns true if an excited arrow of this kind or a confluent cell sends a signal to the cell.
  [[nodiscard]] bool hit(Kind kind) const {
    for (int d = 0; d < 4; ++d)
      if ((isArrowHere(d, kind) || emits(at(d), d)) && !faces(c_, kind, d)) return true;
    return false;
  }
  [[nodiscard]] bool isArrowHere(int d, Kind kind) const {
    return kindOf(at(d)) == kind && isExcited(at(d)) && pointsHere(at(d), d);
  }
  [[nodiscard]] int at(int direction) const { return around_[static_cast<std::size_t>(direction)]; }
  /// Returns the state of the cell to which this arrow points.
  [[nodiscard]] int output() const { return at(directionOf(c_)); }
  /// Returns the state of the excited arrow that points to this cell, or 0 if none exists.
  [[nodiscard]] int input() const {
    for (const int d : {2, 3, 0, 1})
      if (isExcited(at(d)) && pointsHere(at(d), d)) return at(d);
    return 0;
  }
  [[nodiscard]] bool outputBecomesOrdinary() const {
    return output() == 8 || output() == (isExcited(c_) ? 4 : 5);
  }
  [[nodiscard]] bool outputBecomesConfluent() const { return output() == 7 && isExcited(c_); }
  [[nodiscard]] bool outputBecomesSensitized() const {
    const int out = output();
    return (out == 0 && isExcited(c_)) || (out >= 1 && out <= 3) ||
           (out == 4 && kindOf(c_) != Kind::ordinary);
  }

  [[nodiscard]] int ordinary() const {
    if (arrow(Kind::special)) return 0;
    if (hit(Kind::ordinary)) {
      const bool onSpecial = kindOf(output()) == Kind::special && !isExcited(output());
      if (outputBecomesOrdinary() || onSpecial) return 0;  // The end of the wire is retracted.
      return outputBecomesConfluent() ? 1 : excited(c_);
    }
    if (outputBecomesConfluent()) return 0;
    // An excited special arrow marks the end of a wire while it writes.
    if (isExcited(c_) && outputBecomesSensitized()) return excited(arrowOf(Kind::special, directionOf(c_)));
    return quiet(c_);
  }

  [[nodiscard]] int special() const {
    const bool onWire = in_.ordinary || in_.quietOrdinary;
    if (isExcited(c_) && kindOf(output()) == Kind::sensitized && onWire) {
      const bool one = arrow(Kind::ordinary);
      if (outputBecomesSensitized()) return one ? excited(arrowOf(Kind::ordinary, directionOf(c_))) : c_;
      return one ? 0 : arrowOf(Kind::ordinary, directionOf(c_));
    }
    if (isExcited(c_) && output() == 0) return arrow(Kind::special) ? c_ : quiet(c_);
    if (arrow(Kind::ordinary)) return 0;
    return hit(Kind::special) ? excited(c_) : quiet(c_);
  }

  /// The direction of the new arrow is relative to the arrow that writes it. Cases without such an arrow do
  /// not occur in machines; their results equal Golly's.
  [[nodiscard]] int sensitized() const {
    const bool one = arrow(Kind::ordinary);
    if (c_ < 4) return 2 * c_ + (one ? 1 : 0);
    if (c_ == 4 && !one) return 8;
    if (c_ == 7 && one) return firstConfluent;
    const int from = input();
    if (from == 0) {
      constexpr std::array<int, 4> withoutInput = {7, 17, 15, 8};
      return withoutInput[static_cast<std::size_t>(c_ - 5)];
    }
    const int direction = directionOf(from);
    switch (c_) {
      case 4:
        return arrowOf(Kind::ordinary, direction + 2);
      case 5:
        return one ? quiet(from) + 8 : arrowOf(Kind::ordinary, direction + 3);
      case 6:
        return arrowOf(Kind::special, direction + (one ? 2 : 1));
      case 7:
        return arrowOf(Kind::special, direction + 3);
      default:
        return arrowOf(Kind::ordinary, direction + (one ? 1 : 0));
    }
  }

  [[nodiscard]] int confluent() const {
    if (arrow(Kind::special)) return 0;
    if (c_ >= alongX) return in_.crossing();
    if (c_ == firstConfluent) {
      int entered = 0, left = 0;
      for (int d = 0; d < 4; ++d)
        if (isArrow(at(d))) ++(pointsHere(at(d), d) ? entered : left);
      if (entered == 2 && left == 2) return in_.crossing();
    }
    return confluentAfter(c_, in_.ordinary && !in_.quietOrdinary);
  }

  int c_;
  const Around& around_;
  Inputs in_;
};

/// Builds the decision diagram of a rule. Neighbour states that no rule distinguishes are in one class.
class SignalTree {
 public:
  explicit SignalTree(SignalRule rule) : rule_(rule), states_(statesOf(rule)) {
    for (int d = 0; d < 4; ++d)
      for (int state = 0; state < states_; ++state)
        classes_[static_cast<std::size_t>(d)].push_back(classOf(state, d));
  }

  std::shared_ptr<const RuleTree> build() {
    tree_->neighbours = 4;
    Around around{};
    tree_->root = node(0, around);
    return std::move(tree_);
  }

 private:
  using Children = std::vector<std::uint32_t>;

  static int classOf(int state, int direction) {
    if (!isArrow(state)) return state;
    return firstArrow + (kindOf(state) == Kind::special ? 4 : 0) + (isExcited(state) ? 2 : 0) +
           (pointsHere(state, direction) ? 1 : 0);
  }

  std::uint32_t node(std::size_t depth, Around& around) {
    constexpr std::array<std::size_t, 4> order = {1, 2, 0, 3};  // north, west, east, south
    Children children;
    if (depth == order.size()) {
      for (int middle = 0; middle < states_; ++middle)
        children.push_back(static_cast<std::uint32_t>(signalOutcome(rule_, middle, around)));
    } else {
      std::map<int, std::uint32_t> known;
      const std::size_t direction = order[depth];
      for (int state = 0; state < states_; ++state) {
        const int one = classes_[direction][static_cast<std::size_t>(state)];
        auto found = known.find(one);
        if (found == known.end()) {
          around[direction] = state;
          found = known.emplace(one, node(depth + 1, around)).first;
        }
        children.push_back(found->second);
      }
    }
    const auto [at, fresh] =
        unique_[depth].try_emplace(children, static_cast<std::uint32_t>(tree_->items.size()));
    if (fresh) tree_->items.insert(tree_->items.end(), children.begin(), children.end());
    return at->second;
  }

  SignalRule rule_;
  int states_;
  std::array<std::vector<int>, 4> classes_;
  std::array<std::map<Children, std::uint32_t>, 5> unique_;
  std::shared_ptr<RuleTree> tree_ = std::make_shared<RuleTree>();
};

}  // namespace

int statesOf(SignalRule rule) {
  return rule == SignalRule::jvn29 ? 29 : 32;
}

int signalOutcome(SignalRule rule, int middle, const std::array<int, 4>& around) {
  if (rule == SignalRule::hutton32) return HuttonCell(middle, around).outcome();
  return neumannOutcome(rule == SignalRule::nobili32, middle, around);
}

std::shared_ptr<const RuleTree> signalTree(SignalRule rule) {
  static std::mutex mutex;
  static std::array<std::shared_ptr<const RuleTree>, 3> trees;
  const std::scoped_lock lock(mutex);
  auto& tree = trees[static_cast<std::size_t>(rule)];
  if (tree == nullptr) tree = SignalTree(rule).build();
  return tree;
}

std::vector<glm::vec3> signalColors(SignalRule rule) {
  std::vector<glm::vec3> colors;
  for (int state = 0; state < statesOf(rule); ++state) {
    const Kind kind = kindOf(state);
    const float turn = 0.12F * static_cast<float>(isArrow(state) ? directionOf(state) : 0);
    const bool bright = isExcited(state) || state > firstConfluent;
    colors.push_back(
        kind == Kind::ground       ? glm::vec3(0.004F, 0.006F, 0.012F)
        : kind == Kind::sensitized ? glm::vec3(0.25F + 0.08F * static_cast<float>(state), 0.03F, 0.06F)
        : kind == Kind::ordinary
            ? (bright ? glm::vec3(0.35F, 0.75F, 1) : glm::vec3(0.03F, 0.09F + turn * 0.3F, 0.35F))
        : kind == Kind::special
            ? (bright ? glm::vec3(0.6F, 1, 0.3F) : glm::vec3(0.03F, 0.25F, 0.08F + turn * 0.3F))
        : bright ? glm::vec3(1, 0.85F, 0.25F)
                 : glm::vec3(0.45F, 0.3F, 0.02F));
  }
  return colors;
}

}  // namespace simreel::sim
