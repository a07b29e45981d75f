#include "core/document/preset.h"

#include <clocale>
#include <locale>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/document/example.h"

namespace glint {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Document parsed(std::string_view text) {
  const Result<Document> document = parse_preset(text, "p.json");
  EXPECT_TRUE(document) << document.error().message();
  return document ? *document : Document();
}

// The message of the error, which must be one line about the file's content.
std::string fault_of(std::string_view text) {
  const Result<Document> document = parse_preset(text, "p.json");
  if (document) return "accepted";
  EXPECT_EQ(document.error().kind, ErrorKind::content);
  EXPECT_THAT(document.error().subject, StartsWith("p.json:"));
  EXPECT_THAT(document.error().sentence, Not(HasSubstr("\n")));
  EXPECT_LT(document.error().sentence.size(), 400U);
  return document.error().message();
}

// A preset whose third line is `line`, indented by two spaces.
std::string preset_with(const std::string& line) {
  return "{\n  \"glintscope\": \"preset\", \"version\": 1,\n  " + line + "\n}\n";
}

TEST(Preset, TellsWhatItsTextSays) {
  const Document document = parsed(R"({
    "glintscope": "preset", "version": 1, "name": "pinned",
    "surface": {"source": "noise", "wrap": "clamp", "interpolation": "linear",
                "generator": {"size": 128, "seed": 11, "spectrum": "gaussian", "rms_slope": 0.25,
                              "correlation_length": 6.5}},
    "footprint": {"center": [10.5, 20], "covariance": [4, 1, 9]},
    "intrinsic_roughness": 0.004,
    "methods": ["binning"], "binning": {"samples": 1e5},
    "grid": {"size": 64, "window": [-0.5, 0.5, -0.25, 0.75]},
    "seed": 3})");
  EXPECT_EQ(document.name, "pinned");
  EXPECT_EQ(document.surface.source, SurfaceSource::noise);
  EXPECT_EQ(document.surface.reading.wrap, Wrap::clamp);
  EXPECT_EQ(document.surface.interpolation, Interpolation::linear);
  EXPECT_EQ(document.surface.noise.size, 128);
  EXPECT_EQ(document.surface.noise.seed, 11U);
  EXPECT_EQ(document.surface.noise.spectrum, NoiseSettings::Spectrum::gaussian);
  EXPECT_EQ(document.surface.noise.rms_slope, 0.25);
  EXPECT_EQ(document.surface.noise.correlation_length, 6.5);
  EXPECT_EQ(document.footprint, (Footprint{{10.5, 20}, {4, 1, 9}}));
  EXPECT_EQ(document.intrinsic_roughness, 0.004);
  EXPECT_EQ(document.methods, std::vector{PndfMethod::binning});
  EXPECT_EQ(document.binning_samples, 100'000U);
  EXPECT_EQ(document.grid.size, 64);
  EXPECT_EQ(document.grid.window, glm::dvec4(-0.5, 0.5, -0.25, 0.75));
  EXPECT_EQ(document.seed, 3U);
}

TEST(Preset, WhatIsMissingHasItsDefault) {
  EXPECT_TRUE(parsed(R"({"version": 1, "glintscope": "preset"})") == Document());
  EXPECT_TRUE(parsed("\xEF\xBB\xBF{\"glintscope\": \"preset\", \"version\": 1, \"surface\": {}}\r\n") == Document());
}

TEST(Preset, KeepsTheWholeDocumentToTheLastBit) {
  const Document document = test::document_with_all_set();
  ASSERT_EQ(document.name, "worn \"steel\" \\ é");
  EXPECT_TRUE(parsed(preset_text(document)) == document) << preset_text(document);
  EXPECT_TRUE(parsed(preset_text(Document())) == Document());
}

TEST(Preset, KeepsEachFieldAlone) {
  for (const Parameter& p : parameters()) {
    SCOPED_TRACE(p.path);
    Document document;
    document.surface.path = "map.png";  // so that any source will do
    document.surface.scratches.size = document.surface.noise.size = document.surface.flakes.size = 1024;
    ASSERT_TRUE(p.set(document, test::other_value(p)));
    EXPECT_TRUE(parsed(preset_text(document)) == document) << preset_text(document);
    EXPECT_EQ(p.get(parsed(preset_text(document))), test::other_value(p));
  }
}

TEST(Preset, KeepsFilesThatAreHeights) {
  Document document;
  document.surface.source = SurfaceSource::file;
  document.surface.path = "a.png";
  EXPECT_THAT(preset_text(document), HasSubstr("\"height_scale\": null"));
  EXPECT_TRUE(parsed(preset_text(document)) == document);
  document.surface.reading.height_scale = -2.5;
  EXPECT_TRUE(parsed(preset_text(document)) == document);
}

TEST(Preset, IsWrittenReadablyInAFixedOrder) {
  Document document;
  document.name = "order";
  document.surface.source = SurfaceSource::file;
  document.surface.path = "maps/a.png";
  EXPECT_EQ(preset_text(document), R"({
  "glintscope": "preset",
  "version": 1,
  "name": "order",
  "surface": {
    "source": "file",
    "path": "maps/a.png",
    "range": "auto",
    "green": "up",
    "height_scale": null,
    "wrap": "repeat",
    "interpolation": "auto"
  },
  "footprint": {
    "center": [512, 512],
    "covariance": [25, 0, 25]
  },
  "intrinsic_roughness": 0.02,
  "methods": ["exact"],
  "exact": {
    "vertex_shift": false,
    "precision": "float"
  },
  "grid": {
    "size": 256,
    "window": "fit"
  }
}
)");
}

