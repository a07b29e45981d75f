#include "core/document/parameter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/surface/flakes.h"
#include "core/surface/noise.h"
#include "core/surface/scratches.h"
#include "tests/core/document/example.h"

namespace glint {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const Parameter& parameter(std::string_view path) {
  const Parameter* found = find_parameter(path);
  EXPECT_NE(found, nullptr) << path;
  return *found;
}

std::string set_error(std::string_view path, const ParameterValue& value) {
  Document document;
  const Status status = parameter(path).set(document, value);
  EXPECT_TRUE(document == Document()) << "a refused value changed the document";
  return status ? "accepted" : status.error().message();
}

TEST(Parameters, AreTheFieldsThatTheDesignNames) {
  std::vector<std::string> paths;
  for (const Parameter& p : parameters()) paths.emplace_back(p.path);
  EXPECT_THAT(paths,
              testing::ElementsAre(
                  "name", "surface.source", "surface.path", "surface.range", "surface.green", "surface.height_scale",
                  "surface.wrap", "surface.interpolation", "surface.generator.size", "surface.generator.seed",
                  "surface.generator.spectrum", "surface.generator.rms_slope", "surface.generator.correlation_length",
                  "surface.generator.wavelengths", "surface.generator.count", "surface.generator.length",
                  "surface.generator.half_width", "surface.generator.flank_slope", "surface.generator.direction",
                  "surface.generator.spread", "surface.generator.blur", "surface.generator.dent_rms_slope",
                  "surface.generator.radius", "surface.generator.alpha", "surface.generator.flat_share",
                  "footprint.center", "footprint.covariance", "intrinsic_roughness", "methods", "exact.vertex_shift",
                  "exact.precision", "mixture.step", "mixture.kappa", "mixture.elements", "auto.tolerance",
                  "binning.samples", "grid.size", "grid.window", "seed", "view.density_scale", "view.density_range",
                  "view.difference_range", "view.map_colors", "view.elements"));
}

TEST(Parameters, HaveUniquePathsAndSayWhatTheyDoAndWhoDefinedThem) {
  std::set<std::string_view> paths;
  for (const Parameter& p : parameters()) {
    EXPECT_TRUE(paths.insert(p.path).second) << p.path;
    EXPECT_FALSE(p.label.empty()) << p.path;
    EXPECT_TRUE(p.help.ends_with('.')) << p.path;
    EXPECT_FALSE(p.source.empty()) << p.path;
    EXPECT_FALSE(p.allowed().empty()) << p.path;
    EXPECT_EQ(find_parameter(p.path), &p);
  }
}

std::size_t character_count(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

TEST(Parameters, HaveShortLabelsForNarrowColumns) {
  for (const Parameter& p : parameters()) {
    EXPECT_LE(character_count(p.short_label), 12U) << p.path;
    EXPECT_LE(character_count(p.short_label.empty() ? p.label : p.short_label), 12U) << p.path;
  }
  EXPECT_EQ(parameter("intrinsic_roughness").short_label, "Roughness σ");
}

TEST(Parameters, HaveSlidersInsideTheirRange) {
  std::size_t sliders = 0;
  for (const Parameter& p : parameters()) {
    if (p.slider.empty()) continue;
    SCOPED_TRACE(p.path);
    ++sliders;
    ASSERT_TRUE(p.kind == ParameterKind::number || p.kind == ParameterKind::integer);
    EXPECT_LT(p.slider.lowest, p.slider.highest);
    EXPECT_TRUE(p.checked(p.slider.lowest));
    EXPECT_TRUE(p.checked(p.slider.highest));
    if (p.slider.logarithmic) {
      EXPECT_GT(p.slider.lowest, 0);
    }
  }
  EXPECT_GT(sliders, 0U);
  EXPECT_TRUE(parameter("seed").slider.empty());
}

TEST(Parameters, HaveDefaultsWithinTheirOwnRange) {
  for (const Parameter& p : parameters()) EXPECT_TRUE(p.checked(p.default_value())) << p.path;
  EXPECT_EQ(document_fault(Document()), std::nullopt);
}

TEST(Parameters, KeepEveryOtherValueAndTouchNothingElse) {
  ASSERT_EQ(test::other_values().size(), parameters().size());
  for (const Parameter& p : parameters()) {
    SCOPED_TRACE(p.path);
    Document document;
    ASSERT_NE(p.default_value(), test::other_value(p));
    ASSERT_TRUE(p.set(document, test::other_value(p)));
    // Size and seed are read from the generator in use, and a file uses none.
    EXPECT_EQ(p.get(document), test::other_value(p));
    for (const Parameter& other : parameters()) {
      if (&other != &p) {
        EXPECT_EQ(other.get(document), other.default_value()) << other.path;
      }
    }
    ASSERT_TRUE(p.set(document, p.default_value()));
    EXPECT_TRUE(document == Document());
  }
}

TEST(Parameters, ReachTheMembersTheyName) {
  const Document document = test::document_with_all_set();
  EXPECT_EQ(document.surface.source, SurfaceSource::noise);
  EXPECT_EQ(document.surface.path, "maps/with space é.png");
  EXPECT_EQ(document.surface.reading.range, ValueRange::signed_values);
  EXPECT_EQ(document.surface.reading.green, GreenDirection::down);
  EXPECT_EQ(document.surface.reading.wrap, Wrap::clamp);
  EXPECT_EQ(document.surface.interpolation, Interpolation::constant);
  EXPECT_EQ(document.surface.noise.size, 512);
  EXPECT_EQ(document.surface.scratches.size, 512);
  EXPECT_EQ(document.surface.flakes.size, 512);
  EXPECT_EQ(document.surface.noise.seed, UINT64_MAX);
  EXPECT_EQ(document.surface.scratches.seed, UINT64_MAX);
  EXPECT_EQ(document.surface.flakes.seed, UINT64_MAX);
  EXPECT_EQ(document.surface.noise.spectrum, NoiseSettings::Spectrum::gaussian);
  EXPECT_EQ(document.surface.noise.wavelengths, glm::dvec2(2.2, 64.7));
  EXPECT_EQ(document.surface.scratches.length, glm::dvec2(33.3, 444.4));
  EXPECT_EQ(document.surface.flakes, (FlakeSettings{512, UINT64_MAX, 7.7, 1.41, 0.25}));
  EXPECT_EQ(document.footprint.center, glm::dvec2(-123456.789, 1e-5));
  EXPECT_EQ(document.footprint.covariance, (SymmetricMatrix2{1e9, -0.3, 2.0 / 3.0}));
  EXPECT_EQ(document.methods,
            (std::vector{PndfMethod::binning, PndfMethod::mixture, PndfMethod::automatic, PndfMethod::exact}));
  EXPECT_EQ(document.grid.window, glm::dvec4(-1, -0.1, 0.30000000000000004, 1.5));
  EXPECT_EQ(document.seed, 9007199254740993U);
  EXPECT_TRUE(document.exact_vertex_shift);
  EXPECT_EQ(document.view,
            (ViewSettings{ColorScale::linear, glm::dvec2(1e-30, 1234.5), 0.1, MapColors::curvature, true}));
}

TEST(Parameters, TakeNoneWhereNoneIsAllowed) {
  Document document = test::document_with_all_set();
  ASSERT_TRUE(parameter("surface.height_scale").set(document, std::monostate()));
  EXPECT_EQ(document.surface.reading.height_scale, std::nullopt);
  ASSERT_TRUE(parameter("grid.window").set(document, "fit"));
  EXPECT_EQ(document.grid.window, std::nullopt);
  ASSERT_TRUE(parameter("surface.interpolation").set(document, "auto"));
  EXPECT_EQ(document.surface.interpolation, std::nullopt);
  EXPECT_THAT(set_error("intrinsic_roughness", std::monostate()), HasSubstr("is null; allowed: "));
}

TEST(Parameters, RefuseWhatIsOutOfRangeAndSayWhatIsAllowed) {
  EXPECT_EQ(set_error("intrinsic_roughness", 0.0), "intrinsic_roughness: is 0; allowed: a number from 1e-09 to 1");
  EXPECT_EQ(set_error("intrinsic_roughness", 1.5), "intrinsic_roughness: is 1.5; allowed: a number from 1e-09 to 1");
  EXPECT_EQ(set_error("surface.height_scale", 0.0),
            "surface.height_scale: is 0; allowed: a number from -1000000 to 1000000, not 0, or null");
  EXPECT_EQ(set_error("grid.size", -3.0), "grid.size: is -3; allowed: a whole number from 1 to 16384");
  EXPECT_EQ(set_error("grid.size", 2.5), "grid.size: is 2.5; allowed: a whole number from 1 to 16384");
  EXPECT_EQ(set_error("binning.samples", std::uint64_t{10'000'000'001}),
            "binning.samples: is 10000000001; allowed: a whole number from 1 to 10000000000");
  EXPECT_EQ(set_error("seed", 1.8446744073709552e19),
            "seed: is 1.8446744073709552e+19; allowed: a whole number from 0 to 18446744073709551615");
  EXPECT_EQ(set_error("surface.wrap", "mirror"), "surface.wrap: is \"mirror\"; allowed: \"repeat\", \"clamp\"");
  EXPECT_EQ(set_error("methods", test::Texts{"exact", "exact"}),
            "methods: is [\"exact\", \"exact\"]; allowed: a list of \"exact\", \"mixture\", \"lean\", \"auto\", "
            "\"binning\", at "
            "least one, "
            "none twice");
  EXPECT_THAT(set_error("methods", test::Texts{}), StartsWith("methods: is []; allowed: "));
  EXPECT_THAT(set_error("methods", "exact"), StartsWith("methods: is \"exact\"; allowed: a list of "));
  EXPECT_EQ(
      set_error("grid.window", test::Numbers{0.5, -0.5, 0, 1}),
      "grid.window: is [0.5, -0.5, 0, 1]; allowed: 4 numbers [smin, smax, tmin, tmax] from -100 to 100, smin below "
      "smax and tmin below tmax, or \"fit\"");
  EXPECT_THAT(set_error("grid.window", test::Numbers{0, 1, 0.5, 0.5}), HasSubstr("tmin below tmax"));
  EXPECT_THAT(set_error("grid.window", "auto"), HasSubstr("or \"fit\""));
  EXPECT_THAT(set_error("surface.generator.length", test::Numbers{9, 8}), HasSubstr("shortest at most longest"));
  EXPECT_THAT(set_error("footprint.covariance", test::Numbers{1, 0}), HasSubstr("3 numbers [sxx, sxy, syy]"));
  EXPECT_THAT(set_error("name", ""), HasSubstr("text of one line"));
  EXPECT_THAT(set_error("name", "two\nlines"), HasSubstr("is \"two?lines\"; allowed: text of one line"));
  EXPECT_THAT(set_error("name", "not UTF-8: \xff"), HasSubstr("text of one line"));
  EXPECT_THAT(set_error("surface.path", std::string(5000, 'x')), HasSubstr("…\"; allowed: "));
}

TEST(Parameters, RefuseNotANumberAndInfinityEverywhere) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), inf, -inf}) {
    for (const Parameter& p : parameters()) {
      EXPECT_FALSE(p.checked(bad)) << p.path;
      for (std::size_t k = 0; k < p.components.size(); ++k) {
        test::Numbers numbers(p.components.size(), 2.0);
        numbers[k] = bad;
        EXPECT_FALSE(p.checked(numbers)) << p.path;
      }
    }
  }
}

