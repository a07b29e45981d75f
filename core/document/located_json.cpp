#include "core/document/located_json.h"

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/document/text.h"

namespace glint {
namespace {

using nlohmann::json;

constexpr std::size_t k_deepest = 8;
constexpr std::string_view k_byte_order_mark = "\xEF\xBB\xBF";

struct Token {
  std::size_t begin = 0;
  std::size_t end = 0;
  TextPosition position;
};

/// nlohmann's parser tells what it found but not where; this walks the same tokens beside it.
class TokenWalker {
 public:
  explicit TokenWalker(std::string_view text) : text_(text) {
    if (text.starts_with(k_byte_order_mark)) at_ = k_byte_order_mark.size();
  }

  /// The next token, commas and colons included; at the end of the text an empty one.
  Token next() {
    while (at_ < text_.size() && k_white.find(text_[at_]) != std::string_view::npos) advance();
    Token token{at_, at_, position_};
    const std::size_t end = token_end();
    while (at_ < end) advance();
    token.end = at_;
    return token;
  }

  /// The next token that is a name, a value or a bracket.
  Token next_meaning() {
    Token token = next();
    while (token.end == token.begin + 1 && (text_[token.begin] == ',' || text_[token.begin] == ':')) token = next();
    return token;
  }

 private:
  static constexpr std::string_view k_white = " \t\r\n";

  void advance() {
    const auto byte = static_cast<unsigned char>(text_[at_++]);
    if (byte == '\n') {
      ++position_.line;
      position_.column = 1;
    } else if ((byte & 0xC0U) != 0x80U) {  // not the continuation of a character
      ++position_.column;
    }
  }

  [[nodiscard]] std::size_t token_end() const {
    if (at_ == text_.size()) return at_;
    if (text_[at_] == '"') {
      std::size_t end = at_ + 1;
      while (end < text_.size() && text_[end] != '"') end += text_[end] == '\\' ? 2 : 1;
      return std::min(end + 1, text_.size());
    }
    if (std::string_view("{}[],:").find(text_[at_]) != std::string_view::npos) return at_ + 1;
    return std::min(text_.find_first_of(" \t\r\n{}[],:\"", at_ + 1), text_.size());
  }

  std::string_view text_;
  std::size_t at_ = 0;
  TextPosition position_;
};

/// Collects the fields from the events of nlohmann's parser; every event that stands for a token takes one from the
/// walker.
class FieldReader : public json::json_sax_t {
 public:
  FieldReader(std::string_view text, const std::string& file) : text_(text), file_(file), walker_(text) {}

  [[nodiscard]] std::optional<Error>& error() { return error_; }
  [[nodiscard]] std::vector<LocatedField>& fields() { return fields_; }

  bool null() override { return take(std::monostate()); }
  bool boolean(bool value) override { return take(value); }
  bool number_integer(number_integer_t value) override { return take(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return take(std::uint64_t{value}); }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return take(value); }
  bool string(string_t& value) override { return take(value); }
  bool binary(binary_t& /*value*/) override { return take(std::nullopt); }  // JSON text has none

  bool start_object(std::size_t /*size*/) override {
    token_ = walker_.next_meaning();
    if (inside_list_ > 0) return enter_list();
    if (objects_.size() >= k_deepest) return too_deep();
    if (objects_.empty()) {
      objects_.emplace_back();
      return true;
    }
    LocatedField& field = add_field("an object");
    field.is_object = true;
    objects_.push_back(field.path + ".");
    return true;
  }

  bool key(string_t& name) override {
    token_ = walker_.next_meaning();
    if (inside_list_ > 0) return true;
    if (name.empty() || name.find('.') != std::string::npos) {
      return fail(token_.position,
                  fmt::format("field '{}': is no field's name; allowed: names without dots, one object "
                              "inside the other",
                              one_line(name)));
    }
    path_ = objects_.back() + name;
    name_position_ = token_.position;
    if (paths_.insert(path_).second) return true;
    return fail(token_.position, fmt::format("field '{}': is given twice; allowed: once", one_line(path_)));
  }

  bool end_object() override {
    token_ = walker_.next_meaning();
    if (inside_list_ > 0) return leave_list();
    objects_.pop_back();
    return true;
  }

  bool start_array(std::size_t /*size*/) override {
    token_ = walker_.next_meaning();
    if (inside_list_ > 0) return enter_list();
    if (objects_.empty()) return no_object();
    inside_list_ = 1;
    list_begin_ = token_;
    numbers_.clear();
    texts_.clear();
    list_is_plain_ = true;
    return true;
  }

