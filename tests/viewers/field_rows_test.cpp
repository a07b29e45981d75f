#include "viewers/inspector/field_rows.h"

#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/document/parameter.h"
#include "tests/viewers/inspector_scene.h"
#include "viewers/inspector/field_edits.h"
#include "viewers/inspector/method_rows.h"
#include "viewers/inspector/read_report_rows.h"
#include "viewers/inspector/reading_rows.h"

namespace glint {
namespace {

using test::InspectorScene;
using testing::HasSubstr;
using testing::IsEmpty;
using view::controls_of;

const Parameter& field(std::string_view path) {
  return *find_parameter(path);
}

bool is_drawn_for(const Parameter& parameter, const Document& document) {
  return parameter.matters(document) || parameter.path == "name" || parameter.path.starts_with("view.");
}

// Together they make every field matter.
std::vector<Document> documents_of_all_kinds() {
  Document scratches;
  scratches.methods = {PndfMethod::exact, PndfMethod::mixture, PndfMethod::lean, PndfMethod::automatic,
                       PndfMethod::binning};
  scratches.footprint.covariance = {25, 3, 9};
  scratches.surface.path = "map.png";
  Document file = scratches;
  file.surface.source = SurfaceSource::file;
  Document gaussian = scratches;
  gaussian.surface.source = SurfaceSource::noise;
  gaussian.surface.noise.spectrum = NoiseSettings::Spectrum::gaussian;
  Document band = gaussian;
  band.surface.noise.spectrum = NoiseSettings::Spectrum::band;
  Document flakes = scratches;
  flakes.surface.source = SurfaceSource::flakes;
  return {scratches, file, gaussian, band, flakes};
}

TEST(Controls, ExistForEveryParameterUnderNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const Parameter& parameter : parameters()) {
    EXPECT_THAT(controls_of(parameter), testing::Not(IsEmpty())) << parameter.path;
    for (const std::string& name : controls_of(parameter)) EXPECT_TRUE(names.insert(name).second) << name;
  }
}

TEST(Controls, AreDrawnForEveryParameterThatMatters) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  std::set<std::string_view> seen;
  for (const Document& document : documents_of_all_kinds()) {
    scene.document = scene.saved = document;
    scene.frame(2);
    for (const Parameter& parameter : parameters()) {
      if (!is_drawn_for(parameter, document)) continue;
      seen.insert(parameter.path);
      for (const std::string& name : controls_of(parameter)) {
        const view::WidgetRecord::Entry* const entry = scene.widget(name);
        ASSERT_NE(entry, nullptr) << name;
        EXPECT_GT(entry->area.width(), 10) << name;
        EXPECT_TRUE(entry->reason.empty()) << name << ": " << entry->reason;
      }
    }
  }
  EXPECT_EQ(seen.size(), parameters().size());
}

TEST(Controls, StandInTheSectionThatTheirNameSays) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  for (const Document& document : documents_of_all_kinds()) {
    scene.document = document;
    scene.frame(2);
    for (const std::string& name : scene.stage.widgets().order()) {
      if (name.starts_with("inspector")) continue;
      EXPECT_TRUE(view::section_of(name, document)) << name;
    }
  }
}

// Some other value that the field allows.
std::string other_words(const Parameter& parameter, const ParameterValue& now, std::size_t component) {
  if (parameter.kind == ParameterKind::path) return "other.png";
  if (parameter.kind == ParameterKind::text) return "other";
  const auto* list = std::get_if<std::vector<double>>(&now);
  if (list) {  // a little outwards keeps pairs in order
    const double out = component % 2 == 0 ? 0.95 : 1.05;
    return fmt::format("{}", (*list)[component] * out + (parameter.path == "footprint.covariance" ? 0.01 : 0));
  }
  if (parameter.path == "surface.generator.size") return "512";
  const std::optional<double> number = view::slider_number(now);
  if (parameter.kind == ParameterKind::number && number) return fmt::format("{}", 0.5 * *number + 0.013);
  return number && *number != 2 ? "2" : "1";
}

