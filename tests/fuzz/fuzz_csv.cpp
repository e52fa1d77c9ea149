#include "core/base/error.hpp"
#include "core/output/csv.hpp"
#include "tests/fuzz/harness.hpp"

using namespace asperity;

namespace {

void read_numbers(const CsvData& data, const std::string& name) {
  try {
    fuzz::require(data.numbers(name).size() == data.rows(), "a column has a number for every row");
  } catch (const Error& error) {
    fuzz::require(error.kind() == ErrorKind::config, "a cell that is no number is a fault of the data");
  }
}

}  // namespace

/// The bytes of a CSV file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const CsvData table = parse_csv(fuzz::text_of(data, size), "input.csv");
    fuzz::require(!table.names().empty(), "a table has columns");
    for (const std::string& name : table.names()) {
      fuzz::require(table.words(name).size() == table.rows(), "a column has a word for every row");
      read_numbers(table, name);
    }
  } catch (const Error& error) {
    fuzz::require(error.kind() == ErrorKind::config, "a refusal is a fault of the data");
  }
  return 0;
}