TEST(Parameters, TakeBothEndsOfEveryRangeAndNothingBeyond) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const Parameter& p : parameters()) {
    SCOPED_TRACE(p.path);
    if (p.kind == ParameterKind::number) {
      EXPECT_EQ(static_cast<bool>(p.checked(p.range.lowest)), !p.range.open_lowest);
      EXPECT_FALSE(p.checked(std::nextafter(p.range.lowest, -inf)));
      EXPECT_TRUE(p.checked(p.range.highest));
      EXPECT_FALSE(p.checked(std::nextafter(p.range.highest, inf)));
    } else if (p.kind == ParameterKind::integer) {
      EXPECT_TRUE(p.checked(p.integer_range.lowest));
      EXPECT_TRUE(p.checked(p.integer_range.highest));
      if (p.integer_range.lowest > 0) {
        EXPECT_FALSE(p.checked(p.integer_range.lowest - 1));
      }
      if (p.integer_range.highest < UINT64_MAX) {
        EXPECT_FALSE(p.checked(p.integer_range.highest + 1));
      }
    }
  }
}

TEST(ParameterValues, ThatAreNoBoolDoNotBecomeOne) {
  EXPECT_TRUE(std::holds_alternative<std::string>(ParameterValue("text")));
  EXPECT_TRUE(std::holds_alternative<double>(ParameterValue(1.0)));
  EXPECT_TRUE(std::holds_alternative<std::uint64_t>(ParameterValue(std::uint64_t{1})));
  EXPECT_TRUE(std::holds_alternative<bool>(ParameterValue(true)));
}

