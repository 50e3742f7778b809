#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::serve {

/// Returns 32 random hexadecimal digits from the operating system. Throws UserError(inputOutput).
[[nodiscard]] std::string randomToken();

/// Decides which requests the server accepts. Another page in the same browser can send requests to this
/// server, but it does not have the token and cannot forge its Origin header. If a foreign host name
/// resolves to this machine (DNS rebinding), the Host header contains that name.
class Guard {
 public:
  /// `address`: IP address that the server listens on.
  Guard(std::string token, std::string address);

  [[nodiscard]] const std::string& token() const { return token_; }
  /// True if the Host header, such as "127.0.0.1:8000", is a name of this machine that works only locally.
  /// If other machines can reach the server, any IP address is also allowed.
  [[nodiscard]] bool allowsHost(std::string_view host) const;
  /// True if the Origin header matches the Host header, so that the page was loaded from this server.
  [[nodiscard]] static bool allowsOrigin(std::string_view origin, std::string_view host);
  /// Returns true if the path begins with "/TOKEN/", and sets `rest` to the part after it. The duration
  /// does not depend on the number of correct characters, so it reveals nothing about the token.
  [[nodiscard]] bool splitPath(std::string_view path, std::string_view& rest) const;

 private:
  std::string token_;
  bool everywhere_;  ///< true if other machines can reach the server
};

/// These functions return texts to print: the page's address for a browser on this machine, and the command
/// that makes the page reachable from another machine.
[[nodiscard]] std::string pageAddress(const std::string& address, int port, const std::string& token);
[[nodiscard]] std::string tunnelCommand(const std::string& address, int port, const std::string& machine);

}  // namespace simreel::serve
