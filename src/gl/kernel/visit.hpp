#pragma once
#include <cstddef>
#include <tuple>
#include <type_traits>

/// Functions that visit the members of a plain struct of fields (gl/kernel/fields.hpp), because C++20 has
/// no reflection.
namespace simreel::gl {

template <class T>
concept IsField = requires {
  typename T::Field;
};

/// A type that converts to any member type; used to count the members of an aggregate.
struct AnyField {
  template <class T>
    requires(IsField<T> || std::is_aggregate_v<T>)
  operator T() const;  // NOLINT(google-explicit-constructor): the implicit conversion is the purpose
};

template <class T, class... Members>
concept HasMembers = requires {
  T{Members{}...};
};

template <class T, class... Members>
consteval std::size_t memberCount() {
  if constexpr (HasMembers<T, Members..., AnyField>)
    return memberCount<T, Members..., AnyField>();
  else
    return sizeof...(Members);
}

/// Calls `visit` with each field of `all`, in order. For a nested struct, calls it with each field of the
/// struct.
template <class T, class Visit>
constexpr void visitFields([[maybe_unused]] T& all, [[maybe_unused]] const Visit& visit) {
  constexpr std::size_t count = memberCount<std::remove_const_t<T>>();
  static_assert(count <= 32, "an interface has 32 members at most: put some in a struct");
  [[maybe_unused]] const auto each = [&](auto& member) {
    if constexpr (requires { member.elements; })
      std::apply([&](auto&... elements) { (visit(elements), ...); }, member.elements);
    else if constexpr (IsField<std::remove_cvref_t<decltype(member)>>)
      visit(member);
    else
      visitFields(member, visit);
  };
#define SIMREEL_FIELDS(number, ...)                                        \
  if constexpr (count == (number)) {                                       \
    auto& [__VA_ARGS__] = all;                                             \
    const auto together = [&](auto&... members) { (each(members), ...); }; \
    together(__VA_ARGS__);                                                 \
  }
  // clang-format off
  SIMREEL_FIELDS(1, a0)
  SIMREEL_FIELDS(2, a0, a1)
  SIMREEL_FIELDS(3, a0, a1, a2)
  SIMREEL_FIELDS(4, a0, a1, a2, a3)
  SIMREEL_FIELDS(5, a0, a1, a2, a3, a4)
  SIMREEL_FIELDS(6, a0, a1, a2, a3, a4, a5)
  SIMREEL_FIELDS(7, a0, a1, a2, a3, a4, a5, a6)
  SIMREEL_FIELDS(8, a0, a1, a2, a3, a4, a5, a6, a7)
  SIMREEL_FIELDS(9, a0, a1, a2, a3, a4, a5, a6, a7, a8)
  SIMREEL_FIELDS(10, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9)
  SIMREEL_FIELDS(11, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10)
  SIMREEL_FIELDS(12, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11)
  SIMREEL_FIELDS(13, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12)
  SIMREEL_FIELDS(14, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13)
  SIMREEL_FIELDS(15, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14)
  SIMREEL_FIELDS(16, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15)
  SIMREEL_FIELDS(17, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16)
  SIMREEL_FIELDS(18, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17)
  SIMREEL_FIELDS(19, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18)
  SIMREEL_FIELDS(20, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19)
  SIMREEL_FIELDS(21, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20)
  SIMREEL_FIELDS(22, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21)
  SIMREEL_FIELDS(23, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22)
  SIMREEL_FIELDS(24, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23)
  SIMREEL_FIELDS(25, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23, a24)
  SIMREEL_FIELDS(26, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23, a24, a25)
  SIMREEL_FIELDS(27, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23, a24, a25, a26)
  SIMREEL_FIELDS(28, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23, a24, a25, a26, a27)
  SIMREEL_FIELDS(29, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23, a24, a25, a26, a27, a28)
  SIMREEL_FIELDS(30, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23, a24, a25, a26, a27, a28, a29)
  SIMREEL_FIELDS(31, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23, a24, a25, a26, a27, a28, a29, a30)
  SIMREEL_FIELDS(32, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23, a24, a25, a26, a27, a28, a29, a30, a31)
  // clang-format on
#undef SIMREEL_FIELDS
}

}  // namespace simreel::gl
