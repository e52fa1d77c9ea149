#include "app/crack_tables.hpp"

#include "core/experiment/crack_entries.hpp"
#include "core/measurement/fragments.hpp"
#include "core/output/run_tables.hpp"

namespace asperity::app {

void write_crack_tables(const RunFolder& folder, const Model& model) {
  const std::vector<Crack> cracks = run_cracks(model);
  const std::vector<double> areas = find_fragments(model.system.contacts, model.system.particles).area_mm2;
  std::vector<std::vector<CsvCell>> crack_rows, event_rows, fragment_rows;
  for (const Crack& crack : cracks) crack_rows.push_back(crack_row(crack));
  for (const AcousticEvent& event : group_events(cracks, model.config)) event_rows.push_back(event_row(event));
  for (std::size_t i = 0; i < areas.size(); ++i) fragment_rows.push_back(fragment_row(i, areas[i]));
  write_csv(folder.crack_table(), crack_columns(), crack_rows);
  write_csv(folder.events(), event_columns(), event_rows);
  write_csv(folder.fragments(), fragment_columns(), fragment_rows);
}

}  // namespace asperity::app
