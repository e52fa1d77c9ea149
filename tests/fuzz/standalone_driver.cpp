#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "core/base/random.hpp"
#include "tests/fuzz/harness.hpp"

/// Runs a harness without libFuzzer: every file of the corpus, then random changes of them for some seconds, the same
/// ones in every run. An input on which the process dies is left in crash_HARNESS.
namespace {

namespace fs = std::filesystem;
using asperity::RandomStream;

constexpr std::size_t kLongest = 20000;  // bytes
constexpr unsigned kSlow = 60;           // s for one input: a hang

std::string current;     // what a dying process still has to write
std::string crash_file;  // where to

void save_and_die(int signal) {
  const int file = ::open(crash_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file >= 0 && ::write(file, current.data(), current.size()) >= 0) ::close(file);
  constexpr char kTold[] = "the input that did it was left in crash_*\n";
  if (::write(STDERR_FILENO, kTold, sizeof kTold - 1) < 0) _exit(1);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void run(std::string input) {
  current = std::move(input);
  ::alarm(kSlow);
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(current.data()), current.size());
  ::alarm(0);
}

std::vector<std::string> read_corpus(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> inputs;
  for (const fs::path& file : files) {
    std::ifstream stream(file, std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return inputs;
}

/// Replaces, takes out, doubles or brings in from another input a few bytes.
void change(std::string& input, const std::string& other, RandomStream& random) {
  const std::size_t place = random.below(input.size() + 1);
  const std::size_t length = std::min(input.size() - place, 1 + random.below(16));
  switch (random.below(5)) {
    case 0:
      for (std::size_t i = 0; i < length; ++i) input[place + i] = static_cast<char>(random.below(256));
      break;
    case 1:
      input.erase(place, length);
      break;
    case 2:
      input.insert(place, input.substr(place, length));
      break;
    case 3:
      if (length > 0) input[place] = static_cast<char>(input[place] ^ (1 << random.below(8)));
      break;
    default:
      const std::size_t from = random.below(other.size() + 1);
      input.insert(place, other.substr(from, 1 + random.below(64)));
  }
}

std::string changed(const std::vector<std::string>& corpus, RandomStream& random) {
  std::string input = corpus[random.below(corpus.size())];
  const std::size_t times = 1 + random.below(4);
  for (std::size_t i = 0; i < times; ++i) change(input, corpus[random.below(corpus.size())], random);
  if (input.size() > kLongest) input.resize(kLongest);
  return input;
}

std::size_t mutate(const std::vector<std::string>& corpus, double seconds) {
  RandomStream random(1, "fuzz driver");
  const auto start = std::chrono::steady_clock::now();
  const auto spent = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  std::size_t runs = 0;
  for (; spent() < seconds; ++runs) run(changed(corpus, random));
  return runs;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: " << argv[0] << " CORPUS_FOLDER SECONDS\n";
    return 2;
  }
  crash_file = "crash_" + fs::path(argv[0]).filename().string();
  for (int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM}) std::signal(signal, save_and_die);
  const std::vector<std::string> corpus = read_corpus(argv[1]);
  if (corpus.empty()) {
    std::cerr << argv[1] << " holds no inputs\n";
    return 2;
  }
  if (LLVMFuzzerInitialize != nullptr) LLVMFuzzerInitialize(&argc, &argv);
  for (const std::string& input : corpus) run(input);
  const std::size_t runs = mutate(corpus, std::atof(argv[2]));
  std::cout << corpus.size() << " inputs of the corpus and " << runs << " changed ones went through\n";
  return 0;
}
