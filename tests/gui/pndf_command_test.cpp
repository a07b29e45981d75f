// glintscope pndf and study against closed forms, and the shape of what they write.

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/image/normal_map_writer.h"
#include "tests/gui/run_program.h"
#include "tests/temporary_folder.h"
#include "tests/test_data.h"

namespace glint::test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

double gaussian(double s, double t, double sigma) {
  return std::exp(-(s * s + t * t) / (2 * sigma * sigma)) / (2 * std::numbers::pi * sigma * sigma);
}

std::vector<std::vector<double>> numbers_by_line(const std::string& text) {
  std::vector<std::vector<double>> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    lines.emplace_back(std::istream_iterator<double>(words), std::istream_iterator<double>());
  }
  return lines;
}

TEST(PndfCommand, QueriesOfTheFlatOracleAreItsGaussian) {
  const ProgramRun run =
      run_glintscope({"pndf", "--preset", "flat-oracle", "--method", "exact", "--sigma-r", "0.05", "--queries", "-"},
                     {"0 0\n0.03 -0.04\n\n\t-0.1 0.2 \r\n", {}, 0});
  EXPECT_EQ(run.status, 0) << run.err;
  const auto lines = numbers_by_line(run.out);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_NEAR(lines[0][0] / gaussian(0, 0, 0.05), 1, 1e-9);
  EXPECT_NEAR(lines[1][0] / gaussian(0.03, 0.04, 0.05), 1, 1e-9);
  EXPECT_NEAR(lines[2][0] / gaussian(0.1, 0.2, 0.05), 1, 1e-9);
  EXPECT_EQ(run.out.find(','), std::string::npos);
  EXPECT_THAT(run.out, ::testing::MatchesRegex("([0-9]\\.[0-9]{9}e[-+][0-9]{2}\n){3}"));
}

TEST(PndfCommand, QueriesPrintTheMethodsInTheOrderAsked) {
  const std::string input = "0 0\n";
  const auto one = [&](const char* methods) {
    return numbers_by_line(
        run_glintscope({"pndf", "--preset", "flat-oracle", "--method", methods, "--queries", "-"}, {input, {}, 0})
            .out)[0];
  };
  const auto both = one("binning,exact");
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[1], one("exact")[0]);
  EXPECT_EQ(both[0], one("binning")[0]);
}

TEST(PndfCommand, VertexShiftChangesTheExactValuesAndStandsInTheRecipe) {
  const auto values = [](std::vector<std::string> more) {
    std::vector<std::string> words = {"pndf", "--preset", "isotropic-noise", "--pixel",   "500,500", "--radius",
                                      "2",    "--method", "exact",           "--queries", "-"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramRun run = run_glintscope(words, {"0.02 0.03\n-0.05 0.1\n", {}, 0});
    EXPECT_EQ(run.status, 0) << run.err;
    return run.out;
  };
  EXPECT_NE(values({"--vertex-shift"}), values({}));
  EXPECT_EQ(values({"--vertex-shift=false"}), values({}));
  EXPECT_EQ(values({"--vertex-shift", "--surface", "linear"}), values({"--surface", "linear"}));

  const TemporaryFolder folder;
  const std::string first = folder / "first.exr";
  const std::string second = folder / "second.exr";
  ASSERT_EQ(run_glintscope({"pndf", "--preset", "isotropic-noise", "--pixel", "500,500", "--radius", "1", "--size",
                            "16", "--method", "exact", "--vertex-shift", "-o", first})
                .status,
            0);
  ASSERT_EQ(run_glintscope({"pndf", "--preset", first, "-o", second}).status, 0);
  EXPECT_EQ(text_of(first), text_of(second));
}

TEST(PndfCommand, AMalformedQueryLineIsNamedByItsNumber) {
  for (const char* input :
       {"0 0\n0.1\n", "0 0\n0.1 0.2 0.3\n", "0 0\n0.1,0.2\n", "0 0\nnan 0\n", "0 0\n1e999 0\n", "0 0\nx y\n"}) {
    const ProgramRun run = run_glintscope({"pndf", "--preset", "flat-oracle", "--queries", "-"}, {input, {}, 0});
    EXPECT_EQ(run.status, 2) << input;
    EXPECT_THAT(run.err, HasSubstr("line 2"));
    EXPECT_EQ(run.out, "");
  }
}

TEST(PndfCommand, QueriesOutsideTheDiskAreAnsweredAndCounted) {
  const ProgramRun run = run_glintscope({"pndf", "--preset", "flat-oracle", "--sigma-r", "0.5", "--queries", "-"},
                                        {"0 0\n1.2 0\n", {}, 0});
  EXPECT_EQ(run.status, 0);
  EXPECT_NEAR(numbers_by_line(run.out)[1][0] / gaussian(1.2, 0, 0.5), 1, 1e-8);
  EXPECT_THAT(run.err, HasSubstr("1 of 2 queries"));
  EXPECT_EQ(run_glintscope({"pndf", "--preset", "flat-oracle", "--quiet", "--queries", "-"}, {"1.2 0\n", {}, 0}).err,
            "");
}

// The error in units of the peak, of images in that precision.
void expect_flat_oracle_image(const std::string& precision, double error) {
  const TemporaryFolder folder;
  const std::string out = folder / "d.exr";
  const ProgramRun run =
      run_glintscope({"pndf", "--preset", "flat-oracle", "--sigma-r", "0.05", "--method", "exact,binning", "--size",
                      "40", "--window", "-0.2,0.2,-0.1,0.3", "--precision", precision, "-o", out});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto input = OIIO::ImageInput::open(out);
  ASSERT_TRUE(input);
  const OIIO::ImageSpec spec = input->spec();
  std::vector<float> pixels(40 * 40 * 3);
  ASSERT_EQ(spec.nchannels, 3);
  ASSERT_TRUE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data()));
  const int exact = spec.channelindex("D.exact");
  ASSERT_GE(exact, 0);
  ASSERT_GE(spec.channelindex("D.binning"), 0);
  ASSERT_GE(spec.channelindex("D.binning.error"), 0);
  // Row 0 holds the largest t, column 0 the smallest s.
  for (const auto& [row, column] : {std::pair{20, 5}, {20, 20}, {35, 17}}) {
    const double s = -0.2 + (column + 0.5) * 0.01;
    const double t = 0.3 - (row + 0.5) * 0.01;
    const float stored = pixels[static_cast<std::size_t>((row * 40 + column) * 3 + exact)];
    EXPECT_NEAR(stored / gaussian(0, 0, 0.05), gaussian(s, t, 0.05) / gaussian(0, 0, 0.05), error)
        << precision << " " << row << " " << column;
  }
}

