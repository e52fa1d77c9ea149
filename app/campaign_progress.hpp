#pragma once
#include <iosfwd>
#include <optional>
#include <string>

#include "app/progress_line.hpp"
#include "core/campaign/campaign_progress.hpp"

namespace asperity {

/// Shows how a campaign goes on: %, runs done, at work, failed and re-used, and the time left.
class CampaignProgressLine {
 public:
  /// `name` stands first on the line. `err` must outlive this. `clock` unset: the steady clock.
  CampaignProgressLine(std::string name, ProgressStyle style, std::ostream& err, ProgressClock clock = {});

  /// For CampaignOptions::on_progress; cheap to call.
  void update(const CampaignProgress& progress);

  /// Shows how the campaign stands now that it has returned, and ends the line.
  void finish();

 private:
  std::string text(const CampaignProgress& progress) const;
  std::string name_;
  ProgressLine line_;
  double start_;
  CampaignProgress last_;
};

}  // namespace asperity
