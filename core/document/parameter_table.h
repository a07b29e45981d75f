#pragma once
// The declarations of the parameters, by the part of the document they belong to. Private to document/; everyone else
// asks parameters().

#include <span>

#include "core/document/parameter.h"

namespace glint {

/// surface.*
std::span<const Parameter> surface_parameters();
/// Everything else that determines a P-NDF: footprint, roughness, methods and their settings, grid, seed.
std::span<const Parameter> pndf_parameters();
/// view.*
std::span<const Parameter> view_parameters();

/// For Parameter::matters.
inline bool always(const Document& /*document*/) {
  return true;
}
inline bool never(const Document& /*document*/) {
  return false;
}

}  // namespace glint
