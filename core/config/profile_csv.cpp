#include "core/config/profile_csv.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace asperity {

using nlohmann::json;

namespace {

constexpr std::string_view kHeader = "x_mm,y_mm";
constexpr std::size_t kMostPoints = 256;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r' || text.back() == '\t')) text.remove_suffix(1);
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  return text;
}

std::optional<double> number(std::string_view text) {
  text = trimmed(text);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<json> point(std::string_view line) {
  const std::size_t comma = line.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto x = number(line.substr(0, comma)), y = number(line.substr(comma + 1));
  if (!x || !y) return std::nullopt;
  return json::array({*x, *y});
}

Fault at_line(const std::filesystem::path& file, int line, std::string what, std::string_view text) {
  return {file.string() + ":" + std::to_string(line), std::move(what), std::string(text),
          "the header x_mm,y_mm, then two numbers a line", "one point of the profile a line, x ascending"};
}

/// The points, or what is wrong with the first line that has a fault.
std::vector<Fault> read_points(const std::filesystem::path& file, json& points) {
  std::ifstream in(file);
  if (!in) return {{"/joint/profile_csv", "cannot be read", file.string(), "a CSV file", "check the path"}};
  std::string line;
  int number_of_line = 1;
  if (!std::getline(in, line) || trimmed(line) != kHeader) return {at_line(file, 1, "is no header of a profile", line)};
  while (std::getline(in, line)) {
    ++number_of_line;
    if (trimmed(line).empty()) continue;
    const auto read = point(line);
    if (!read) return {at_line(file, number_of_line, "is no point of a profile", line)};
    points.push_back(*read);
  }
  if (points.size() < 2 || points.size() > kMostPoints) {
    return {{"/joint/profile_csv", "has too few points or too many", std::to_string(points.size()), "2 to 256 points",
             "a profile finer than the particles' edges is lost anyway"}};
  }
  return {};
}

}  // namespace

std::vector<Fault> take_in_profile(json& document, const std::filesystem::path& folder) {
  const json::json_pointer key("/joint/profile_csv");
  if (!document.contains(key) || !document.at(key).is_string()) return {};
  if (document.contains(json::json_pointer("/joint/points_mm"))) {
    return {{"/joint/profile_csv", "is given beside /joint/points_mm", document.at(key).get<std::string>(),
             "one of the two", "remove one of them"}};
  }
  const std::filesystem::path given = document.at(key).get<std::string>();
  json points = json::array();
  std::vector<Fault> faults = read_points(given.is_absolute() ? given : folder / given, points);
  document.at("joint").erase("profile_csv");
  if (faults.empty()) document["joint"]["points_mm"] = points;
  return faults;
}

}  // namespace asperity