TEST(Parameters, AreFlagsOnlyWhereTheySaySo) {
  EXPECT_EQ(set_error("exact.vertex_shift", "true"), "exact.vertex_shift: is \"true\"; allowed: true or false");
  EXPECT_EQ(set_error("exact.vertex_shift", 1.0), "exact.vertex_shift: is 1; allowed: true or false");
  EXPECT_EQ(set_error("exact.vertex_shift", std::monostate()), "exact.vertex_shift: is null; allowed: true or false");
  for (const Parameter& p : parameters()) {
    EXPECT_EQ(static_cast<bool>(p.checked(true)), p.kind == ParameterKind::flag) << p.path;
  }
  EXPECT_EQ(set_error("seed", true), "seed: is true; allowed: a whole number from 0 to 18446744073709551615");
  EXPECT_EQ(value_text(false), "false");
}

TEST(Parameters, HoldColorRangesThatAscend) {
  Document document;
  ASSERT_TRUE(parameter("view.density_range").set(document, test::Numbers{0.5, 2}));
  EXPECT_EQ(document.view.density_range, glm::dvec2(0.5, 2));
  ASSERT_TRUE(parameter("view.density_range").set(document, "fit"));
  EXPECT_EQ(document.view.density_range, std::nullopt);
  EXPECT_THAT(set_error("view.density_range", test::Numbers{2, 2}), HasSubstr("lowest below highest, or \"fit\""));
  EXPECT_THAT(set_error("view.density_range", test::Numbers{0, 2}), HasSubstr("from 1e-30 to 1e+30"));
  EXPECT_EQ(set_error("view.difference_range", 0.0),
            "view.difference_range: is 0; allowed: a number above 0 and at most 1e+30, or null");
}