TEST(Recipe, HoldsOnlyWhatDeterminesPixels) {
  Document document;
  document.name = "not in it";
  document.surface.source = SurfaceSource::noise;
  document.surface.path = "not/in/it.png";
  document.surface.scratches.count = 5;
  EXPECT_EQ(recipe_of(document),
            R"({"glintscope":"preset","version":1,"surface":{"source":"noise","wrap":"repeat","interpolation":"auto",)"
            R"("generator":{"size":1024,"seed":7,"spectrum":"band","rms_slope":0.15,"wavelengths":[8,32]}},)"
            R"("footprint":{"center":[512,512],"covariance":[25,0,25]},"intrinsic_roughness":0.02,"methods":["exact"],)"
            R"("exact":{"vertex_shift":false,"precision":"float"},"grid":{"size":256,"window":"fit"}})");
}

TEST(Recipe, LeavesOutHowPicturesLookAndAPresetKeepsIt) {
  Document document;
  document.view = {ColorScale::linear, glm::dvec2(0.5, 20), 3.5, MapColors::slope, true};
  EXPECT_EQ(recipe_of(document), recipe_of(Document()));
  EXPECT_THAT(preset_text(document), HasSubstr(R"(  "view": {
    "density_scale": "linear",
    "density_range": [0.5, 20],
    "difference_range": 3.5,
    "map_colors": "slope",
    "elements": true
  })"));
  EXPECT_TRUE(parsed(preset_text(document)) == document);
  EXPECT_THAT(preset_text(Document()), Not(HasSubstr("view")));
}

TEST(Recipe, HoldsTheVertexShiftWhereSomethingIsShifted) {
  Document document;
  document.exact_vertex_shift = true;
  EXPECT_THAT(recipe_of(document), HasSubstr(R"("exact":{"vertex_shift":true,"precision":"float"})"));
  EXPECT_TRUE(*document_from_recipe(recipe_of(document), "recipe") == document);
  document.surface.interpolation = Interpolation::linear;
  EXPECT_THAT(recipe_of(document), Not(HasSubstr("vertex_shift")));
  EXPECT_THAT(preset_text(document), HasSubstr("\"vertex_shift\": true"));
}

TEST(Recipe, KeepsEveryFieldThatMatters) {
  const auto in_use = [](SurfaceSource source, NoiseSettings::Spectrum spectrum) {
    Document document = test::document_with_all_set();
    document.surface.source = source;
    document.surface.noise.spectrum = spectrum;
    return document;
  };
  std::size_t kept = 0;
  for (const auto source :
       {SurfaceSource::file, SurfaceSource::noise, SurfaceSource::scratches, SurfaceSource::flakes}) {
    for (const auto spectrum : {NoiseSettings::Spectrum::band, NoiseSettings::Spectrum::gaussian}) {
      const Document document = in_use(source, spectrum);
      const Result<Document> back = document_from_recipe(recipe_of(document), "recipe");
      ASSERT_TRUE(back) << back.error().message();
      EXPECT_EQ(recipe_of(*back), recipe_of(document));
      for (const Parameter& p : parameters()) {
        const bool matters = p.matters(document);
        EXPECT_EQ(p.get(*back), matters ? p.get(document) : p.default_value()) << p.path;
        kept += matters ? 1U : 0U;
      }
    }
  }
  // Always, file, any generator, noise, scratches, flakes.
  EXPECT_EQ(kept, 8U * 16U + 2U * 4U + 6U * 2U + 2U * 3U + 2U * 8U + 2U * 3U);
}

