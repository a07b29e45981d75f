#include "gui/dialogs/file_listing.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include "core/document/text.h"

namespace glint::gui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_longest_slug = 100;  // bytes: with an extension far below what file systems allow

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string lower(std::string text) {
  for (char& c : text) c = lower(c);
  return text;
}

std::string one_line_of(const fs::path& path) {
  return one_line(path.string(), std::numeric_limits<std::size_t>::max());
}

std::string why_not_listed(const std::error_code& error) {
  if (error == std::errc::no_such_file_or_directory) return "is not there any more";
  if (error == std::errc::permission_denied) return "cannot be read: you have no permission to";
  if (error == std::errc::not_a_directory) return "is a file and holds nothing";
  return "cannot be read: " + error.message();
}

// Nothing for what can neither be entered nor opened.
std::optional<ListedFile> listed(const fs::directory_entry& entry) {
  struct stat facts {};
  if (::stat(entry.path().c_str(), &facts) != 0) return std::nullopt;
  ListedFile file;
  file.is_folder = S_ISDIR(facts.st_mode);
  if (!file.is_folder && !S_ISREG(facts.st_mode)) return std::nullopt;
  file.path = entry.path();
  file.name = one_line_of(entry.path().filename());
  file.date = date_text(facts.st_mtime);
  if (!file.is_folder) {
    file.bytes = static_cast<std::uintmax_t>(facts.st_size);
    file.size = size_text(file.bytes);
  }
  return file;
}

bool is_hidden(const fs::path& path) {
  return path.filename().string().starts_with('.');
}

// Compares the runs of digits that begin at i and j, and moves past them; 0: of one value.
int compare_numbers(std::string_view a, std::size_t& i, std::string_view b, std::size_t& j) {
  const auto run = [](std::string_view text, std::size_t& at) {
    while (at < text.size() && text[at] == '0') ++at;
    const std::size_t first = at;
    while (at < text.size() && is_digit(text[at])) ++at;
    return text.substr(first, at - first);
  };
  const std::string_view x = run(a, i);
  const std::string_view y = run(b, j);
  if (x.size() != y.size()) return x.size() < y.size() ? -1 : 1;
  return x.compare(y);
}

int natural_order(std::string_view a, std::string_view b) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    if (is_digit(a[i]) && is_digit(b[j])) {
      if (const int order = compare_numbers(a, i, b, j); order != 0) return order;
      continue;
    }
    const auto x = static_cast<unsigned char>(lower(a[i++]));
    const auto y = static_cast<unsigned char>(lower(b[j++]));
    if (x != y) return x < y ? -1 : 1;
  }
  if (i < a.size() || j < b.size()) return j < b.size() ? -1 : 1;
  return a.compare(b);
}

bool listed_before(const ListedFile& a, const ListedFile& b) {
  if (a.is_folder != b.is_folder) return a.is_folder;
  return natural_less(a.name, b.name) || (a.name == b.name && a.path < b.path);
}

}  // namespace

bool FileFilter::matches(const fs::path& file) const {
  if (extensions.empty()) return true;
  return std::ranges::find(extensions, lower(file.extension().string())) != extensions.end();
}

Result<FolderListing> list_folder(const fs::path& folder, const FileFilter& filter, bool with_hidden) {
  std::error_code error;
  fs::directory_iterator at(folder, error);
  if (error) return content_error(one_line_of(folder), why_not_listed(error));
  FolderListing listing;
  listing.folder = folder;
  listing.writable = ::access(folder.c_str(), W_OK | X_OK) == 0;
  while (at != fs::directory_iterator()) {
    if (with_hidden || !is_hidden(at->path())) {
      std::optional<ListedFile> file = listed(*at);
      if (file && (file->is_folder || filter.matches(file->path))) listing.entries.push_back(std::move(*file));
    }
    at.increment(error);
    if (error) return content_error(one_line_of(folder), why_not_listed(error));
  }
  std::ranges::sort(listing.entries, listed_before);
  return listing;
}

bool natural_less(std::string_view a, std::string_view b) {
  return natural_order(a, b) < 0;
}

std::string size_text(std::uintmax_t bytes) {
  constexpr std::array<std::string_view, 6> k_units{"kB", "MB", "GB", "TB", "PB", "EB"};
  if (bytes < 1000) return fmt::format("{} B", bytes);
  double value = static_cast<double>(bytes) / 1000;
  std::size_t unit = 0;
  while (value >= 999.5 && unit + 1 < k_units.size()) {
    value /= 1000;
    ++unit;
  }
  return value < 99.95 ? fmt::format("{:.1f} {}", value, k_units[unit])
                       : fmt::format("{:.0f} {}", value, k_units[unit]);
}

std::string date_text(std::time_t time) {
  std::tm local{};
  if (!::localtime_r(&time, &local)) return {};
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}", local.tm_year + 1900, local.tm_mon + 1, local.tm_mday,
                     local.tm_hour, local.tm_min);
}

std::string shown_path(const fs::path& path) {
  return one_line_of(path);
}

std::optional<fs::path> parent_of(const fs::path& folder) {
  if (!folder.has_relative_path()) return std::nullopt;
  return typed_path("..", folder);
}

fs::path typed_path(std::string_view text, const fs::path& folder) {
  fs::path path(text);
  const char* home = std::getenv("HOME");
  if (home && (text == "~" || text.starts_with("~/"))) path = fs::path(home) / fs::path(text.substr(1)).relative_path();
  path = (folder / path).lexically_normal();
  return path.has_filename() || !path.has_relative_path() ? path : path.parent_path();
}

std::vector<std::string> completions(std::string_view text, const fs::path& folder, const FileFilter& filter,
                                     std::size_t most) {
  const std::size_t slash = text.rfind('/');
  const std::string_view head = slash == std::string_view::npos ? std::string_view() : text.substr(0, slash + 1);
  const std::string begun = lower(std::string(text.substr(head.size())));
  std::vector<std::string> found;
  if (begun == "." || begun == ".." || (head.empty() && begun == "~")) return found;
  const Result<FolderListing> listing = list_folder(typed_path(head, folder), filter, begun.starts_with('.'));
  if (!listing) return found;
  for (const ListedFile& file : listing->entries) {
    const std::string name = file.path.filename().string();
    if (first_invalid_utf8(name) || !lower(name).starts_with(begun)) continue;
    if (!file.is_folder && lower(name) == begun) continue;
    found.push_back(std::string(head) + name + (file.is_folder ? "/" : ""));
    if (found.size() == most) break;
  }
  return found;
}

std::string slug(std::string_view name) {
  std::string text;
  for (const char raw : name) {
    const char c = lower(raw);
    if ((static_cast<unsigned char>(c) & 0x80U) != 0 || is_digit(c) || (c >= 'a' && c <= 'z')) {
      text += c;
    } else if (!text.empty() && text.back() != '-') {
      text += '-';
    }
  }
  if (text.size() > k_longest_slug) {
    std::size_t end = k_longest_slug;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
    text.resize(end);
  }
  while (!text.empty() && text.back() == '-') text.pop_back();
  return text.empty() ? "preset" : text;
}

}  // namespace glint::gui