TEST(Parameters, TakeWholeNumbersInEitherWriting) {
  Document document;
  ASSERT_TRUE(parameter("binning.samples").set(document, 1e6 + 1));
  EXPECT_EQ(document.binning_samples, 1'000'001U);
  ASSERT_TRUE(parameter("intrinsic_roughness").set(document, std::uint64_t{1}));
  EXPECT_EQ(document.intrinsic_roughness, 1.0);
}

TEST(Parameters, KnowWhenTheyMatter) {
  Document document;
  EXPECT_TRUE(parameter("surface.generator.count").matters(document));
  EXPECT_FALSE(parameter("surface.generator.rms_slope").matters(document));
  EXPECT_FALSE(parameter("seed").matters(document));
  document.methods = {PndfMethod::exact, PndfMethod::binning};
  EXPECT_TRUE(parameter("seed").matters(document));
  EXPECT_TRUE(parameter("exact.vertex_shift").matters(document));
  document.surface.interpolation = Interpolation::smooth;
  EXPECT_TRUE(parameter("exact.vertex_shift").matters(document));
  document.surface.interpolation = Interpolation::linear;
  EXPECT_FALSE(parameter("exact.vertex_shift").matters(document));
  document.surface.interpolation.reset();
  document.methods = {PndfMethod::binning};
  EXPECT_FALSE(parameter("exact.vertex_shift").matters(document));
  document.surface.source = SurfaceSource::noise;
  EXPECT_TRUE(parameter("surface.generator.wavelengths").matters(document));
  EXPECT_FALSE(parameter("surface.generator.correlation_length").matters(document));
  document.surface.source = SurfaceSource::flakes;
  EXPECT_TRUE(parameter("surface.generator.radius").matters(document));
  EXPECT_TRUE(parameter("surface.generator.size").matters(document));
  EXPECT_FALSE(parameter("surface.generator.count").matters(document));
  document.surface.source = SurfaceSource::file;
  EXPECT_TRUE(parameter("surface.height_scale").matters(document));
  EXPECT_FALSE(parameter("surface.generator.size").matters(document));
}