TEST(PndfCommand, ImageHoldsTheFlatOraclesGaussianInBothPrecisions) {
  expect_flat_oracle_image("double", 1e-6);
  expect_flat_oracle_image("float", 1e-4);
}

TEST(PndfCommand, QueriesAreInDoublePrecisionUnlessAskedOtherwise) {
  const std::vector<std::string> words = {"pndf", "--preset", "flat-oracle", "--quiet", "--queries", "-"};
  std::vector<std::string> in_double = words;
  in_double.insert(in_double.end(), {"--precision", "double"});
  std::vector<std::string> in_float = words;
  in_float.insert(in_float.end(), {"--precision", "float"});
  const std::string unasked = run_glintscope(words, {"0.01 0\n", {}, 0}).out;
  EXPECT_EQ(unasked, run_glintscope(in_double, {"0.01 0\n", {}, 0}).out);
  EXPECT_NE(unasked, run_glintscope(in_float, {"0.01 0\n", {}, 0}).out);
}

TEST(PndfCommand, TheInstructionSetCanBeForcedAndAnUnknownOneIsNamed) {
  const std::vector<std::string> words = {"study", "--preset", "flat-oracle", "--method",
                                          "exact", "--size",   "16",          "--json"};
  std::vector<std::string> scalar = words;
  scalar.insert(scalar.end(), {"--isa", "scalar"});
  const ProgramRun run = run_glintscope(scalar);
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(Json::parse(run.out)["isa"], "scalar");
  std::vector<std::string> unknown = words;
  unknown.insert(unknown.end(), {"--isa", "neon"});
  const ProgramRun refused = run_glintscope(unknown);
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("glintscope: --isa: 'neon' is not something this processor has: auto, scalar"));
}

TEST(PndfCommand, EqualInputsGiveEqualBytesForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  for (const std::string extension : {".exr", ".png"}) {
    for (const char* threads : {"1", "2"}) {
      const ProgramRun run =
          run_glintscope({"pndf", "--preset", "isotropic-noise", "--pixel", "500,500", "--radius", "2", "--size", "64",
                          "--method", "exact,binning", "--threads", threads, "-o", folder / (threads + extension)});
      ASSERT_EQ(run.status, 0) << run.err;
    }
    EXPECT_EQ(text_of(folder / ("1" + extension)), text_of(folder / ("2" + extension)));
  }
}

TEST(PndfCommand, AnExrsRecipeRestoresTheDocument) {
  const TemporaryFolder folder;
  const std::string first = folder / "first.exr";
  const std::string second = folder / "second.exr";
  ASSERT_EQ(run_glintscope({"pndf", "--preset", "isotropic-noise", "--footprint", "99.5,11.25,2,0.5,3", "--sigma-r",
                            "0.031", "--surface", "linear", "--size", "33", "--method", "binning,exact", "--samples",
                            "5000", "--seed", "9", "-o", first})
                .status,
            0);
  ASSERT_EQ(run_glintscope({"pndf", "--preset", first, "-o", second}).status, 0);
  EXPECT_EQ(text_of(first), text_of(second));
}

