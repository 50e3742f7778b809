#pragma once
#include "kernels/guards/place.hpp"
#include "kernels/shader/shader.hpp"
#include "kernels/spirv/module.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace simreel::kernels {

/// The storage block of reports.
inline constexpr const char* reportBlock = "simreel_Report";

/// The places where a kernel can do what it must not, and the code that notes it. An invocation keeps the
/// first of its faults in private variables, at the cost of a comparison for each access, and adds it to
/// the block at its end.
/// (llvmpipe runs both sides of every branch: atomic operations at each access would cost much.)
class Report {
 public:
  explicit Report(const Files& files) : files_(files) {}
  [[nodiscard]] const Files& files() const { return files_; }

  /// The number of a place, one for each kind, name, part and line. The name is the user's.
  std::uint32_t place(const char* kind, const std::string& what, const Position& at,
                      const std::string& part = {});
  /// Appends to `body` a call that notes a fault unless `fine`, with the numbers for the words 2 and 3 of
  /// Kernel::places; numbers of either sign.
  void note(Module& module, std::vector<Instruction>& body, Id fine, std::uint32_t place, Id least,
            Id greatest);
  /// The same at a place whose number is a value.
  void noteAt(Module& module, std::vector<Instruction>& body, Id fine, Id place, Id least, Id greatest);
  /// Makes a module with calls of note() one that SPIRV-Tools may work on, before more calls are added to
  /// what it makes.
  void hold(Module& module);
  /// A function that runs before the kernel.
  void beginWith(Id function) { begin_ = function; }
  /// Appends the functions, the block and an entry point that runs the kernel and then adds its fault.
  void complete(Module& module);
  [[nodiscard]] const std::vector<Place>& places() const { return places_; }

 private:
  Id function(Module& module);
  void writeNote(Module& module, Id function, const Words& kept);
  void writeTell(Module& module, Id function, const Words& kept);
  void enter(Module& module, Id tell) const;

  const Files& files_;
  std::vector<Place> places_;
  const Module* known_ = nullptr;  ///< the module that function_ is of
  Id function_ = 0, begin_ = 0;
};

/// The number of the running invocation in the whole dispatch: x first, then y, then z.
[[nodiscard]] Id linearInvocation(Module& module, std::vector<Instruction>& body);
/// The same of another invocation of its group, by its number there.
[[nodiscard]] Id linearInvocation(Module& module, std::vector<Instruction>& body, Id local);

}  // namespace simreel::kernels
