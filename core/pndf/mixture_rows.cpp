#include "core/pndf/mixture_rows.h"

#include <array>
#include <optional>
#include <span>

#include "core/pndf/mixture_row_state.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/pndf/mixture_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/math/simd_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

// Value and derivatives of one component at a vector of seeds.
struct Stencil {
  V value, du, dv, laplacian;
};

// The four texels along the row at which a seed's stencil stands.
class Taps {
 public:
  Taps(const SeedRun& run, std::size_t first) : run_(run), first_(first) {}

  [[nodiscard]] HWY_INLINE V texel(const float* row, std::size_t tap) const {
    const Floats d;
    if (run_.contiguous) return hn::LoadU(d, row + run_.texel[first_] + static_cast<std::ptrdiff_t>(tap));
    const hn::RebindToSigned<Floats> di;
    return hn::GatherIndex(d, row + tap, hn::LoadU(di, run_.texel.data() + first_));
  }
  [[nodiscard]] HWY_INLINE V weight(const std::array<std::vector<float>, 4>& weights, std::size_t tap) const {
    return hn::LoadU(Floats(), weights[tap].data() + first_);
  }
  [[nodiscard]] HWY_INLINE V offset() const { return hn::LoadU(Floats(), run_.offset.data() + first_); }

  [[nodiscard]] HWY_INLINE Stencil stencil(const CombinedRow& rows) const {
    const Floats d;
    Stencil out{hn::Zero(d), hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    for (std::size_t tap = 0; tap < 4; ++tap) {
      const V value = texel(rows.value.data(), tap);
      const V plain = weight(run_.value, tap);
      out.value = hn::MulAdd(plain, value, out.value);
      out.du = hn::MulAdd(weight(run_.slope, tap), value, out.du);
      out.dv = hn::MulAdd(plain, texel(rows.slope.data(), tap), out.dv);
      out.laplacian = hn::MulAdd(weight(run_.bend, tap), value, out.laplacian);
      out.laplacian = hn::MulAdd(plain, texel(rows.bend.data(), tap), out.laplacian);
    }
    return out;
  }

 private:
  const SeedRun& run_;
  std::size_t first_;
};

// The constants of a frame, as vectors take them.
struct FrameLanes {
  float w11, w12, w22;
  float k_xx, k_xy, k_yy;
  float l11, l21, l22;
  float r_xx, r_yy;
  float squared_cut;
  float weight;
  float correction;

