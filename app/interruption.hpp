#pragma once

namespace asperity::app {

/// From now on SIGINT and SIGTERM only set a flag, so that a run can end at a step's end, and a file above the
/// size limit is an error of its write.
void install_interruption_handlers();

/// Whether one of the two signals has come.
bool interruption_requested();

}  // namespace asperity::app
