#pragma once
#include "gl/context.hpp"
#include "serve/play/player.hpp"

#include <string>

namespace simreel::serve {

struct ServeOptions {
  PlayerOptions player;
  std::string address = "127.0.0.1";  ///< IP address to listen at
  int port = 0;                       ///< 0: any that is free
  std::string token;                  ///< empty: a new one
};

/// Shows the scene until a signal ends it. Prints where. Returns the signal. Throws UserError.
int serveScene(ServeOptions options, const gl::Context& context);

}  // namespace simreel::serve
