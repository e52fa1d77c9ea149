#include <algorithm>
#include <cstring>

#include "core/base/error.hpp"
#include "core/experiment/checkpoint.hpp"
#include "core/experiment/summarise.hpp"
#include "core/measurement/crack_network.hpp"
#include "tests/fuzz/harness.hpp"
#include "tests/fuzz/small_run.hpp"

using namespace asperity;

namespace {

constexpr std::size_t kEdit = 11;
constexpr int kSteps = 3;

/// One change of the file: its first byte says which, the next two where, the other eight are the value.
void edit(std::string& bytes, const char* record) {
  std::uint16_t place16 = 0;
  std::memcpy(&place16, record + 1, sizeof place16);
  const std::size_t place = place16 % (bytes.size() + 1);
  const std::size_t rest = bytes.size() - place;
  const char* value = record + 3;
  switch (static_cast<unsigned char>(record[0]) % 5) {
    case 0:
      bytes.replace(place, std::min<std::size_t>(rest, 8), value, std::min<std::size_t>(rest, 8));
      break;
    case 1:
      bytes.replace(place, std::min<std::size_t>(rest, 4), value, std::min<std::size_t>(rest, 4));
      break;
    case 2:
      bytes.replace(place, std::min<std::size_t>(rest, 1), value, std::min<std::size_t>(rest, 1));
      break;
    case 3:
      bytes.resize(place);
      break;
    default:
      bytes.insert(place, value, 8);
  }
}

void go_on_and_tell(Model& model, RunState& state) {
  fuzz::go_on(model, state, kSteps);
  list_cracks(model.system.contacts, model.system.particles);
  summarise(model, state);
}

}  // namespace

/// Makes the run, so that no input is charged with its time.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  fuzz::small_run();
  return 0;
}

/// Changes of a real checkpoint, which the harness makes itself and seals again with the right checksum (a first byte
/// with bit 1: leaves the old one), so that the inputs outlive changes of the format and lead behind the checksum.
/// Where the reader accepts the file, the test goes on; with bit 2 of the first byte from a new search of pairs.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const fuzz::SmallRun& run = fuzz::small_run();
  static const std::string whole = checkpoint_bytes(run.model, run.state, fuzz::small_hash());
  std::string bytes = whole;
  for (std::size_t i = 1; i + kEdit <= size; i += kEdit) edit(bytes, reinterpret_cast<const char*>(data) + i);
  if ((data[0] & 1) == 0) bytes = fuzz::sealed(std::move(bytes));
  Model model = run.fresh;
  RunState state;
  try {
    read_checkpoint_bytes(bytes, "state.bin", model, state, fuzz::small_hash());
    if ((data[0] & 2) != 0) model.system.general.search_due = 1;
    go_on_and_tell(model, state);
  } catch (const Error& error) {
    const bool told = error.kind() == ErrorKind::output || error.kind() == ErrorKind::numerical;
    fuzz::require(told, "a refusal is an output error, a state that cannot go on a numerical one");
  }
  return 0;
}
