#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::serve {

/// 32 hexadecimal digits from the system's source of randomness. Throws UserError(inputOutput).
[[nodiscard]] std::string randomToken();

/// Who may talk to the server. A page of somebody else's in the same browser can send requests here, but
/// knows neither the token nor may it say another origin than its own; a name of theirs that leads to this
/// machine (DNS rebinding) shows in the Host header.
class Guard {
 public:
  /// `address`: that the server listens at, an IP address.
  Guard(std::string token, std::string address);

  [[nodiscard]] const std::string& token() const { return token_; }
  /// Of a Host header, "127.0.0.1:8000": a name of this machine by itself, or an IP address where the
  /// server listens at more than its own.
  [[nodiscard]] bool allowsHost(std::string_view host) const;
  /// Of an Origin header beside that Host header: the page came from here.
  [[nodiscard]] static bool allowsOrigin(std::string_view origin, std::string_view host);
  /// What follows "/TOKEN/" in a path; false where it does not begin so. The time it takes says nothing of
  /// how much of the token is right.
  [[nodiscard]] bool splitPath(std::string_view path, std::string_view& rest) const;

 private:
  std::string token_;
  bool everywhere_;  ///< whether other machines reach it
};

/// What to print: the address for a browser here, and how to get there from elsewhere.
[[nodiscard]] std::string pageAddress(const std::string& address, int port, const std::string& token);
[[nodiscard]] std::string tunnelCommand(const std::string& address, int port, const std::string& machine);

}  // namespace simreel::serve
