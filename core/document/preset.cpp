#include "core/document/preset.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/document/located_json.h"
#include "core/document/parameter.h"
#include "core/document/text.h"

namespace glint {
namespace {

std::string json_text(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// fmt writes the shortest digits that read back as the same double, with a point in every locale.
struct JsonValue {
  std::string_view separator;  // between the entries of a list

  std::string operator()(std::monostate) const { return "null"; }
  std::string operator()(bool flag) const { return flag ? "true" : "false"; }
  std::string operator()(double number) const { return fmt::format("{}", number + 0.0); }  // -0 as 0
  std::string operator()(std::uint64_t number) const { return fmt::format("{}", number); }
  std::string operator()(const std::string& text) const { return json_text(text); }
  std::string operator()(const std::vector<double>& numbers) const { return list(numbers); }
  std::string operator()(const std::vector<std::string>& texts) const { return list(texts); }

  template <class Entry>
  [[nodiscard]] std::string list(const std::vector<Entry>& entries) const {
    std::string text = "[";
    for (const Entry& entry : entries) text += fmt::format("{}{}", text.size() > 1 ? separator : "", (*this)(entry));
    return text + "]";
  }
};

/// Writes members by their paths; those of one object must follow each other.
class ObjectWriter {
 public:
  explicit ObjectWriter(bool indented) : indented_(indented) {}

  void add(std::string_view path, const std::string& json) {
    while (!path.starts_with(open_)) close();
    for (std::size_t dot = path.find('.', open_.size()); dot != std::string_view::npos; dot = path.find('.', dot + 1)) {
      begin_member(path.substr(open_.size(), dot - open_.size()));
      text_ += '{';
      open_ = path.substr(0, dot + 1);
      ++depth_;
      first_ = true;
    }
    begin_member(path.substr(open_.size()));
    text_ += json;
  }

  std::string finish() {
    while (!open_.empty()) close();
    depth_ = 0;
    new_line();
    text_ += indented_ ? "}\n" : "}";
    return std::move(text_);
  }

 private:
  void new_line() {
    if (indented_) text_ += '\n' + std::string(2 * depth_, ' ');
  }
  void begin_member(std::string_view name) {
    if (!first_) text_ += ',';
    first_ = false;
    new_line();
    text_ += fmt::format("\"{}\":{}", name, indented_ ? " " : "");
  }
  void close() {
    --depth_;
    new_line();
    text_ += '}';
    open_.pop_back();  // its dot
    open_.erase(open_.rfind('.') + 1);
    first_ = false;
  }

  bool indented_;
  std::string text_ = "{";
  std::string open_;  // path of the object that is open, with its dot; empty: the outermost
  std::size_t depth_ = 1;
  bool first_ = true;
};

template <class Included>
std::string document_json(const Document& document, bool indented, Included included) {
  ObjectWriter writer(indented);
  const JsonValue value{indented ? ", " : ","};
  writer.add("glintscope", json_text("preset"));
  writer.add("version", fmt::format("{}", k_preset_version));
  for (const Parameter& parameter : parameters()) {
    if (included(parameter)) writer.add(parameter.path, std::visit(value, parameter.get(document)));
  }
  return writer.finish();
}

/// Turns located fields into a document; every error is located.
class PresetReader {
 public:
  PresetReader(const std::vector<LocatedField>& fields, const std::string& file) : fields_(fields), file_(file) {}

  Result<Document> read() {
    if (std::optional<Error> fault = header_fault()) return *std::move(fault);
    Document document;
    for (const LocatedField& field : fields_) {
      if (field.path == "glintscope" || field.path == "version") continue;
      if (std::optional<Error> fault = read_field(field, document)) return *std::move(fault);
    }
    if (const std::optional<Error> fault = document_fault(document)) {
      return error(position_of(fault->subject), fault->subject, fault->sentence);
    }
    return document;
  }

 private:
  [[nodiscard]] Error error(TextPosition position, std::string_view path, std::string_view sentence) const {
    return content_error(located_subject(file_, position), fmt::format("field '{}': {}", one_line(path), sentence));
  }

  [[nodiscard]] const LocatedField* find(std::string_view path) const {
    const auto found =
        std::find_if(fields_.begin(), fields_.end(), [&](const LocatedField& field) { return field.path == path; });
    return found == fields_.end() ? nullptr : &*found;
  }

  // Where the field stands; one that is missing is missed at the object it belongs to, or at the beginning.
  [[nodiscard]] TextPosition position_of(std::string_view path) const {
    while (!path.empty()) {
      if (const LocatedField* field = find(path)) return field->value_position;
      const std::size_t dot = path.rfind('.');
      path = path.substr(0, dot == std::string_view::npos ? 0 : dot);
    }
    return {};
  }

  [[nodiscard]] std::optional<Error> header_fault() const {
    const LocatedField* magic = find("glintscope");
    if (!magic) return error({}, "glintscope", "is missing; allowed: \"preset\", which marks the file as a preset");
    if (magic->value != ParameterValue("preset")) {
      return error(magic->value_position, magic->path, fmt::format("is {}; allowed: \"preset\"", magic->raw));
    }
    const std::string readable = fmt::format("allowed: a version this build reads, 1 to {}", k_preset_version);
    const LocatedField* version = find("version");
    if (!version) return error({}, "version", "is missing; " + readable);
    const auto* number = version->value ? std::get_if<std::uint64_t>(&*version->value) : nullptr;
    if (number && *number >= 1 && *number <= std::uint64_t{k_preset_version}) return std::nullopt;
    return error(version->value_position, version->path, fmt::format("is {}; {}", version->raw, readable));
  }

  [[nodiscard]] std::optional<Error> read_field(const LocatedField& field, Document& document) const {
    if (const Parameter* parameter = find_parameter(field.path)) {
      if (!field.value) {
        return error(field.value_position, field.path,
                     fmt::format("is {}; allowed: {}", field.raw, parameter->allowed()));
      }
      const Status status = parameter->set(document, *field.value);
      if (status) return std::nullopt;
      return error(field.value_position, field.path, status.error().sentence);
    }
    const std::string inside = field.path + ".";
    const bool is_group = std::any_of(parameters().begin(), parameters().end(),
                                      [&](const Parameter& p) { return p.path.starts_with(inside); });
    if (is_group && field.is_object) return std::nullopt;
    if (is_group) return error(field.value_position, field.path, fmt::format("is {}; allowed: an object", field.raw));
    return error(field.name_position, field.path,
                 fmt::format("is unknown; the nearest field is '{}'", nearest_parameter(field.path).path));
  }

  const std::vector<LocatedField>& fields_;
  const std::string& file_;
};

}  // namespace

std::string preset_text(const Document& document) {
  const Document defaults;
  return document_json(document, true, [&](const Parameter& parameter) {
    return parameter.path == "name" || parameter.matters(document) ||
           parameter.get(document) != parameter.get(defaults);
  });
}

std::string recipe_of(const Document& document) {
  return document_json(document, false, [&](const Parameter& parameter) { return parameter.matters(document); });
}

Result<Document> parse_preset(std::string_view text, const std::string& subject) {
  const Result<std::vector<LocatedField>> fields = parse_located_json(text, subject);
  if (!fields) return fields.error();
  return PresetReader(*fields, subject).read();
}

Result<Document> document_from_recipe(std::string_view text, const std::string& subject) {
  return parse_preset(text, subject);
}

}  // namespace glint