// Uses the control once, as a person would, and says whether the field has changed.
bool control_changes(InspectorScene& scene, const Parameter& parameter, const std::string& name, std::size_t index) {
  const ParameterValue before = parameter.get(scene.document);
  const std::string last = name.substr(name.rfind('.') + 1);
  if (last == "slider") {
    scene.step(name, 1);
    if (parameter.get(scene.document) == before) scene.step(name, -1);
  } else if (parameter.kind == ParameterKind::choice && name == parameter.path) {
    const auto* now = std::get_if<std::string>(&before);
    scene.click(name);
    scene.click(fmt::format("popup.{}", parameter.choices[*now == parameter.choices[0] ? 1 : 0]));
  } else if (parameter.kind == ParameterKind::choice || parameter.kind == ParameterKind::choices ||
             parameter.kind == ParameterKind::flag || last == "fit" || last == "set") {
    scene.click(name);
  } else {
    scene.type(name, other_words(parameter, before, index));
  }
  return !(parameter.get(scene.document) == before);
}

TEST(Controls, ChangeTheFieldTheyBelongTo) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  std::set<std::string_view> seen;
  for (const Document& document : documents_of_all_kinds()) {
    for (const Parameter& parameter : parameters()) {
      if (!is_drawn_for(parameter, document) || !seen.insert(parameter.path).second) continue;
      const std::vector<std::string> names = controls_of(parameter);
      for (std::size_t k = 0; k < names.size(); ++k) {
        scene.document = scene.saved = document;
        if (parameter.path == "grid.window") scene.document.grid.window = glm::dvec4{-0.5, 0.5, -0.4, 0.4};
        if (parameter.path == "view.density_range") scene.document.view.density_range = glm::dvec2{0.1, 10};
        scene.frame(2);
        const ParameterValue now = parameter.get(scene.document);
        const auto* chosen = std::get_if<std::string>(&now);
        if (chosen && names[k] == fmt::format("{}.{}", parameter.path, *chosen)) continue;  // chosen already
        EXPECT_TRUE(control_changes(scene, parameter, names[k], k)) << names[k];
        EXPECT_FALSE(document_fault(scene.document)) << names[k];
      }
    }
  }
}

TEST(Entries, KeepRefusedTextOpenAndSayWhatIsAllowed) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  scene.frame(2);
  scene.type("intrinsic_roughness", "2");
  EXPECT_THAT(scene.edits, IsEmpty());
  EXPECT_EQ(scene.stage.state().editing, "intrinsic_roughness");
  EXPECT_THAT(scene.stage.state().editing_error, HasSubstr("Intrinsic roughness is 2; allowed: a number"));
  EXPECT_EQ(scene.stage.state().text, "2");
}

TEST(Entries, RefuseWhatDoesNotFitTheOtherFields) {
  Document document = documents_of_all_kinds()[3];
  const auto edit = view::typed_edit(document, field("surface.generator.wavelengths"), {8, 32}, 1, "5000");
  ASSERT_FALSE(edit);
  EXPECT_THAT(edit.error().sentence, HasSubstr("at most the map's size"));
  EXPECT_FALSE(view::typed_edit(document, field("surface.generator.wavelengths"), {8, 32}, 1, "4")) << "descends";
}

TEST(Entries, NameTheEditByFieldAndValue) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  scene.frame(2);
  scene.type("intrinsic_roughness", "0.05");
  ASSERT_EQ(scene.edits.size(), 1U);
  EXPECT_EQ(scene.edits[0].label, "Roughness σ to 0.05");
  EXPECT_TRUE(scene.edits[0].finished);
}