TEST(Recipe, EqualDocumentsGiveEqualBytes) {
  Document a;
  a.surface.source = SurfaceSource::file;
  a.surface.path = "maps//a.png";
  a.footprint.center.x = -0.0;
  Document b = a;
  b.surface.path = "maps/a.png";
  b.footprint.center.x = 0.0;
  ASSERT_TRUE(a == b);
  EXPECT_EQ(recipe_of(a), recipe_of(b));
  EXPECT_EQ(preset_text(a), preset_text(b));
}

TEST(Recipe, DiffersWhereThePixelsWould) {
  Document document;
  const std::string before = recipe_of(document);
  document.intrinsic_roughness = std::nextafter(document.intrinsic_roughness, 1);
  EXPECT_NE(recipe_of(document), before);
}

TEST(Recipe, IsWellFormedWhateverThePathHolds) {
  Document document;
  document.surface.source = SurfaceSource::file;
  document.surface.path = "a\"b\\c\n\xff.png";
  EXPECT_THAT(recipe_of(document), HasSubstr(R"("path":"a\"b\\c\n)"));
  EXPECT_THAT(recipe_of(document), Not(HasSubstr("\xff")));
}

TEST(PresetErrors, NameTheNearestFieldForAnUnknownOne) {
  EXPECT_EQ(fault_of(preset_with("\"sigmar\": 0.01")),
            "p.json:3:3: field 'sigmar': is unknown; the nearest field is 'intrinsic_roughness'");
  EXPECT_EQ(fault_of(preset_with("\"footprint\": {\"centre\": [1, 2]}")),
            "p.json:3:17: field 'footprint.centre': is unknown; the nearest field is 'footprint.center'");
  EXPECT_EQ(fault_of(preset_with("\"footprnt\": {\"center\": [1, 2]}")),
            "p.json:3:3: field 'footprnt': is unknown; the nearest field is 'footprint.center'");
  EXPECT_EQ(fault_of(preset_with("\"grid\": {\"size\": {\"cells\": 3}}")),
            "p.json:3:20: field 'grid.size': is an object; allowed: a whole number from 1 to 16384");
  EXPECT_EQ(fault_of(preset_with("\"grid\": 256")), "p.json:3:11: field 'grid': is 256; allowed: an object");
  EXPECT_EQ(
      fault_of(preset_with("\"grid.size\": 256")),
      "p.json:3:3: field 'grid.size': is no field's name; allowed: names without dots, one object inside the other");
  EXPECT_EQ(fault_of(preset_with("\"\": 256")),
            "p.json:3:3: field '': is no field's name; allowed: names without dots, one object inside the other");
}

TEST(PresetErrors, SayWhatIsAllowedWhereTheValueStands) {
  EXPECT_EQ(fault_of(preset_with("\"intrinsic_roughness\": 1.5")),
            "p.json:3:26: field 'intrinsic_roughness': is 1.5; allowed: a number from 1e-09 to 1");
  EXPECT_EQ(fault_of(preset_with("\"intrinsic_roughness\": \"rough\"")),
            "p.json:3:26: field 'intrinsic_roughness': is \"rough\"; allowed: a number from 1e-09 to 1");
  EXPECT_EQ(fault_of(preset_with("\"intrinsic_roughness\": true")),
            "p.json:3:26: field 'intrinsic_roughness': is true; allowed: a number from 1e-09 to 1");
  EXPECT_EQ(fault_of(preset_with("\"exact\": {\"vertex_shift\": 1}")),
            "p.json:3:29: field 'exact.vertex_shift': is 1; allowed: true or false");
  EXPECT_EQ(fault_of(preset_with("\"methods\": [true]")),
            "p.json:3:14: field 'methods': is [true]; allowed: a list of \"exact\", \"mixture\", \"lean\", \"auto\", "
            "\"binning\", at least "
            "one, none "
            "twice");
  EXPECT_EQ(fault_of(preset_with("\"intrinsic_roughness\": [0.1]")),
            "p.json:3:26: field 'intrinsic_roughness': is [0.1]; allowed: a number from 1e-09 to 1");
  EXPECT_EQ(fault_of(preset_with("\"grid\": {\"size\": -4}")),
            "p.json:3:20: field 'grid.size': is -4; allowed: a whole number from 1 to 16384");
  EXPECT_EQ(fault_of(preset_with("\"surface\":\n\t{\"wrap\":\n\"mirror\"}")),
            "p.json:5:1: field 'surface.wrap': is \"mirror\"; allowed: \"repeat\", \"clamp\"");
  EXPECT_EQ(
      fault_of(preset_with("\"methods\": [\"exact\", 3]")),
      "p.json:3:14: field 'methods': is [\"exact\", 3]; allowed: a list of \"exact\", \"mixture\", \"lean\", \"auto\", "
      "\"binning\", "
      "at least one, none "
      "twice");
  EXPECT_EQ(fault_of(preset_with("\"methods\": [[\"exact\"], {\"a\": [1]}]")),
            "p.json:3:14: field 'methods': is [[\"exact\"], {\"a\": [1]}]; allowed: a list of \"exact\", \"mixture\", "
            "\"lean\", \"auto\", "
            "\"binning\", at "
            "least one, none twice");
  EXPECT_THAT(fault_of(preset_with("\"methods\": [\"exact\", \"exactly\"]")), HasSubstr("is [\"exact\", \"exactly\"]"));
  EXPECT_THAT(fault_of(preset_with("\"name\": \"" + std::string(9000, 'x') + "\"")),
              StartsWith("p.json:3:11: field 'name': is \"xxxxxxxxxx"));
}

