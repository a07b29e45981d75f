#include "gui/memory/settings.h"

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "core/document/text.h"
#include "core/image/atomic_file.h"
#include "gui/memory/user_folders.h"

namespace glint::gui {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr double k_least_scale = 0.5;
constexpr double k_largest_scale = 4;
constexpr int k_least_side = 64;
constexpr int k_largest_side = 32768;

fs::path settings_file(const fs::path& folder) {
  return folder / "settings.json";
}

std::optional<double> number_of(const Json& value) {
  if (!value.is_number()) return std::nullopt;
  return value.get<double>();
}

std::optional<int> side_of(const Json& value) {
  const std::optional<double> side = number_of(value);
  if (!side || !(*side >= k_least_side && *side <= k_largest_side)) return std::nullopt;
  return static_cast<int>(*side);
}

/// Takes members of an object that are what they should be and remembers the names of those that are not.
class SettingsReader {
 public:
  explicit SettingsReader(const Json& object) : object_(object) {}

  /// Calls `use` with the member, if there is one; false from it means that the member is wrong.
  template <class Use>
  void take(const char* name, Use use) {
    const auto member = object_.find(name);
    if (member != object_.end() && !use(*member)) wrong(name);
  }

  /// Likewise with every member of the object of that name.
  template <class Use>
  void take_each(const char* name, Use use) {
    take(name, [&](const Json& entries) {
      if (!entries.is_object()) return false;
      for (const auto& entry : entries.items()) {
        if (!use(entry.key(), entry.value())) wrong(fmt::format("{}.{}", name, one_line(entry.key())));
      }
      return true;
    });
  }

  void wrong(std::string_view name) { wrong_.push_back(fmt::format("'{}'", name)); }

  [[nodiscard]] std::optional<Error> fault(const fs::path& file) const {
    if (wrong_.empty()) return std::nullopt;
    return content_error(file.string(), fmt::format("does not hold what it should for {}; the default is used instead",
                                                    fmt::join(wrong_, ", ")));
  }

 private:
  const Json& object_;
  std::vector<std::string> wrong_;
};

bool take_text(const Json& value, std::string& text) {
  if (!value.is_string()) return false;
  text = value.get<std::string>();
  return true;
}

bool take_recent(const Json& value, std::vector<fs::path>& recent) {
  if (!value.is_array()) return false;
  bool good = true;
  for (const Json& entry : value) {
    std::string text;
    if (!take_text(entry, text) || text.empty()) {
      good = false;
    } else if (recent.size() < k_most_recent && std::find(recent.begin(), recent.end(), text) == recent.end()) {
      recent.emplace_back(text);
    }
  }
  return good;
}

void take_all(SettingsReader& reader, Settings& settings) {
  reader.take("ui_scale", [&](const Json& value) {
    const std::optional<double> scale = number_of(value);
    if (!scale || (*scale != 0 && !(*scale >= k_least_scale && *scale <= k_largest_scale))) return false;
    settings.ui_scale = *scale;
    return true;
  });
  reader.take("window_size", [&](const Json& value) {
    if (!value.is_array() || value.size() != 2) return false;
    const std::optional<int> width = side_of(value[0]);
    const std::optional<int> height = side_of(value[1]);
    if (width && height) settings.window_size = {*width, *height};
    return width && height;
  });
  reader.take("maximised", [&](const Json& value) {
    if (value.is_boolean()) settings.maximised = value.get<bool>();
    return value.is_boolean();
  });
  reader.take_each("splitters", [&](const std::string& name, const Json& value) {
    const std::optional<double> ratio = number_of(value);
    if (!ratio || !(*ratio >= 0 && *ratio <= 1)) return false;
    settings.splitters[name] = *ratio;
    return true;
  });
  reader.take_each("open_sections", [&](const std::string& name, const Json& value) {
    if (value.is_boolean()) settings.open_sections[name] = value.get<bool>();
    return value.is_boolean();
  });
  reader.take("recent", [&](const Json& value) { return take_recent(value, settings.recent); });
  reader.take("last_folder", [&](const Json& value) {
    std::string text;
    if (!take_text(value, text)) return false;
    settings.last_folder = text;
    return true;
  });
  reader.take("maximised_panel", [&](const Json& value) { return take_text(value, settings.maximised_panel); });
}

// Empty for a path that JSON cannot hold.
std::string json_path(const fs::path& path) {
  return first_invalid_utf8(path.string()) ? std::string() : path.string();
}

Json json_of(const Settings& settings) {
  Json recent = Json::array();
  for (const fs::path& file : settings.recent) {
    if (const std::string text = json_path(file); !text.empty()) recent.push_back(text);
  }
  Json object;
  object["ui_scale"] = settings.ui_scale;
  object["window_size"] = {settings.window_size.x, settings.window_size.y};
  object["maximised"] = settings.maximised;
  object["splitters"] = settings.splitters;
  object["open_sections"] = settings.open_sections;
  object["recent"] = std::move(recent);
  object["last_folder"] = json_path(settings.last_folder);
  object["maximised_panel"] = settings.maximised_panel;
  return object;
}

}  // namespace

LoadedSettings load_settings(const fs::path& folder) {
  LoadedSettings loaded;
  const fs::path file = settings_file(folder);
  std::error_code error;
  if (!fs::exists(file, error) && !error) return loaded;
  const Result<std::string> text = read_small_file(file);
  if (!text) {
    loaded.fault = content_error(text.error().subject, text.error().sentence + "; default settings are used");
    return loaded;
  }
  const Json object = Json::parse(*text, nullptr, false);
  if (!object.is_object()) {
    loaded.fault = content_error(file.string(), "is not JSON that holds settings; default settings are used");
    return loaded;
  }
  SettingsReader reader(object);
  take_all(reader, loaded.settings);
  loaded.fault = reader.fault(file);
  return loaded;
}

Status save_settings(const fs::path& folder, const Settings& settings) {
  if (Status made = make_folder(folder); !made) return made;
  return write_file(settings_file(folder),
                    json_of(settings).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

void remember_recent(Settings& settings, const fs::path& file) {
  std::error_code error;
  const fs::path absolute = fs::absolute(file, error).lexically_normal();
  if (error || file.empty()) return;
  std::vector<fs::path>& recent = settings.recent;
  recent.erase(std::remove(recent.begin(), recent.end(), absolute), recent.end());
  recent.insert(recent.begin(), absolute);
  if (recent.size() > k_most_recent) recent.resize(k_most_recent);
}

}  // namespace glint::gui
