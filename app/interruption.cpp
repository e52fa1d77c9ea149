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
  std::signal(SIGXFSZ, SIG_IGN);  // a file too large for the user's limit is an output error like a full disk
}

bool interruption_requested() { return requested != 0; }

}  // namespace asperity::app
