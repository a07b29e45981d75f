#include "gui/commandline/queries.h"

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>

#include <fmt/format.h>

namespace glint::gui {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

// Two finite numbers and nothing else.
std::optional<glm::dvec2> parse_line(const std::string& line) {
  std::array<double, 2> numbers{};
  const char* at = line.data();
  const char* end = line.data() + line.size();
  for (double& number : numbers) {
    while (at != end && is_space(*at)) ++at;
    const auto [stop, fault] = std::from_chars(at, end, number);
    if (fault != std::errc() || !std::isfinite(number) || (stop != end && !is_space(*stop))) return std::nullopt;
    at = stop;
  }
  while (at != end && is_space(*at)) ++at;
  if (at != end) return std::nullopt;
  return glm::dvec2(numbers[0], numbers[1]);
}

}  // namespace

Result<std::vector<glm::dvec2>> read_queries(const std::string& file) {
  std::ifstream opened;
  std::error_code unreadable;
  if (file.empty()) return request_error("--queries", "needs a file, or - for standard input");
  if (std::filesystem::is_directory(file, unreadable)) return content_error(file, "is a folder, not a file of queries");
  if (file != "-") {
    opened.open(file);
    if (!opened) return content_error(file, "the file of queries cannot be read");
  }
  std::istream& lines = file == "-" ? std::cin : opened;
  std::vector<glm::dvec2> queries;
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::optional<glm::dvec2> query = parse_line(line);
    if (!query) {
      return request_error(file == "-" ? "--queries" : file,
                           fmt::format("line {} is not a query: expected two numbers `s t`", number));
    }
    queries.push_back(*query);
  }
  if (lines.bad()) return content_error(file == "-" ? "standard input" : file, "the queries cannot be read");
  return queries;
}

}  // namespace glint::gui
