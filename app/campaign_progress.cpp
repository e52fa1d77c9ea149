#include "app/campaign_progress.hpp"

#include <fmt/format.h>

#include <utility>

namespace asperity {

CampaignProgressLine::CampaignProgressLine(std::string name, ProgressStyle style, std::ostream& err,
                                           ProgressClock clock)
    : name_(std::move(name)), line_(style, err, std::move(clock)), start_(line_.seconds()) {}

void CampaignProgressLine::update(const CampaignProgress& progress) {
  last_ = progress;
  line_.update(progress.fraction, [&] { return text(progress); });
}

void CampaignProgressLine::finish() {
  line_.finish(last_.fraction, [&] { return text(last_); });
}

std::string CampaignProgressLine::text(const CampaignProgress& p) const {
  std::string text = fmt::format("{} {:3} %  {} of {} runs, {} running, {} failed, {} reused", name_,
                                 percent_of(p.fraction), p.done, p.runs, p.running, p.failed, p.reused);
  if (p.done == p.runs) return text + "  took " + duration_text(line_.seconds() - start_);
  return p.left_s ? text + "  ETA " + duration_text(*p.left_s) : text;
}

}  // namespace asperity