TEST(PndfCommand, RefusesToOverwriteItsInput) {
  const TemporaryFolder folder;
  const std::string map = folder / "map.exr";
  ASSERT_EQ(run_glintscope({"generate", "noise", "--size", "32", "--wavelengths", "8,16", "-o", map}).status, 0);
  const std::string before = text_of(map);
  const ProgramRun run = run_glintscope({"pndf", "--map", map, "-o", map});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("the output is the input"));
  EXPECT_EQ(text_of(map), before);
}

TEST(PndfCommand, AFootprintOutsideAMapWrapsOrIsRefused) {
  const TemporaryFolder folder;
  const std::string map = folder / "map.exr";
  ASSERT_EQ(run_glintscope({"generate", "noise", "--size", "32", "--wavelengths", "8,16", "-o", map}).status, 0);
  const auto ask = [&](const char* pixel, const char* wrap) {
    return run_glintscope({"pndf", "--map", map, "--pixel", pixel, "--radius", "1.5", "--wrap", wrap, "--queries", "-"},
                          {"0.02 0.03\n", {}, 0});
  };
  EXPECT_EQ(ask("37,-5", "repeat").out, ask("5,27", "repeat").out);
  EXPECT_EQ(ask("37,-5", "clamp").status, 2);
  EXPECT_EQ(ask("5,27", "clamp").status, 0);
}

TEST(PndfCommand, WithoutAFootprintTheMiddleOfTheMapIsTaken) {
  const TemporaryFolder folder;
  const std::string map = folder / "map.exr";
  ASSERT_EQ(run_glintscope({"generate", "noise", "--size", "32", "--wavelengths", "8,16", "-o", map}).status, 0);
  const Json json = Json::parse(run_glintscope({"pndf", "--map", map, "--size", "16", "--json", "--quiet"}).out);
  EXPECT_EQ(json["footprint"], Json({16.0, 16.0, 25.0, 0.0, 25.0}));
}

TEST(PndfCommand, JsonHasTheDocumentedKeys) {
  const ProgramRun run = run_glintscope(
      {"pndf", "--preset", "flat-oracle", "--method", "exact,binning", "--samples", "1000", "--size", "64", "--json"});
  const Json json = Json::parse(run.out);
  ASSERT_EQ(json["results"].size(), 2U);
  const Json& exact = json["results"][0];
  EXPECT_EQ(exact["method"], "exact");
  EXPECT_NEAR(exact["integral"].get<double>(), 1, 1e-4);
  EXPECT_NEAR(exact["mean"][0].get<double>(), 0, 1e-5);
  EXPECT_GT(exact["image_ms"].get<double>(), 0);
  EXPECT_GT(json["results"][1]["own_noise"].get<double>(), 0);
  const ProgramRun queries =
      run_glintscope({"pndf", "--preset", "flat-oracle", "--json", "--queries", "-"}, {"0 0\n0.1 0\n", {}, 0});
  EXPECT_EQ(Json::parse(queries.out)["results"][0]["values"].size(), 2U);
}

TEST(PndfCommand, WideningIsSaid) {
  const ProgramRun run = run_glintscope(
      {"pndf", "--preset", "flat-oracle", "--sigma-r", "0.001", "--size", "16", "--window", "-0.5,0.5,-0.5,0.5"});
  EXPECT_THAT(run.err, HasSubstr("widened"));
}

TEST(PndfCommand, ConstantMapsAnswerWithTheirClosedFormForEverySurface) {
  const TemporaryFolder folder;
  const NormalMap map(5, 3, std::vector<glm::vec2>(15, {0.125F, -0.25F}), Wrap::repeat);
  ASSERT_TRUE(write_normal_map(folder / "c.exr", map));
  for (const char* surface : {"linear", "smooth", "constant"}) {
    const ProgramRun run = run_glintscope({"pndf", "--map", folder / "c.exr", "--range", "signed", "--surface", surface,
                                           "--sigma-r", "0.01", "--footprint", "2,1,400,0,90", "--queries", "-"},
                                          {"0.13 -0.26\n", {}, 0});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NEAR(numbers_by_line(run.out)[0][0] / gaussian(0.005, 0.01, 0.01), 1, 1e-6) << surface;  // the file's floats
  }
}