  bool end_array() override {
    token_ = walker_.next_meaning();
    return leave_list();
  }

  bool parse_error(std::size_t position, const std::string& /*last_token*/, const json::exception& exception) override {
    const std::string_view what = exception.what();
    // "[json.exception…] parse error at line 1, column 2: syntax error while parsing value - invalid literal; …"
    std::size_t from = what.find(" - ");
    from = from == std::string_view::npos ? what.find("] ") + 2 : from + 3;
    const bool ended = what.find("unexpected end of input") != std::string_view::npos;
    const std::size_t until = ended ? text_.size() + 1 : std::min(position, text_.size());
    while (token_.end < until) {
      token_ = walker_.next();
      if (token_.begin == token_.end) break;
    }
    return fail(token_.position, "is not JSON: " + one_line(what.substr(from), 160));
  }

 private:
  bool fail(TextPosition position, std::string sentence) {
    error_ = content_error(located_subject(file_, position), std::move(sentence));
    return false;
  }
  bool no_object() {
    return fail(token_.position, "is not a preset; allowed: one object, {\"glintscope\": \"preset\", …}");
  }
  bool too_deep() { return fail(token_.position, fmt::format("is nested deeper than {} levels", k_deepest)); }

  LocatedField& add_field(std::string raw) {
    fields_.push_back({path_, name_position_, token_.position, false, std::nullopt, std::move(raw)});
    return fields_.back();
  }

  bool take(std::optional<ParameterValue> value) {
    token_ = walker_.next_meaning();
    if (inside_list_ > 0) return take_entry(value);
    if (objects_.empty()) return no_object();
    add_field(one_line(text_.substr(token_.begin, token_.end - token_.begin))).value = std::move(value);
    return true;
  }

  bool take_entry(const std::optional<ParameterValue>& value) {
    const auto* text = value ? std::get_if<std::string>(&*value) : nullptr;
    const auto* real = value ? std::get_if<double>(&*value) : nullptr;
    const auto* whole = value ? std::get_if<std::uint64_t>(&*value) : nullptr;
    if (text) texts_.push_back(*text);
    if (real) numbers_.push_back(*real);
    if (whole) numbers_.push_back(static_cast<double>(*whole));
    if (!text && !real && !whole) list_is_plain_ = false;
    return true;
  }

  bool enter_list() {
    list_is_plain_ = false;
    return ++inside_list_ + objects_.size() <= k_deepest || too_deep();
  }

  bool leave_list() {
    if (--inside_list_ > 0) return true;
    const std::size_t end = token_.end;
    token_ = list_begin_;
    LocatedField& field = add_field(one_line(text_.substr(token_.begin, end - token_.begin)));
    if (list_is_plain_ && (numbers_.empty() || texts_.empty())) {
      field.value = numbers_.empty() ? ParameterValue(texts_) : ParameterValue(numbers_);
    }
    token_.end = end;
    return true;
  }

  std::string_view text_;
  const std::string& file_;
  TokenWalker walker_;
  Token token_;  // the last one taken

  std::vector<std::string> objects_;  // for each open object the beginning of its members' paths
  std::string path_;                  // of the member whose name came last
  TextPosition name_position_;
  std::unordered_set<std::string> paths_;

  std::size_t inside_list_ = 0;  // brackets open since the list began, its own included
  Token list_begin_;
  std::vector<double> numbers_;
  std::vector<std::string> texts_;
  bool list_is_plain_ = true;  // only numbers and texts so far

  std::vector<LocatedField> fields_;
  std::optional<Error> error_;
};

TextPosition position_of(std::string_view text, std::size_t byte) {
  TextPosition position;
  for (const char c : text.substr(0, byte)) {
    if (c == '\n') position = {position.line + 1, 0};
    if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) ++position.column;
  }
  return position;
}

}  // namespace

std::string located_subject(const std::string& file, TextPosition position) {
  return fmt::format("{}:{}:{}", file, position.line, position.column);
}

Result<std::vector<LocatedField>> parse_located_json(std::string_view text, const std::string& file) {
  if (const std::optional<std::size_t> invalid = first_invalid_utf8(text)) {
    return content_error(located_subject(file, position_of(text, *invalid)),
                         fmt::format("is not UTF-8 text (byte {:#04x})", static_cast<unsigned char>(text[*invalid])));
  }
  FieldReader reader(text, file);
  const bool read = json::sax_parse(text.begin(), text.end(), &reader);
  if (reader.error()) return *std::move(reader.error());
  if (!read) return content_error(file, "is not JSON");
  return std::move(reader.fields());
}

}  // namespace glint
