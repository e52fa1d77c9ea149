#pragma once

namespace asperity::app {

/// From now on SIGINT and SIGTERM only set a flag, so that a run can end at a step's end.
void install_interruption_handlers();

/// Whether one of the two signals has come.
bool interruption_requested();

}  // namespace asperity::app
