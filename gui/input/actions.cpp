#include "gui/input/actions.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace glint::gui {
namespace {

std::string lower(std::string_view text) {
  std::string lowered(text);
  for (char& c : lowered) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lowered;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  bool is_inside = false;
  for (const char c : lower(text)) {
    const bool is_blank = c == ' ' || c == '\t';
    if (!is_blank && !is_inside) words.emplace_back();
    if (!is_blank) words.back() += c;
    is_inside = !is_blank;
  }
  return words;
}

bool begins_a_word(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    if (at == 0 || text[at - 1] == ' ' || text[at - 1] == '.' || text[at - 1] == '_') return true;
  }
  return false;
}

bool has_letters_in_order(std::string_view text, std::string_view letters) {
  std::size_t found = 0;
  for (const char c : text) {
    if (found < letters.size() && c == letters[found]) ++found;
  }
  return found == letters.size();
}

// How well a word fits, 0 if not at all. Only the order of these numbers means anything.
int score(const Action& action, const std::string& word) {
  const std::string title = lower(action.title);
  const std::string name = lower(action.name);
  if (title.starts_with(word)) return 100;
  if (begins_a_word(title, word)) return 80;
  if (title.find(word) != std::string::npos) return 60;
  if (begins_a_word(name, word)) return 50;
  if (lower(action.menu).starts_with(word)) return 45;
  if (name.find(word) != std::string::npos) return 40;
  if (begins_a_word(lower(action.tooltip), word)) return 30;
  return has_letters_in_order(title, word) ? 10 : 0;
}

int score(const Action& action, std::span<const std::string> words) {
  int sum = 1;
  for (const std::string& word : words) {
    const int one = score(action, word);
    if (one == 0) return 0;
    sum += one;
  }
  return sum;
}

std::vector<Chord> chords_of(const Action& action) {
  std::vector<Chord> chords = action.more_chords;
  if (action.chord) chords.insert(chords.begin(), *action.chord);
  return chords;
}

// Levenshtein's distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

void Actions::add(Action action) {
  assert(!action.name.empty() && !find(action.name) && action.run);
  actions_.push_back(std::move(action));
}

const Action* Actions::find(std::string_view name) const {
  const auto found = std::find_if(actions_.begin(), actions_.end(), [&](const Action& a) { return a.name == name; });
  return found == actions_.end() ? nullptr : &*found;
}

const Action* Actions::for_chord(Chord chord) const {
  for (const Action& action : actions_) {
    const std::vector<Chord> chords = chords_of(action);
    if (std::find(chords.begin(), chords.end(), chord) != chords.end()) return &action;
  }
  return nullptr;
}

std::string Actions::run(std::string_view name) const {
  const Action* action = find(name);
  if (!action) {
    std::vector<std::string_view> names;
    names.reserve(actions_.size());
    for (const Action& known : actions_) names.emplace_back(known.name);
    return fmt::format("there is no action '{}'; the nearest is '{}'", name, nearest_name(name, names));
  }
  std::string reason = action->disabled_because();
  if (reason.empty()) action->run();
  return reason;
}

std::vector<const Action*> Actions::matching(std::string_view words) const {
  struct Match {
    const Action* action;
    bool is_enabled;
    int score;
  };
  const std::vector<std::string> wanted = words_of(words);
  std::vector<Match> matches;
  for (const Action& action : actions_) {
    if (const int found = score(action, wanted)) matches.push_back({&action, action.is_enabled(), found});
  }
  std::stable_sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) {
    return a.is_enabled != b.is_enabled ? a.is_enabled : a.score > b.score;
  });
  std::vector<const Action*> sorted;
  sorted.reserve(matches.size());
  for (const Match& match : matches) sorted.push_back(match.action);
  return sorted;
}

std::vector<std::string> Actions::faults() const {
  std::vector<std::string> faults;
  std::vector<std::pair<Chord, const Action*>> taken;
  for (const Action& action : actions_) {
    if (action.title.empty()) faults.push_back(fmt::format("'{}' has no title", action.name));
    if (action.tooltip.empty()) faults.push_back(fmt::format("'{}' has no tooltip", action.name));
    for (const Chord& chord : chords_of(action)) {
      const std::string text = chord_text(chord);
      if (text.empty()) faults.push_back(fmt::format("'{}' has a chord that cannot be written", action.name));
      for (const auto& [other, owner] : taken) {
        if (other == chord) faults.push_back(fmt::format("'{}' and '{}' both have {}", owner->name, action.name, text));
      }
      taken.emplace_back(chord, &action);
    }
  }
  return faults;
}

std::string nearest_name(std::string_view wanted, std::span<const std::string_view> names) {
  constexpr std::size_t k_longest = 200;  // nothing longer is near to anything; keeps the time small
  std::string_view nearest;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const std::string_view name : names) {
    const std::size_t distance = edit_distance(wanted.substr(0, k_longest), name.substr(0, k_longest));
    if (distance < least) {
      least = distance;
      nearest = name;
    }
  }
  return std::string(nearest);
}

}  // namespace glint::gui
