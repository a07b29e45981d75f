#include "gui/input/script.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/document/text.h"
#include "gui/commandline/document_options.h"
#include "gui/input/actions.h"
#include "gui/memory/user_folders.h"

namespace glint::gui {
namespace {

constexpr std::string_view k_blank = " \t\r";
constexpr int k_most_frames = 100000;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(k_blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(k_blank) - first + 1);
}

// Takes the first word off the front of a trimmed text; empty where there is none.
std::string_view take_word(std::string_view& text) {
  const std::string_view word = text.substr(0, text.find_first_of(k_blank));
  text = trimmed(text.substr(word.size()));
  return word;
}

template <class Number>
std::optional<Number> number_from(std::string_view text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, value);
  if (fault != std::errc() || stop != end || text.empty() || !std::isfinite(static_cast<double>(value))) {
    return std::nullopt;
  }
  return value;
}

std::optional<glm::dvec2> pair_from(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto x = number_from<double>(text.substr(0, comma));
  const auto y = number_from<double>(text.substr(comma + 1));
  if (!x || !y) return std::nullopt;
  return glm::dvec2(*x, *y);
}

// Of text that is UTF-8.
std::u32string characters_of(std::string_view text) {
  std::u32string characters;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80U) {
      characters += static_cast<char32_t>(byte);
    } else if ((byte & 0xC0U) == 0x80U) {
      characters.back() = (characters.back() << 6U) | (byte & 0x3FU);
    } else {
      characters += static_cast<char32_t>(byte & (byte < 0xE0U ? 0x1FU : byte < 0xF0U ? 0x0FU : 0x07U));
    }
  }
  return characters;
}

// An error whose subject parse_script fills in.
Error fault(std::string sentence) {
  return request_error("", std::move(sentence));
}

/// What stands after an action's name. The first fault is kept: ask for it at the end, before using what was taken.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  std::string word(std::string_view what) {
    const std::string_view taken = take_word(rest_);
    if (taken.empty()) fail(fmt::format("{} is missing", what));
    return std::string(taken);
  }
  std::string rest(std::string_view what) {
    if (rest_.empty()) fail(fmt::format("{} is missing", what));
    return std::string(std::exchange(rest_, {}));
  }
  glm::dvec2 two_numbers(std::string_view what) {
    const std::string text = word(what);
    const std::optional<glm::dvec2> pair = pair_from(text);
    if (!pair) fail(fmt::format("'{}' is not {}, two numbers", one_line(text), what));
    return pair.value_or(glm::dvec2(0));
  }
  double number(std::string_view what) {
    const std::string text = word(what);
    const std::optional<double> value = number_from<double>(text);
    if (!value) fail(fmt::format("'{}' is not {}, a number", one_line(text), what));
    return value.value_or(0);
  }
  Chord chord() {
    const std::string text = word("CHORD");
    const std::optional<Chord> named = chord_named(text);
    if (!named) fail(fmt::format("'{}' is no key; expected for example S, Ctrl+Shift+S or F1", one_line(text)));
    return named.value_or(Chord{});
  }
  const Parameter* field() {
    const std::string path = word("FIELD");
    const Parameter* parameter = find_parameter(path);
    if (!parameter) {
      fail(fmt::format("field '{}' is unknown; the nearest field is '{}'", one_line(path),
                       nearest_parameter(path).path));
    }
    return parameter;
  }
  ParameterValue value(const Parameter* parameter) {
    if (!parameter) return {};
    const bool is_text = parameter->kind == ParameterKind::text || parameter->kind == ParameterKind::path;
    const std::string words = !is_text ? word("VALUE") : is_empty() ? std::string() : rest("VALUE");
    Result<ParameterValue> parsed = parse_value(*parameter, "", words);
    if (!parsed) fail(fmt::format("field '{}' {}", parameter->path, parsed.error().sentence));
    return parsed ? std::move(*parsed) : ParameterValue();
  }
  void fail(std::string sentence) {
    if (!fault_) fault_ = fault(std::move(sentence));
  }
  [[nodiscard]] bool is_empty() const { return rest_.empty(); }

  /// The action, if everything was right and no word is left.
  template <class Action>
  Result<StepAction> finish(Action action) {
    if (!rest_.empty()) fail(fmt::format("'{}' is more than it takes", one_line(rest_)));
    if (fault_) return *fault_;
    return StepAction(std::move(action));
  }

 private:
  std::string_view rest_;
  std::optional<Error> fault_;
};

template <step::Gesture gesture>
Result<StepAction> point(Words& words) {
  return words.finish(step::Point{words.word("WIDGET"), gesture});
}

template <step::KeyGesture gesture>
Result<StepAction> press_key(Words& words) {
  return words.finish(step::PressKey{words.chord(), gesture});
}

Result<StepAction> set(Words& words) {
  const Parameter* parameter = words.field();
  return words.finish(step::Set{parameter, words.value(parameter)});
}

