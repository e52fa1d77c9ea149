#include "app/interruption.hpp"

#include <csignal>

namespace asperity::app {
namespace {

volatile std::sig_atomic_t requested = 0;

extern "C" void request_interruption(int) { requested = 1; }

}  // namespace

void install_interruption_handlers() {
  std::signal(SIGINT, request_interruption);
  std::signal(SIGTERM, request_interruption);
}

bool interruption_requested() { return requested != 0; }

}  // namespace asperity::app
