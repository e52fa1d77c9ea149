#include "core/campaign/failure_reason.hpp"

#include <fstream>
#include <iterator>
#include <sstream>

namespace asperity {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

}  // namespace

std::string text_from(const std::filesystem::path& file, std::uintmax_t begin) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(begin));
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string last_error(const std::string& printed, int exit_code) {
  const std::string mark = "error: ";
  std::string error, last;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(mark)) error = line.substr(mark.size());
    if (!line.empty()) last = line;
  }
  if (!error.empty()) return error;
  return last.empty() ? "ended with exit code " + std::to_string(exit_code) : last;
}

std::string one_line(std::string text, const std::filesystem::path& store) {
  text = replaced(std::move(text), store.string() + "/", "");
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

}  // namespace asperity
