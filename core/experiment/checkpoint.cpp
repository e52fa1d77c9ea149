#include "core/experiment/checkpoint.hpp"

#include <array>
#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/base/sha256.hpp"
#include "core/experiment/checkpoint_checks.hpp"

namespace asperity {
namespace {

constexpr std::string_view kMagic = "asperity checkpoint 10\n";
constexpr std::size_t kDigest = 64;

/// Appends plain values and vectors of them to a byte string, each with its size, so that other code's layout is seen.
class Writer {
 public:
  template <class T>
  void operator()(const T& value) {
    put(&value, sizeof value, 1);
  }
  template <class T>
  void operator()(const std::vector<T>& values) {
    put(values.data(), sizeof(T), values.size());
  }
  const std::string& bytes() const { return bytes_; }

 private:
  template <class T>
  void put(const T* values, std::size_t size, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    for (const std::size_t number : {size, count}) bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
    bytes_.append(reinterpret_cast<const char*>(values), count * size);
  }
  std::string bytes_;
};

/// Takes them back in the same order; throws std::runtime_error where the bytes are not those of the same members.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}
  template <class T>
  void operator()(T& value) {
    if (take_count(sizeof value) != 1) throw std::runtime_error("holds a list where one value is expected");
    take(&value, sizeof value);
  }
  template <class T>
  void operator()(std::vector<T>& values) {
    const std::size_t count = take_count(sizeof(T));
    if (count > bytes_.size() / sizeof(T)) throw std::runtime_error("ends early");
    values.resize(count);
    take(values.data(), count * sizeof(T));
  }
  bool at_end() const { return bytes_.empty(); }

 private:
  std::size_t take_count(std::size_t expected_size) {
    std::array<std::size_t, 2> head{};
    take(head.data(), sizeof head);
    if (head[0] != expected_size) throw std::runtime_error("was written by other code");
    return head[1];
  }
  void take(void* to, std::size_t size) {
    if (size > bytes_.size()) throw std::runtime_error("ends early");
    if (size > 0) std::memcpy(to, bytes_.data(), size);  // an empty vector has no address to copy to
    bytes_.remove_prefix(size);
  }
  std::string_view bytes_;
};

/// Members and pairs are those of the last search, so they cannot be found again from the present state.
template <class Archive, class General>
void exchange_general(Archive& archive, General& general) {
  archive(general.members);
  archive(general.pairs);
  archive(general.chain_contacts);
  archive(general.handing_over);
  archive(general.touches);
  archive(general.wear);
  archive(general.travel);
  archive(general.search_due);
  archive(general.searches);
  archive(general.friction_energy);
  archive(general.damping_energy);
  archive(general.largest_depth);
  archive(general.largest_depth_handing_over);
  archive(general.largest_seat);
}

template <class Archive, class Block>
void exchange_block(Archive& archive, Block& block) {
  archive(block.load);
  archive(block.velocity);
  archive(block.last_velocity);
  archive(block.reaction);
  archive(block.displacement);
  archive(block.turn.angle);
  archive(block.turn.rate);
  archive(block.turn.last_rate);
}

/// Everything that changes while a test runs, in one order for writing and reading.
template <class Archive, class SystemType, class StateType>
void exchange(Archive& archive, SystemType& system, StateType& state) {
  archive(system.time);
  archive(system.step);
  archive(system.initial_kinetic);
  archive(system.external_work);
  archive(system.damping_energy);
  archive(system.platen_friction_energy);
  archive(system.sums);
  archive(system.platens);
  archive(system.lines);
  for (auto& block : system.blocks) exchange_block(archive, block);
  archive(system.flank.pressure);
  archive(system.flank.edges);
  archive(system.platen_shear);
  archive(system.particles.position);
  archive(system.particles.velocity);
  archive(system.particles.plasticity);
  archive(system.contacts.memory.packed);
  archive(system.contacts.memory.literal);
  archive(system.contacts.broken_index);
  archive(system.contacts.broken);
  exchange_general(archive, system.general);
  archive(state.loading);
  archive(state.samples);
  archive(state.reaction_sum);
  archive(state.steps_in_sample);
  archive(state.stages_sampled);
  archive(state.frames);
  archive(state.next_frame_strain);
  archive(state.kinetic_ratio);
  archive(state.samples_below);
}

/// A checkpoint always belongs to a run that goes on or has ended by its stop rule.
StopReason stop_to_keep(const RunState& state) {
  return state.stop == StopReason::interrupted ? StopReason::running : state.stop;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw Error(ErrorKind::output, {{file.string(), why, "", "", "start the run again with `asperity run`"}});
}

/// The state's bytes, once version, checksum and configuration are found right.
std::string_view checked_body(std::string_view bytes, const std::filesystem::path& file,
                              const std::string& config_hash) {
  if (!bytes.starts_with(kMagic)) refuse(file, "is no checkpoint of this version");
  bytes.remove_prefix(kMagic.size());
  const std::string_view digest = bytes.substr(0, kDigest);
  const std::string_view body = bytes.substr(digest.size());
  if (sha256_hex(body) != digest) refuse(file, "is damaged: its checksum does not hold");
  if (!body.starts_with(config_hash)) refuse(file, "belongs to another configuration");
  return body.substr(config_hash.size());
}

}  // namespace

std::string checkpoint_bytes(const Model& model, const RunState& state, const std::string& config_hash) {
  Writer writer;
  exchange(writer, model.system, state);
  writer(stop_to_keep(state));
  writer(state.cost);
  const std::string body = config_hash + writer.bytes();
  return std::string(kMagic) + sha256_hex(body) + body;
}

void read_checkpoint_bytes(std::string_view bytes, const std::filesystem::path& file, Model& model, RunState& state,
                           const std::string& config_hash) {
  const std::string_view body = checked_body(bytes, file, config_hash);
  Model restored_model = model;
  RunState restored_state = state;
  try {
    Reader reader(body);
    exchange(reader, restored_model.system, restored_state);
    reader(restored_state.stop);
    reader(restored_state.cost);
    if (!reader.at_end()) throw std::runtime_error("is longer than its state");
  } catch (const std::runtime_error& failure) {
    refuse(file, failure.what());
  }
  const std::string why = contradiction(model, restored_model.system, restored_state);
  if (!why.empty()) refuse(file, why);
  model = std::move(restored_model);
  state = std::move(restored_state);
}

void write_checkpoint(const std::filesystem::path& file, const Model& model, const RunState& state,
                      const std::string& config_hash) {
  write_file_atomically(file, checkpoint_bytes(model, state, config_hash));
}

void read_checkpoint(const std::filesystem::path& file, Model& model, RunState& state, const std::string& config_hash) {
  read_checkpoint_bytes(read_file(file), file, model, state, config_hash);
}

}  // namespace asperity
