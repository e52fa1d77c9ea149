#include "app/confrontation/confrontation_report.hpp"

#include <fmt/format.h>

#include "app/confrontation/confrontation_chapters.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/build_info.hpp"
#include "core/base/error.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

void require_shown(const fs::path& folder) {
  if (fs::exists(folder / "shown.json")) return;
  throw Error(ErrorKind::config, {{(folder / "shown.json").string(), "is missing, so no report can be made", "", "",
                                   "`asperity confront` without --no-report writes it"}});
}

std::vector<Chapter> chapters(const ConfrontationData& data) {
  std::vector<Chapter> all;
  for (const auto part : {verdict_chapter, wrong_chapter, curves_chapter, cause_chapter, gain_chapter, patterns_chapter,
                          limits_chapter, next_chapter, assumptions_chapter, provenance_chapter}) {
    Chapter chapter = part(data);
    if (!chapter.blocks.empty()) all.push_back(std::move(chapter));
  }
  return all;
}

std::string title_of(const ConfrontationData& data) { return "Confrontation " + data.shown["setting"]["name"].text(); }

std::string subtitle_of(const ConfrontationData& data) {
  const Value setting = data.shown["setting"];
  std::string text = fmt::format("{} tests of {}", data.tests.size(), setting["measured"].text());
  if (const std::string description = setting["description"].text(); !description.empty()) text += ". " + description;
  return text;
}

std::string foot() {
  return "Page made by Asperity " + std::string(build_info().version) + ", revision " + build_info().revision + ".";
}

std::string page_of(const ConfrontationData& data, const std::vector<Chapter>& all) {
  html::Page page{title_of(data), subtitle_of(data), {}, {}, foot()};
  for (const Note& note : verdict_alarms(data)) page.lead.push_back(markup_of(note));
  for (const Chapter& chapter : all) page.sections.push_back(section_of(chapter));
  return html::document(page);
}

std::string markdown_page(const ConfrontationData& data, const std::vector<Chapter>& all) {
  std::string text = "# " + title_of(data) + "\n\n" + markdown_of(Block(Paragraph{subtitle_of(data)}));
  for (const Note& note : verdict_alarms(data)) text += "\n" + markdown_of(Block(note));
  for (const Chapter& chapter : all) text += "\n" + markdown_of(chapter);
  return text + "\n" + markdown_of(Block(Paragraph{foot()}));
}

}  // namespace

bool is_confrontation_folder(const fs::path& folder) { return fs::exists(folder / "verdict.json"); }

fs::path write_confrontation_report(const fs::path& folder) {
  require_shown(folder);
  const Document verdict(folder / "verdict.json"), shown(folder / "shown.json"), manifest(folder / "manifest.json");
  const ConfrontationData data = confrontation_data(folder, verdict.root(), shown.root(), manifest.root());
  const std::vector<Chapter> all = chapters(data);
  write_file_atomically(folder / "report.md", markdown_page(data, all));
  const fs::path report = folder / "report.html";
  write_file_atomically(report, page_of(data, all));
  return report;
}

}  // namespace asperity::app