TEST(Entries, LeftAsTheyWereChangeNothing) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  scene.document.intrinsic_roughness = 0.123456789012345678;
  scene.frame(2);
  scene.click("intrinsic_roughness");
  EXPECT_EQ(scene.stage.state().text, "0.12345678901234568") << "all digits are there to be edited";
  scene.frame(2);
  scene.click("seed");
  EXPECT_THAT(scene.edits, IsEmpty());
}

struct Typed {
  std::string_view path;
  std::size_t component;
  std::string_view text;
  ParameterValue value;
};

TEST(Entries, UnderstandTheUnitsAndSignsThatAreShown) {
  const Document document = documents_of_all_kinds()[0];
  for (const Typed& typed : {Typed{"binning.samples", 0, "1.5 M", std::uint64_t{1'500'000}},
                             {"binning.samples", 0, "1e6", std::uint64_t{1'000'000}},
                             {"binning.samples", 0, "250 k", std::uint64_t{250'000}},
                             {"surface.generator.direction", 0, "−35 °", -35.0},
                             {"surface.generator.direction", 0, "-35 degrees", -35.0},
                             {"surface.generator.blur", 0, " 2.5 tx ", 2.5},
                             {"surface.generator.length", 0, "20, 90", std::vector<double>{20, 90}},
                             {"surface.generator.length", 1, "90 texels", std::vector<double>{40, 90}},
                             {"view.difference_range", 0, "none", std::monostate()},
                             {"grid.window", 2, "fit", std::string("fit")},
                             {"grid.window", 3, "0.25", std::vector<double>{-1, 1, -1, 0.25}}}) {
    const Parameter& parameter = field(typed.path);
    const std::vector<double> shown =
        typed.path == "grid.window" ? std::vector<double>{-1, 1, -1, 1} : std::vector<double>{40, 800};
    const auto edit = view::typed_edit(document, parameter, shown, typed.component, typed.text);
    ASSERT_TRUE(edit) << typed.text << ": " << edit.error().sentence;
    EXPECT_EQ(parameter.get(edit->document), typed.value) << typed.path << " " << typed.text;
  }
}

TEST(Entries, RefuseADecimalCommaAndWhatIsNoNumber) {
  const Document document;
  for (const std::string_view text : {"0,5", "", "abc", "0.1.2", "nan", "inf", "0x1p3"}) {
    EXPECT_FALSE(view::typed_edit(document, field("intrinsic_roughness"), {}, 0, text)) << text;
  }
  EXPECT_FALSE(view::typed_edit(document, field("grid.size"), {}, 0, "12.5"));
}

TEST(Sliders, GiveRoundValuesThatTheDocumentAllows) {
  const Document scratches = documents_of_all_kinds()[0];
  EXPECT_EQ(view::slid_value(scratches, field("intrinsic_roughness"), 0.0213987, false), ParameterValue(0.0214));
  EXPECT_EQ(view::slid_value(scratches, field("surface.generator.spread"), 12.3456, false), ParameterValue(12.3));
  EXPECT_EQ(view::slid_value(scratches, field("surface.generator.size"), 700.0, false),
            ParameterValue(std::uint64_t{512}));
  EXPECT_EQ(view::slid_value(scratches, field("binning.samples"), 1'234'567.0, false),
            ParameterValue(std::uint64_t{1'200'000}));
  EXPECT_EQ(view::slid_value(scratches, field("grid.size"), 400.0, false), ParameterValue(std::uint64_t{384}));
}

TEST(Sliders, ReachTheNextRoundValueByKey) {
  const Document scratches = documents_of_all_kinds()[0];
  const double a_hundredth_further = scratches.grid.size * 1.04;
  EXPECT_EQ(view::slid_value(scratches, field("grid.size"), a_hundredth_further, true),
            ParameterValue(std::uint64_t{384}));
  EXPECT_EQ(view::slid_value(scratches, field("surface.generator.size"), 1024 / 1.04, true),
            ParameterValue(std::uint64_t{512}));
}

TEST(Sliders, GiveUnfinishedEditsOfOneLabelUntilTheyAreLetGo) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  scene.frame(2);
  const view::Rectangle track = scene.widget("intrinsic_roughness.slider")->area;
  ImGuiIO& io = scene.stage.io();
  io.MousePos = track.center();
  scene.frame();
  io.MouseDown[0] = true;
  scene.frame();
  for (int k = 1; k < 6; ++k) {
    io.MousePos.x += 4;
    scene.frame();
  }
  io.MouseDown[0] = false;
  scene.frame();
  ASSERT_GE(scene.edits.size(), 3U);
  for (const view::Edit& edit : scene.edits) EXPECT_EQ(edit.label, "Roughness σ");
  for (std::size_t k = 0; k + 1 < scene.edits.size(); ++k) EXPECT_FALSE(scene.edits[k].finished);
  EXPECT_TRUE(scene.edits.back().finished);
}

TEST(Choices, TakeTheFieldsAlongThatStandAgainstThem) {
  Document noise = documents_of_all_kinds()[3];
  noise.surface.noise.size = noise.surface.scratches.size = 1000;
  ASSERT_FALSE(document_fault(noise));
  const auto edit = view::proposed_choice(noise, field("surface.source"), "scratches");
  ASSERT_TRUE(edit) << edit.error().sentence;
  EXPECT_EQ(edit->document.surface.scratches.size, 1024);
  EXPECT_EQ(edit->label, "Source to scratches");
}

TEST(Choices, TakeTheRadiusOfFlakesAlong) {
  Document noise = documents_of_all_kinds()[3];
  ASSERT_TRUE(field("surface.generator.size").set(noise, std::uint64_t{16}));
  noise.surface.noise.wavelengths = {4, 8};
  ASSERT_FALSE(document_fault(noise));
  const auto edit = view::proposed_choice(noise, field("surface.source"), "flakes");
  ASSERT_TRUE(edit) << edit.error().sentence;
  EXPECT_EQ(edit->document.surface.flakes.size, 16);
  EXPECT_EQ(edit->document.surface.flakes.radius, 4);
}

TEST(Choices, AskForAFileWhereNoneIsNamed) {  // a default document has no path
  InspectorScene scene({308, 1600});
  scene.open_all();
  scene.frame(2);
  scene.click("surface.source");
  scene.click("popup.file");
  EXPECT_TRUE(scene.browsed);
  EXPECT_THAT(scene.edits, IsEmpty());
}

TEST(Methods, KeepTheLastOneOn) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  scene.document.methods = {PndfMethod::binning};
  scene.frame(2);
  EXPECT_THAT(scene.widget("methods.binning")->reason, HasSubstr("stay on"));
  scene.click("methods.binning");
  EXPECT_THAT(scene.edits, IsEmpty());
  scene.click("methods.exact");
  EXPECT_EQ(scene.document.methods, (std::vector{PndfMethod::binning, PndfMethod::exact}));
}