TEST(StudyCommand, JsonHasTheDocumentedKeys) {
  const ProgramRun run = run_glintscope({"study",
                                         "--preset",
                                         "flat-oracle",
                                         "--method",
                                         "exact,binning",
                                         "--samples",
                                         "2000",
                                         "--size",
                                         "32",
                                         "--window",
                                         "-0.2,0.2,-0.2,0.2",
                                         "--pixel",
                                         "30,30",
                                         "--radius",
                                         "1",
                                         "--surface",
                                         "linear",
                                         "--repeat",
                                         "2",
                                         "--threads",
                                         "1",
                                         "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_FALSE(json["machine"].get<std::string>().empty());
  EXPECT_TRUE(json["isa"].is_string());
  EXPECT_EQ(json["threads"], 1);
  EXPECT_EQ(json["reference"]["surface"], "linear");
  EXPECT_EQ(json["reference"]["precision"], "double");
  EXPECT_TRUE(json["reference"]["relative_l1"].is_number());
  ASSERT_EQ(json["results"].size(), 2U);
  for (const Json& result : json["results"]) {
    for (const char* key :
         {"method", "settings", "surface", "footprint", "build_ms", "bytes", "image_ms", "image_size", "query_us",
          "query_uniform_us", "relative_l1", "peak_error", "energy_error", "own_noise", "error_kind", "reference"}) {
      EXPECT_TRUE(result.contains(key)) << key;
    }
    EXPECT_EQ(result["footprint"].size(), 5U);
    EXPECT_EQ(result["image_size"], 32);
    EXPECT_EQ(result["error_kind"], "measured");
  }
  EXPECT_EQ(json["results"][0]["settings"]["precision"], "float");
  EXPECT_LT(json["results"][0]["relative_l1"].get<double>(), 1e-4);
  EXPECT_EQ(json["results"][1]["settings"]["samples"], 2000);
}

TEST(PndfCommand, RealMapsAreReadAndTheirNotesSaid) {
  GLINT_NEEDS_DATA();
  const std::string map = data_directory() / "normals" / "brick_2048.jpg";
  const std::vector<std::string> words = {"pndf",     "--map", map,      "--pixel", "1000,1000",
                                          "--radius", "2",     "--size", "32"};
  const ProgramRun run = run_glintscope(words);
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.err, HasSubstr("--green down"));  // it is a DirectX map
  std::vector<std::string> quiet = words;
  quiet.emplace_back("--quiet");
  EXPECT_EQ(run_glintscope(quiet).err, "");
}

TEST(MixtureFindings, AreSaidAndStandInTheJson) {
  const std::vector<std::string> words{"pndf",    "--preset",  "isotropic-noise", "--method", "exact,mixture",
                                       "--pixel", "200,200",   "--radius",        "1",        "--size",
                                       "16",      "--sigma-r", "0.001",           "--json"};
  const ProgramRun run = run_glintscope(words);
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_FALSE(json["results"][0].contains("findings"));
  const Json& findings = json["results"][1]["findings"];
  ASSERT_FALSE(findings.empty());
  const std::string first = findings[0];
  EXPECT_THAT(first, HasSubstr("sigma_r 0.001 is small against the map's slope"));
  EXPECT_THAT(run.err, HasSubstr("mixture: " + first));

  std::vector<std::string> quiet = words;
  quiet.emplace_back("--quiet");
  const ProgramRun silent = run_glintscope(quiet);
  EXPECT_EQ(silent.err, "");
  EXPECT_EQ(Json::parse(silent.out)["results"][1]["findings"], findings);

  std::vector<std::string> values = quiet;
  values.insert(values.end(), {"--queries", "-"});
  EXPECT_EQ(Json::parse(run_glintscope(values, {"0 0\n", {}, 0}).out)["results"][1]["findings"], findings);
}

TEST(MixtureFindings, AreEmptyInTheJsonWhereThereAreNone) {
  const ProgramRun run =
      run_glintscope({"study", "--preset", "isotropic-noise", "--method", "mixture", "--pixel", "200,200", "--radius",
                      "1", "--size", "16", "--sigma-r", "0.05", "--repeat", "1", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(Json::parse(run.out)["results"][0]["findings"], Json::array());
}

// The reader of a file already says that its steps show: once is enough.
TEST(MixtureFindings, DoNotRepeatTheReader) {
  GLINT_NEEDS_DATA();
  const ProgramRun run = run_glintscope(
      {"pndf", "--map", (data_directory() / "normals" / "dented_metal_512.png").string(), "--method", "mixture",
       "--sigma-r", "0.005", "--size", "16", "--pixel", "200,200", "--radius", "1", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("which is more than the intrinsic roughness"));
  EXPECT_THAT(run.err, ::testing::Not(HasSubstr("8-bit step")));
  const std::string first = Json::parse(run.out)["results"][0]["findings"][0];
  EXPECT_THAT(first, HasSubstr("8-bit step of the map, 0.0078"));
}

}  // namespace
}  // namespace glint::test
