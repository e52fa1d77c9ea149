#include "core/base/log.hpp"

#include <spdlog/logger.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <mutex>

#include "core/base/build_info.hpp"
#include "core/base/error.hpp"

namespace asperity {
namespace {

/// "warning: text" on stderr; on a terminal it first wipes the line that progress rewrites.
class StderrSink : public spdlog::sinks::base_sink<std::mutex> {
 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    if (isatty(STDERR_FILENO) != 0) std::fputs("\r\033[K", stderr);
    const auto level = spdlog::level::to_string_view(message.level);
    const std::string_view text(message.payload.data(), message.payload.size());
    std::fprintf(stderr, "%.*s: %.*s\n", static_cast<int>(level.size()), level.data(), static_cast<int>(text.size()),
                 text.data());
  }
  void flush_() override { std::fflush(stderr); }
};

struct Log {
  std::shared_ptr<StderrSink> echo = std::make_shared<StderrSink>();
  spdlog::logger logger{"asperity", echo};
  Log() {
    echo->set_level(spdlog::level::warn);
    logger.flush_on(spdlog::level::info);
    logger.set_error_handler([](const std::string&) {});  // a full disk is told by the files that matter
  }
};

Log& the_log() {
  static Log log;
  return log;
}

std::string header(const std::map<std::string, std::string>& libraries) {
  const BuildInfo& build = build_info();
  std::string text = "Asperity " + build.version + ", revision " + build.revision +
                     (build.dirty ? " with changed files" : "") + ", " + build.build_type + ", " + build.compiler +
                     "; libraries:";
  for (const auto& [name, version] : libraries) text += " " + name + " " + version;
  return text;
}

}  // namespace

void set_log_echo(LogEcho echo) {
  the_log().echo->set_level(echo == LogEcho::warnings ? spdlog::level::warn : spdlog::level::err);
}

void open_log_file(const std::filesystem::path& path, const std::map<std::string, std::string>& libraries) {
  close_log_file();
  try {
    auto file = std::make_shared<spdlog::sinks::basic_file_sink_mt>(path.string());
    file->set_formatter(
        std::make_unique<spdlog::pattern_formatter>("%Y-%m-%dT%H:%M:%S.%eZ %l: %v", spdlog::pattern_time_type::utc));
    the_log().logger.sinks().push_back(std::move(file));
  } catch (const spdlog::spdlog_ex& failure) {
    throw Error(ErrorKind::output, {{path.string(), std::string("cannot be written: ") + failure.what(), "", "",
                                     "choose another folder with --out"}});
  }
  log_info(header(libraries));
}

void close_log_file() { the_log().logger.sinks().resize(1); }

void log_info(std::string_view message) { the_log().logger.info("{}", message); }
void log_warning(std::string_view message) { the_log().logger.warn("{}", message); }
void log_error(std::string_view message) { the_log().logger.error("{}", message); }

}  // namespace asperity