TEST(PresetErrors, CountCharactersNotBytes) {
  EXPECT_THAT(fault_of(preset_with("\"name\": \"é€😀\", \"seed\": -1")),
              StartsWith("p.json:3:26: field 'seed': is -1;"));
  EXPECT_THAT(fault_of(preset_with("\"name\": \"\\u00e9\\\"\", \"seed\": -1")),
              StartsWith("p.json:3:31: field 'seed': is -1;"));
}

TEST(PresetErrors, LocateFieldsThatDoNotFitEachOther) {
  EXPECT_THAT(fault_of(preset_with("\"footprint\": {\"covariance\": [1, 2, 1]}")),
              StartsWith("p.json:3:31: field 'footprint.covariance': "));
  EXPECT_THAT(fault_of(preset_with("\"surface\": {\"source\": \"file\"}")),
              StartsWith("p.json:3:14: field 'surface.path': is empty; allowed: the path of a file"));
  EXPECT_EQ(fault_of(preset_with("\"surface\": {\"generator\": {\"size\": 1000}}")),
            "p.json:3:37: field 'surface.generator.size': is 1000; allowed: a power of two from 32 for scratches");
  EXPECT_THAT(fault_of(preset_with("\"grid\": {\"window\": [1, -1, 0, 1]}")),
              StartsWith("p.json:3:22: field 'grid.window': is [1, -1, 0, 1]; allowed: "));
}

TEST(PresetErrors, RefuseAFieldGivenTwice) {
  EXPECT_EQ(fault_of(preset_with("\"seed\": 1, \"seed\": 1")),
            "p.json:3:14: field 'seed': is given twice; allowed: once");
  EXPECT_EQ(fault_of(preset_with("\"grid\": {\"size\": 1}, \"grid\": {}")),
            "p.json:3:24: field 'grid': is given twice; allowed: once");
}

TEST(PresetErrors, RefuseOtherFilesAndNewerVersions) {
  EXPECT_EQ(fault_of("{\"glintscope\": \"preset\",\n \"version\": 2, \"new\": 1}"),
            "p.json:2:13: field 'version': is 2; allowed: a version this build reads, 1 to 1");
  EXPECT_EQ(fault_of("{\"glintscope\": \"preset\"}"),
            "p.json:1:1: field 'version': is missing; allowed: a version this build reads, 1 to 1");
  EXPECT_THAT(fault_of("{\"glintscope\": \"preset\", \"version\": \"1\"}"), HasSubstr("'version': is \"1\"; allowed"));
  EXPECT_THAT(fault_of("{\"glintscope\": \"preset\", \"version\": 0}"), HasSubstr("'version': is 0; allowed"));
  EXPECT_EQ(fault_of("{\"glintscope\": \"scene\", \"version\": 1}"),
            "p.json:1:16: field 'glintscope': is \"scene\"; allowed: \"preset\"");
  EXPECT_THAT(fault_of("{}"), StartsWith("p.json:1:1: field 'glintscope': is missing; allowed: \"preset\""));
  EXPECT_THAT(fault_of(" [1]"), StartsWith("p.json:1:2: is not a preset; allowed: one object"));
  EXPECT_THAT(fault_of("\n3"), StartsWith("p.json:2:1: is not a preset; allowed: one object"));
}

