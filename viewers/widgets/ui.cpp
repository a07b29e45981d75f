#include "viewers/widgets/ui.h"

#include <utility>

namespace glint::view {

void WidgetRecord::record(std::string_view name, Entry entry) {
  const auto [at, is_new] = entries_.insert_or_assign(std::string(name), std::move(entry));
  if (is_new) order_.push_back(at->first);
}

const WidgetRecord::Entry* WidgetRecord::find(std::string_view name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : &found->second;
}

}  // namespace glint::view