TEST(NearestParameter, IsTheOneThatWasMeant) {
  EXPECT_EQ(nearest_parameter("sigmar").path, "intrinsic_roughness");
  EXPECT_EQ(nearest_parameter("sigma_r").path, "intrinsic_roughness");
  EXPECT_EQ(nearest_parameter("roughness").path, "intrinsic_roughness");
  EXPECT_EQ(nearest_parameter("footprint.centre").path, "footprint.center");
  EXPECT_EQ(nearest_parameter("footprnt").path, "footprint.center");
  EXPECT_EQ(nearest_parameter("surface.seed").path, "surface.generator.seed");
  EXPECT_EQ(nearest_parameter("heigth_scale").path, "surface.height_scale");
  EXPECT_EQ(nearest_parameter("samples").path, "binning.samples");
  EXPECT_FALSE(nearest_parameter("").path.empty());
  EXPECT_FALSE(nearest_parameter(std::string(100'000, 'z')).path.empty());
}

TEST(DocumentFault, IsAnErrorAboutTheFieldThatMustChange) {
  const auto subject_of = [](auto change) {
    Document document;
    change(document);
    const std::optional<Error> fault = document_fault(document);
    if (fault) {
      EXPECT_EQ(fault->kind, ErrorKind::request);
    }
    return fault ? fault->subject : "none";
  };
  EXPECT_EQ(subject_of([](Document& d) { d.surface.source = SurfaceSource::file; }), "surface.path");
  EXPECT_EQ(subject_of([](Document& d) { d.surface.scratches.size = 1000; }), "surface.generator.size");
  EXPECT_EQ(subject_of([](Document& d) { d.surface.scratches.size = -1; }), "surface.generator.size");
  EXPECT_EQ(subject_of([](Document& d) { d.footprint.covariance = {1, 2, 1}; }), "footprint.covariance");
  EXPECT_EQ(subject_of([](Document& d) { d.footprint.center.x = std::nan(""); }), "footprint.center");
  EXPECT_EQ(subject_of([](Document& d) { d.grid.window = {1, -1, 0, 1}; }), "grid.window");
  EXPECT_EQ(subject_of([](Document& d) { d.grid.window = {0, 1e-12, 0, 1}; }), "grid.window");
  EXPECT_EQ(subject_of([](Document& d) { d.methods.clear(); }), "methods");
  EXPECT_EQ(subject_of([](Document& d) { d.methods.assign(2, PndfMethod::exact); }), "methods");
  EXPECT_EQ(subject_of([](Document& d) { d.intrinsic_roughness = -1; }), "intrinsic_roughness");
}

// Ranges stand in the declarations and in the generators: they must be the same.
template <class Settings, class Generate>
void expect_same_verdict(const Settings& settings, const Document& document, Generate generate) {
  JobControl cancelled;
  cancelled.cancel();  // settings are checked first, so the error tells whether they passed
  const Result<NormalMap> map = generate(settings, cancelled);
  const std::string generator = !map && map.error().subject != "surface.generator" ? map.error().subject : "none";
  const std::optional<Error> fault = document_fault(document);
  EXPECT_EQ(fault ? fault->subject : "none", generator) << (fault ? fault->message() : "");
}

TEST(DocumentFault, AgreesWithTheGenerators) {
  const double below_1 = std::nextafter(1.0, 0.0);
  const auto scratches = [](auto change) {
    Document document;
    change(document.surface.scratches);
    expect_same_verdict(document.surface.scratches, document, generate_scratches);
  };
  for (const int size : {-1, 0, 1, 16, 31, 32, 33, 64, 32768}) scratches([&](auto& s) { s.size = size; });
  for (const int count : {-1, 0, 100'001}) scratches([&](auto& s) { s.count = count; });
  for (const double x : {0.0, below_1, 1.0, 16384.0, 16385.0}) scratches([&](auto& s) { s.length = {x, x}; });
  for (const double x : {0.0, 0.24, 0.25, 64.0, 64.1}) scratches([&](auto& s) { s.half_width = {x, x}; });
  for (const double x : {0.0, 0.0009, 0.001, 10.0, 10.1}) scratches([&](auto& s) { s.flank_slope = {x, x}; });
  for (const double x : {-360.1, -360.0, 360.0, 360.1}) scratches([&](auto& s) { s.direction = x; });
  for (const double x : {-0.1, 0.0, 90.0, 90.1}) scratches([&](auto& s) { s.spread = x; });
  for (const double x : {-0.1, 0.0, 16.0, 16.1}) scratches([&](auto& s) { s.blur = x; });
  for (const double x : {-0.1, 0.0, 10.0, 10.1}) scratches([&](auto& s) { s.dent_rms_slope = x; });

  const auto flakes = [](auto change) {
    Document document;
    document.surface.source = SurfaceSource::flakes;
    change(document.surface.flakes);
    expect_same_verdict(document.surface.flakes, document, generate_flakes);
  };
  for (const int size : {-1, 0, 7, 8, 23, 24, 1000, 16384, 16385}) flakes([&](auto& f) { f.size = size; });
  for (const double x : {0.0, below_1, 1.0, 256.0, 256.1, 5000.0}) flakes([&](auto& f) { f.radius = x; });
  for (const double x : {5.5, 5.596, 5.597, 4096.0}) {
    flakes([&](auto& f) {
      f.size = 16384;
      f.radius = x;
    });
  }
  for (const double x : {-0.1, 0.0, 10.0, 10.1}) flakes([&](auto& f) { f.alpha = x; });
  for (const double x : {-0.1, 0.0, 1.0, 1.1}) flakes([&](auto& f) { f.flat_share = x; });

  for (const auto spectrum : {NoiseSettings::Spectrum::band, NoiseSettings::Spectrum::gaussian}) {
    const auto noise = [&](auto change) {
      Document document;
      document.surface.source = SurfaceSource::noise;
      document.surface.noise.spectrum = spectrum;
      change(document.surface.noise);
      expect_same_verdict(document.surface.noise, document, generate_noise);
    };
    for (const int size : {0, 7, 31, 32, 33, 64, 16385, 32768}) noise([&](auto& n) { n.size = size; });
    for (const double x : {-0.1, 0.0, 10.0, 10.1}) noise([&](auto& n) { n.rms_slope = x; });
    for (const double x : {1.4, 1.5, 256.0}) noise([&](auto& n) { n.correlation_length = x; });
    for (const double x : {1.9, 2.0, 1024.0}) noise([&](auto& n) { n.wavelengths = {x, x}; });
  }
}

}  // namespace
}  // namespace glint
