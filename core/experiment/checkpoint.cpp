#include "core/experiment/checkpoint.hpp"

#include <cstring>
#include <type_traits>

#include "core/base/error.hpp"
#include "core/base/sha256.hpp"
#include "core/output/atomic_file.hpp"

namespace asperity {
namespace {

constexpr const char* kMagic = "asperity checkpoint 2\n";
constexpr std::size_t kDigest = 64;

/// Appends plain values and vectors of them to a byte string.
class Writer {
 public:
  template <class T>
  void operator()(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void operator()(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    (*this)(values.size());
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Takes them back in the same order. The bytes have passed their checksum, so only a change of the code can end early.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}
  template <class T>
  void operator()(T& value) {
    take(&value, sizeof value);
  }
  template <class T>
  void operator()(std::vector<T>& values) {
    std::size_t size = 0;
    (*this)(size);
    if (size > bytes_.size() / sizeof(T)) throw Error(ErrorKind::output, "the checkpoint ends early");
    values.resize(size);
    take(values.data(), size * sizeof(T));
  }

 private:
  void take(void* to, std::size_t size) {
    if (size > bytes_.size()) throw Error(ErrorKind::output, "the checkpoint ends early");
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
  archive(general.travel);
  archive(general.search_due);
  archive(general.searches);
  archive(general.friction_energy);
  archive(general.damping_energy);
  archive(general.largest_depth);
  archive(general.largest_depth_handing_over);
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
  archive(system.flank.pressure);
  archive(system.flank.edges);
  archive(system.platen_shear);
  archive(system.particles.position);
  archive(system.particles.velocity);
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

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw Error(ErrorKind::output, {{file.string(), why, "", "", "start the run again with `asperity run --force`"}});
}

}  // namespace

void write_checkpoint(const std::filesystem::path& file, const Model& model, const RunState& state,
                      const std::string& config_hash) {
  Writer writer;
  exchange(writer, model.system, state);
  const std::string body = config_hash + writer.bytes();
  write_file_atomically(file, kMagic + sha256_hex(body) + body);
}

void read_checkpoint(const std::filesystem::path& file, Model& model, RunState& state, const std::string& config_hash) {
  const std::string text = read_file(file);
  const std::size_t head = std::strlen(kMagic);
  if (text.size() < head + kDigest + config_hash.size() || !text.starts_with(kMagic))
    refuse(file, "is no checkpoint of this version");
  const std::string_view body = std::string_view(text).substr(head + kDigest);
  if (sha256_hex(body) != text.substr(head, kDigest)) refuse(file, "is damaged: its checksum does not hold");
  if (!body.starts_with(config_hash)) refuse(file, "belongs to another configuration");
  Model restored_model = model;
  RunState restored_state = state;
  Reader reader(body.substr(config_hash.size()));
  exchange(reader, restored_model.system, restored_state);
  model = std::move(restored_model);
  state = std::move(restored_state);
}

}  // namespace asperity