TEST(Methods, SayWhyTheirSettingsHaveNoEffect) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  scene.frame(2);  // exact alone
  EXPECT_THAT(scene.widget("binning.samples")->reason, HasSubstr("binning method is off"));
  EXPECT_THAT(scene.widget("seed")->reason, HasSubstr("binning method is off"));
  EXPECT_THAT(scene.widget("exact.vertex_shift")->reason, IsEmpty());
  scene.click("exact.triangles.2");
  EXPECT_EQ(scene.document.surface.interpolation, Interpolation::linear);
  scene.frame();
  EXPECT_THAT(scene.widget("exact.vertex_shift")->reason, HasSubstr("32 triangles"));
}

TEST(Methods, ShowWhatAutoIsOnAMapOfFlakes) {
  const auto flakes = std::make_shared<const NormalMap>(8, 8, std::vector<glm::vec2>(64), Wrap::repeat, true);
  const Document document;
  EXPECT_EQ(view::interpolation_on(document, flakes.get()), Interpolation::constant);
  EXPECT_EQ(view::interpolation_on(document, nullptr), Interpolation::smooth);
  InspectorScene scene({308, 1600});
  scene.open_all();
  scene.surface = std::make_shared<view::SurfaceInUse>(
      view::SurfaceInUse{{Surface(flakes, Interpolation::constant), std::nullopt, nullptr}, {}, nullptr});
  scene.frame(2);
  EXPECT_THAT(scene.widget("exact.vertex_shift")->reason, HasSubstr("32 triangles"));
}

