// The JSON schema of presets, made from the declarations of the parameters.

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/document/parameter.h"
#include "core/document/preset.h"

namespace glint {
namespace {

using Schema = nlohmann::ordered_json;

Schema number_schema(const NumberRange& range) {
  Schema schema{{"type", "number"},
                {range.open_lowest ? "exclusiveMinimum" : "minimum", range.lowest},
                {"maximum", range.highest}};
  if (range.without_zero) schema["not"] = {{"const", 0}};
  return schema;
}

Schema list_schema(std::size_t size, Schema items) {
  return {{"type", "array"}, {"items", std::move(items)}, {"minItems", size}, {"maxItems", size}};
}

Schema choice_schema(std::span<const std::string_view> choices) {
  return {{"enum", choices}};
}

Schema value_schema(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::number:
      return number_schema(parameter.range);
    case ParameterKind::integer:
      return {{"type", "integer"},
              {"minimum", parameter.integer_range.lowest},
              {"maximum", parameter.integer_range.highest}};
    case ParameterKind::flag:
      return {{"type", "boolean"}};
    case ParameterKind::text:
      return {{"type", "string"}, {"minLength", 1}};
    case ParameterKind::path:
      return {{"type", "string"}};
    case ParameterKind::choice:
      return choice_schema(parameter.choices);
    case ParameterKind::numbers:
      return list_schema(parameter.components.size(), number_schema(parameter.range));
    case ParameterKind::choices:
      return {{"type", "array"}, {"items", choice_schema(parameter.choices)}, {"minItems", 1}, {"uniqueItems", true}};
  }
  return {};
}

struct DefaultValue {
  Schema operator()(std::monostate) const { return nullptr; }
  template <class Value>
  Schema operator()(const Value& value) const {
    return value;
  }
};

Schema parameter_schema(const Parameter& parameter) {
  Schema schema;
  schema["description"] = parameter.unit.empty()
                              ? fmt::format("{} [{}]", parameter.help, parameter.source)
                              : fmt::format("{} Unit: {}. [{}]", parameter.help, parameter.unit, parameter.source);
  schema["default"] = std::visit(DefaultValue(), parameter.default_value());
  const Schema value = value_schema(parameter);
  if (!parameter.instead.empty()) {
    schema["anyOf"] = {value, {{"const", parameter.instead}}};
  } else if (parameter.may_be_none) {
    schema["anyOf"] = {value, {{"type", "null"}}};
  } else {
    schema.update(value);
  }
  return schema;
}

Schema object_schema() {
  return {{"type", "object"}, {"additionalProperties", false}, {"properties", Schema::object()}};
}

}  // namespace

std::string preset_schema() {
  Schema schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "Glintscope preset"}};
  schema.update(object_schema());
  schema["required"] = {"glintscope", "version"};
  schema["properties"]["glintscope"] = {{"description", "Marks the file as a preset."}, {"const", "preset"}};
  schema["properties"]["version"] = {{"description", "The version of the format."},
                                     {"type", "integer"},
                                     {"minimum", 1},
                                     {"maximum", k_preset_version}};
  for (const Parameter& parameter : parameters()) {
    Schema* object = &schema;
    std::string_view rest = parameter.path;
    for (std::size_t dot = rest.find('.'); dot != std::string_view::npos; dot = rest.find('.')) {
      Schema& inner = (*object)["properties"][std::string(rest.substr(0, dot))];
      if (inner.is_null()) inner = object_schema();
      object = &inner;
      rest.remove_prefix(dot + 1);
    }
    (*object)["properties"][std::string(rest)] = parameter_schema(parameter);
  }
  return schema.dump(2) + "\n";
}

}  // namespace glint
