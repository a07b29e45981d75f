#pragma once
// What a panel gives back when a person changed something: the document as it should be now.

#include <string>

#include "core/document/document.h"

namespace glint::view {

/// One change of the document. Panels never hold a document of their own: they read the current one and return edits.
struct Edit {
  Document document;
  std::string label;     ///< names the step in the menu: "Roughness σ to 0.02"
  bool finished = true;  ///< false while a gesture (a drag, a held key) goes on; all of a gesture is one step of undo
};

}  // namespace glint::view