  explicit FrameLanes(const MixtureFrame& f)
      : w11(static_cast<float>(f.whitening.w11)),
        w12(static_cast<float>(f.whitening.w12)),
        w22(static_cast<float>(f.whitening.w22)),
        k_xx(static_cast<float>(f.drift.xx)),
        k_xy(static_cast<float>(f.drift.xy)),
        k_yy(static_cast<float>(f.drift.yy)),
        l11(static_cast<float>(f.spread.l11)),
        l21(static_cast<float>(f.spread.l21)),
        l22(static_cast<float>(f.spread.l22)),
        r_xx(static_cast<float>(f.roughness.x * f.roughness.x)),
        r_yy(static_cast<float>(f.roughness.y * f.roughness.y)),
        squared_cut(static_cast<float>(f.cut * f.cut)),
        weight(static_cast<float>(f.weight)),
        correction(f.elements == MixtureElements::corrected
                       ? static_cast<float>(0.5 * f.lattice.deviation * f.lattice.deviation)
                       : 0.0F) {}
};

// Whatever the compiler makes of it: rows of texels combined along v.
void combine(std::span<const float* const, 4> rows, const RowWeights& weights, CombinedRow& out) {
  const std::size_t count = out.value.size();
  const auto sum = [&](const std::array<float, 4>& w, std::vector<float>& to) {
    const float* a = rows[0];
    const float* b = rows[1];
    const float* c = rows[2];
    const float* e = rows[3];
    float* into = to.data();
    for (std::size_t k = 0; k < count; ++k) into[k] = w[0] * a[k] + w[1] * b[k] + w[2] * c[k] + w[3] * e[k];
  };
  sum(weights.value, out.value);
  sum(weights.slope, out.slope);
  sum(weights.bend, out.bend);
}

HWY_INLINE void append(V values, hn::Vec<hn::RebindToSigned<Floats>> front, std::vector<float>& to, std::size_t at) {
  const Floats d;
  hn::StoreU(hn::TableLookupLanes(values, hn::IndicesFromVec(d, front)), d, to.data() + at);
}

void add_run(const MixtureFrame& frame, const FrameLanes& f, const MixtureRows::State& state, const SeedRun& run,
             float v, ElementList& out) {
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  const bool flat = frame.elements == MixtureElements::flat || frame.piecewise_constant;
  const V o_v = hn::Set(d, v);
  for (std::size_t first = run.first; first < run.last; first += static_cast<std::size_t>(k_lanes)) {
    const Taps taps(run, first);
    const V o_u = taps.offset();
    const V white_x = hn::MulAdd(hn::Set(d, f.w11), o_u, hn::Set(d, f.w12 * v));
    const V squared = hn::MulAdd(white_x, white_x, hn::Set(d, f.w22 * v * f.w22 * v));
    const V room = hn::Sub(hn::Set(d, f.squared_cut), squared);
    const auto there = hn::And(hn::FirstN(d, run.last - first), hn::Gt(room, hn::Zero(d)));
    if (hn::AllFalse(d, there)) continue;
    Stencil s = taps.stencil(state.combined[0]);
    Stencil t = taps.stencil(state.combined[1]);
    V mean_x = hn::MulAdd(hn::Set(d, f.correction), s.laplacian, s.value);
    V mean_y = hn::MulAdd(hn::Set(d, f.correction), t.laplacian, t.value);
    V xy = hn::Zero(d);
    V yy = hn::Set(d, f.r_yy);
    V determinant = hn::Set(d, f.r_xx * f.r_yy);
    if (flat) {
      mean_x = s.value;
      mean_y = t.value;
    } else {
      const V ku = hn::MulAdd(hn::Set(d, f.k_xx), o_u, hn::Mul(hn::Set(d, f.k_xy), o_v));
      const V kv = hn::MulAdd(hn::Set(d, f.k_xy), o_u, hn::Mul(hn::Set(d, f.k_yy), o_v));
      mean_x = hn::NegMulAdd(s.du, ku, hn::NegMulAdd(s.dv, kv, mean_x));
      mean_y = hn::NegMulAdd(t.du, ku, hn::NegMulAdd(t.dv, kv, mean_y));
      // J L, and what it adds to the covariance and its determinant, in terms that are all positive.
      const V su = hn::MulAdd(hn::Set(d, f.l11), s.du, hn::Mul(hn::Set(d, f.l21), s.dv));
      const V sv = hn::Mul(hn::Set(d, f.l22), s.dv);
      const V tu = hn::MulAdd(hn::Set(d, f.l11), t.du, hn::Mul(hn::Set(d, f.l21), t.dv));
      const V tv = hn::Mul(hn::Set(d, f.l22), t.dv);
      const V more_xx = hn::MulAdd(su, su, hn::Mul(sv, sv));
      const V more_yy = hn::MulAdd(tu, tu, hn::Mul(tv, tv));
      xy = hn::MulAdd(su, tu, hn::Mul(sv, tv));
      const V turned = hn::MulSub(su, tv, hn::Mul(sv, tu));
      determinant = hn::MulAdd(turned, turned, determinant);
      determinant = hn::MulAdd(hn::Set(d, f.r_xx), more_yy, hn::MulAdd(yy, more_xx, determinant));
      yy = hn::Add(yy, more_yy);
    }
    const V inverse = hn::Div(hn::Set(d, 1), hn::Sqrt(determinant));
    const V w22 = hn::Div(hn::Set(d, 1), hn::Sqrt(yy));
    const V w11 = hn::Mul(hn::Mul(yy, w22), inverse);
    const V w12 = hn::Neg(hn::Mul(hn::Mul(xy, hn::Mul(w22, w22)), w11));
    const V here = exp2_of_negative(hn::Mul(squared, hn::Set(d, -k_unit * k_unit)));
    const V amplitude = hn::Mul(hn::Mul(hn::Set(d, f.weight), here), inverse);
    const auto front = hn::Compress(hn::Iota(di, 0), hn::RebindMask(di, there));
    const std::size_t at = out.count;
    append(mean_x, front, out.x, at);
    append(mean_y, front, out.y, at);
    append(w11, front, out.w11, at);
    append(w12, front, out.w12, at);
    append(w22, front, out.w22, at);
    append(amplitude, front, out.amplitude, at);
    append(room, front, out.room, at);
    append(o_u, front, out.u, at);
    out.count += hn::CountTrue(d, there);
  }
}

}  // namespace

void make_row(const MixtureFrame& frame, MixtureRows::State& state, const RowPlan& plan, ElementList& out) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::array<const float*, 4> rows{};
    for (std::size_t k = 0; k < 4; ++k) rows[k] = state.texel_row(plan.texel_row + static_cast<std::int64_t>(k), axis);
    combine(std::span<const float* const, 4>(rows), plan.weights, state.combined[axis]);
  }
  const FrameLanes lanes(frame);
  for (const SeedRun& run : state.runs) {
    add_run(frame, lanes, state, run, plan.offset, out);
  }
}

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glint {

HWY_EXPORT(make_row);

MixtureRows::MixtureRows(const MixtureFrame& frame) : state_(std::make_unique<State>(frame)) {}
MixtureRows::~MixtureRows() = default;

void MixtureRows::append(std::int64_t row, ElementList& out) {
  const std::optional<RowPlan> plan = state_->plan(row);
  if (!plan) return;
  out.reserve(out.count + state_->most_elements());
  HWY_DYNAMIC_DISPATCH(make_row)(state_->frame, *state_, *plan, out);
}

void ElementList::reserve(std::size_t size) {
  if (x.size() >= size) return;
  for (std::vector<float>* field : {&x, &y, &w11, &w12, &w22, &amplitude, &room, &u}) field->resize(size);
}

}  // namespace glint

#endif  // once
