#pragma once
// Speed against error: every method timed on one footprint and held against the reference of its surface.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/document/workspace.h"
#include "core/math/parallel.h"
#include "core/math/result.h"

namespace glint {

/// How many normals a mean time per query is over.
inline constexpr std::size_t k_study_queries = 10'000;

struct StudySettings {
  int repeats = 5;                                 ///< images timed after one warm-up; image_ms is their median
  std::optional<int> threads;                      ///< of the timed methods; the reference uses all
  std::optional<Interpolation> reference_surface;  ///< forces one; default: the method's own
  double query_seconds = 10;                       ///< queries stop after this time if 10^4 take longer
};

struct StudyReference {
  Interpolation surface;
  double relative_l1;  ///< its own error
};

struct StudyResult {
  PndfMethod method;
  Interpolation surface;
  StudyReference reference;
  double build_ms;
  double prepare_ms;  ///< of one footprint, before its first query
  std::size_t bytes;
  double image_ms;
  double query_us;          ///< mean over normals drawn from D_P itself
  double query_uniform_us;  ///< mean over normals uniform in the lobe's window
  std::size_t query_count;  ///< how many the two means are over: 10^4, or fewer where the time ran out
  std::size_t query_uniform_count;
  double relative_l1;
  double peak_error;
  double energy_error;
  double own_noise;
  std::string answered_by;  ///< where the method chooses among others
};

/// Runs every method of the document. Queries, build and reference run once. Cancelled: an error that says so.
Result<std::vector<StudyResult>> run_study(const Document& document, const Surface& surface,
                                           const StudySettings& settings, JobControl& control);

/// The processor's name and its core count, for reports: a time always names its machine.
std::string machine_name();

}  // namespace glint
