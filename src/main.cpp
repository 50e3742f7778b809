#include "cli/commands.hpp"

int main(int argc, char** argv) {
  simreel::cli::explainTermination();
  return simreel::cli::run(argc, argv);
}