Result<StepAction> expect(Words& words) {
  const Parameter* parameter = words.field();
  step::Expect action{parameter, words.value(parameter)};
  if (parameter && !words.is_empty()) {
    const bool is_number = parameter->kind == ParameterKind::number || parameter->kind == ParameterKind::integer ||
                           parameter->kind == ParameterKind::numbers;
    if (!is_number) words.fail(fmt::format("field '{}' is no number and has no TOLERANCE", parameter->path));
    action.tolerance = words.number("TOLERANCE");
    if (action.tolerance < 0) words.fail("TOLERANCE is below 0");
  }
  return words.finish(std::move(action));
}

Result<StepAction> wait(Words& words) {
  const std::string what = words.word("jobs or FRAMES");
  if (what == "jobs") return words.finish(step::WaitForJobs{});
  const std::optional<int> frames = number_from<int>(what);
  if (!what.empty() && (!frames || *frames < 1 || *frames > k_most_frames)) {
    words.fail(
        fmt::format("'{}' is neither 'jobs' nor a number of frames from 1 to {}", one_line(what), k_most_frames));
  }
  return words.finish(step::WaitFrames{frames.value_or(1)});
}

Result<StepAction> export_to(Words& words) {
  std::string what = words.word("WHAT");
  return words.finish(step::Export{std::move(what), words.rest("PATH")});
}

Result<StepAction> drag(Words& words) {
  std::string widget = words.word("WIDGET");
  return words.finish(step::Drag{std::move(widget), words.two_numbers("DX,DY")});
}

Result<StepAction> scroll(Words& words) {
  std::string widget = words.word("WIDGET");
  return words.finish(step::Scroll{std::move(widget), words.number("DY")});
}

struct ActionWord {
  std::string_view name;
  Result<StepAction> (*parse)(Words&);
};

constexpr std::array k_actions = {
    ActionWord{"open", [](Words& words) { return words.finish(step::Open{words.rest("PATH")}); }},
    ActionWord{"preset", [](Words& words) { return words.finish(step::OpenPreset{words.rest("NAME")}); }},
    ActionWord{"set", set},
    ActionWord{"click", point<step::Gesture::click>},
    ActionWord{"double-click", point<step::Gesture::double_click>},
    ActionWord{"right-click", point<step::Gesture::right_click>},
    ActionWord{"hover", point<step::Gesture::hover>},
    ActionWord{"map-click", [](Words& words) { return words.finish(step::ClickMap{words.two_numbers("X,Y")}); }},
    ActionWord{"drag", drag},
    ActionWord{"scroll", scroll},
    ActionWord{"key", press_key<step::KeyGesture::press>},
    ActionWord{"hold", press_key<step::KeyGesture::hold>},
    ActionWord{"release", press_key<step::KeyGesture::release>},
    ActionWord{"type", [](Words& words) { return words.finish(step::Type{characters_of(words.rest("TEXT"))}); }},
    ActionWord{"wait", wait},
    ActionWord{"shot", [](Words& words) { return words.finish(step::Shot{words.rest("PNG")}); }},
    ActionWord{"export", export_to},
    ActionWord{"expect", expect},
    ActionWord{"action", [](Words& words) { return words.finish(step::RunAction{words.word("NAME")}); }},
};

Error unknown_action(std::string_view name) {
  std::vector<std::string_view> known;
  known.reserve(k_actions.size());
  for (const ActionWord& action : k_actions) known.push_back(action.name);
  return fault(fmt::format("'{}' is no action; the nearest is '{}' of {}", one_line(name), nearest_name(name, known),
                           fmt::join(known, ", ")));
}

Result<StepAction> parse_line(std::string_view line) {
  if (first_invalid_utf8(line)) return fault("is not UTF-8 text");
  const std::string_view name = take_word(line);
  for (const ActionWord& action : k_actions) {
    if (action.name != name) continue;
    Words words(line);
    Result<StepAction> parsed = action.parse(words);
    if (!parsed) return fault(fmt::format("{}: {}", name, parsed.error().sentence));
    return parsed;
  }
  return unknown_action(name);
}

}  // namespace

Result<Script> parse_script(std::string_view text, const std::string& subject) {
  Script script{subject, {}};
  for (int number = 1; !text.empty(); ++number) {
    const std::string_view whole = text.substr(0, text.find('\n'));
    text.remove_prefix(whole.size() < text.size() ? whole.size() + 1 : whole.size());
    const std::string_view line = trimmed(whole);
    if (line.empty() || line.front() == '#') continue;
    Result<StepAction> action = parse_line(line);
    if (!action) return request_error(fmt::format("{}:{}", subject, number), action.error().sentence);
    script.steps.push_back({number, std::move(*action)});
  }
  return script;
}

Result<Script> load_script(const std::filesystem::path& file) {
  const Result<std::string> text = read_small_file(file);
  if (!text) return text.error();
  return parse_script(*text, file.string());
}

}  // namespace glint::gui