TEST(ResetArrows, StandWhereAFieldDiffersAndTakeItBack) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  scene.frame(2);
  EXPECT_EQ(scene.widget("intrinsic_roughness.reset"), nullptr);
  scene.document.intrinsic_roughness = 0.3;
  scene.frame();
  scene.click("intrinsic_roughness.reset");
  EXPECT_EQ(scene.document.intrinsic_roughness, scene.saved.intrinsic_roughness);
  scene.frame();
  EXPECT_EQ(scene.widget("intrinsic_roughness.reset"), nullptr);
}

TEST(FittedRanges, AreWhatAPersonTakesOver) {
  InspectorScene scene({308, 1600});
  scene.open_all();
  scene.fitted.window = glm::dvec4{-0.3, 0.4, -0.2, 0.1};
  scene.frame(2);
  scene.type("grid.window.smax", "0.5");
  EXPECT_EQ(scene.document.grid.window, (glm::dvec4{-0.3, 0.5, -0.2, 0.1}));
  scene.frame();
  scene.click("grid.window.fit");
  EXPECT_FALSE(scene.document.grid.window);
}

TEST(Inspector, BringsAControlToViewAndOpensItsSection) {
  InspectorScene scene({262, 650});
  scene.frame(2);
  ASSERT_EQ(scene.widget("view.map_colors"), nullptr) << "its section starts closed";
  EXPECT_FALSE(scene.inspector.bring_to_view("surface.path")) << "there is no file";
  EXPECT_FALSE(scene.inspector.bring_to_view("nonsense"));
  ASSERT_TRUE(scene.inspector.bring_to_view("view.map_colors"));
  scene.frame(3);
  const view::WidgetRecord::Entry* const entry = scene.widget("view.map_colors");
  ASSERT_NE(entry, nullptr);
  EXPECT_GE(entry->area.min.y, 28);
  EXPECT_LE(entry->area.max.y, 650);
  EXPECT_TRUE(scene.open["section.picture"]);
}

TEST(Inspector, OpensAndClosesItsSections) {
  InspectorScene scene({308, 930});
  scene.frame(2);
  ASSERT_NE(scene.widget("intrinsic_roughness"), nullptr);
  scene.click("section.surface");
  scene.frame();
  EXPECT_EQ(scene.widget("intrinsic_roughness"), nullptr);
  scene.click("section.surface");
  scene.frame();
  EXPECT_NE(scene.widget("intrinsic_roughness"), nullptr);
}

TEST(Reports, AreShownAsPeopleReadThem) {
  const NormalMap map(3, 2, std::vector<glm::vec2>(6), Wrap::repeat);
  ReadReport report;
  report.format = "PNG, 8-bit, RGB, 3 x 2";
  EXPECT_EQ(view::format_text(report, map), (view::FormatText{"3 × 2", "PNG, 8-bit, RGB"}));
  EXPECT_EQ(view::sentence_text("two texels repaired: `--green down` is right"),
            "Two texels repaired: “green down” is right.");
}

TEST(Readings, TurnNormalsIntoAngles) {
  EXPECT_NEAR(view::tilt_of({0.332, 0.434}), 33.1, 0.05);
  EXPECT_NEAR(view::azimuth_of({0.332, 0.434}), 52.6, 0.05);
  EXPECT_EQ(view::tilt_of({0, 2}), 90);
  EXPECT_EQ(view::azimuth_of({0, -1}), 270);
}

}  // namespace
}  // namespace glint
