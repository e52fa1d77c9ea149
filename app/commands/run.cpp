#include "app/commands/commands.hpp"
#include "app/interruption.hpp"
#include "app/run_session.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/log.hpp"
#include "core/config/read_config.hpp"

namespace asperity::app {

int run_command(const RunOptions& options) {
  install_interruption_handlers();
  if (options.quiet) set_log_echo(LogEcho::errors);
  const RunConfig config = read_run_config(options.config, options.overrides);
  const std::filesystem::path root = options.out.value_or(default_run_folder(config.name));
  return run_from_start(config, read_file(options.config), root,
                        options.force ? ExistingRun::replace : ExistingRun::keep,
                        {options.threads, options.render, options.quiet});
}

int resume_command(const ResumeOptions& options) {
  install_interruption_handlers();
  if (options.quiet) set_log_echo(LogEcho::errors);
  return resume_run(options.run_dir, {options.threads, options.render, options.quiet});
}

}  // namespace asperity::app