TEST(PresetErrors, LocateWhatIsNotJson) {
  EXPECT_THAT(fault_of(""), StartsWith("p.json:1:1: is not JSON: unexpected end of input"));
  EXPECT_THAT(fault_of("{\"glintscope\": \"preset\",\n"),
              StartsWith("p.json:2:1: is not JSON: unexpected end of input"));
  EXPECT_THAT(fault_of(preset_with("\"seed\": nan")), StartsWith("p.json:3:11: is not JSON: invalid literal"));
  EXPECT_THAT(fault_of(preset_with("\"seed\": NaN")), StartsWith("p.json:3:11: is not JSON: invalid literal"));
  EXPECT_THAT(fault_of(preset_with("\"seed\": Infinity")), StartsWith("p.json:3:11: is not JSON: invalid literal"));
  EXPECT_THAT(fault_of(preset_with("\"seed\": 1,")), StartsWith("p.json:4:1: is not JSON: unexpected '}'"));
  EXPECT_THAT(fault_of(preset_with("\"seed\": 1,, \"name\": \"x\"")),
              StartsWith("p.json:3:13: is not JSON: unexpected ','"));
  EXPECT_THAT(fault_of(preset_with("\"seed\" 1")), StartsWith("p.json:3:10: is not JSON: unexpected number literal"));
  EXPECT_THAT(fault_of(preset_with("\"seed\": 01")), StartsWith("p.json:3:11: is not JSON: unexpected number literal"));
  EXPECT_THAT(fault_of(preset_with("\"seed\": 1 // why")), StartsWith("p.json:3:13: is not JSON: invalid literal"));
  EXPECT_THAT(fault_of(preset_with("\"seed\": 1e999")), StartsWith("p.json:3:11: is not JSON: number overflow"));
  EXPECT_THAT(fault_of(preset_with("\"seed\": 0,5")),
              StartsWith("p.json:3:13: is not JSON: unexpected number literal"));
  EXPECT_THAT(fault_of(preset_with("\"name\": \"open")), StartsWith("p.json:3:11: is not JSON: invalid string"));
  EXPECT_THAT(fault_of(preset_with("\"seed\": 1") + "x"), StartsWith("p.json:5:1: is not JSON: invalid literal"));
  EXPECT_THAT(fault_of(preset_with("\"seed\": 1") + " {}"), StartsWith("p.json:5:2: is not JSON: unexpected '{'"));
}

TEST(PresetErrors, LocateWhatIsNotUtf8) {
  EXPECT_EQ(fault_of(preset_with("\"name\": \"é\xff\"")), "p.json:3:13: is not UTF-8 text (byte 0xff)");
  EXPECT_EQ(fault_of("\xff\xfe{"), "p.json:1:1: is not UTF-8 text (byte 0xff)");
  EXPECT_EQ(fault_of("{\"\xc0\xaf"), "p.json:1:3: is not UTF-8 text (byte 0xc0)");      // overlong
  EXPECT_EQ(fault_of("{\"\xed\xa0\x80"), "p.json:1:3: is not UTF-8 text (byte 0xed)");  // surrogate
  EXPECT_EQ(fault_of("{\"\xe2\x82"), "p.json:1:3: is not UTF-8 text (byte 0xe2)");      // cut off
}

TEST(PresetErrors, RefuseDeepNesting) {
  const std::string many(100'000, '[');
  EXPECT_EQ(fault_of(preset_with("\"methods\": " + many)), "p.json:3:21: is nested deeper than 8 levels");
  std::string objects;
  for (int k = 0; k < 50'000; ++k) objects += "{\"a\":";
  EXPECT_EQ(fault_of(objects), "p.json:1:41: is nested deeper than 8 levels");
}

class CommaPunctuation : public std::numpunct<char> {
  [[nodiscard]] char do_decimal_point() const override { return ','; }
  [[nodiscard]] char do_thousands_sep() const override { return '.'; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

TEST(Preset, ADecimalCommaInTheLocaleChangesNothing) {
  const Document document = test::document_with_all_set();
  const std::string text = preset_text(document);
  const std::string recipe = recipe_of(document);
  const std::string schema = preset_schema();
  const std::string c_before = std::setlocale(LC_ALL, nullptr);
  const std::locale cpp_before = std::locale::global(std::locale(std::locale::classic(), new CommaPunctuation));
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE"}) {
    if (std::setlocale(LC_ALL, name)) break;  // where none is installed the C++ locale alone has the comma
  }
  EXPECT_EQ(preset_text(document), text);
  EXPECT_EQ(recipe_of(document), recipe);
  EXPECT_EQ(preset_schema(), schema);
  EXPECT_TRUE(parsed(text) == document);
  EXPECT_THAT(fault_of(preset_with("\"intrinsic_roughness\": 1234.5")), HasSubstr("is 1234.5; allowed"));
  std::locale::global(cpp_before);
  std::setlocale(LC_ALL, c_before.c_str());
}

}  // namespace
}  // namespace glint
