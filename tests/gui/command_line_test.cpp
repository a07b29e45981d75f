// The words of the command line: help, version, errors of one line, exit statuses, generate and presets.

#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gui/run_program.h"
#include "tests/temporary_folder.h"

namespace glint::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// One line that begins with the program's name.
void expect_one_error_line(const ProgramRun& run) {
  EXPECT_THAT(run.err, StartsWith("glintscope: "));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_EQ(run.out, "");
}

TEST(CommandLine, HelpNamesEveryCommand) {
  const ProgramRun run = run_glintscope({"--help"});
  EXPECT_EQ(run.status, 0);
  for (const char* command : {"pndf", "study", "generate", "presets", "screenshot"})
    EXPECT_THAT(run.out, HasSubstr(command));
  EXPECT_EQ(run.err, "");
}

TEST(CommandLine, HelpStandsOnEveryLevel) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--help"},
                                                {"pndf", "--help"},
                                                {"study", "--help"},
                                                {"generate", "noise", "--help"},
                                                {"generate", "scratches", "--help"},
                                                {"generate", "flakes", "--help"},
                                                {"presets", "show", "--help"}}) {
    const ProgramRun run = run_glintscope(words);
    EXPECT_EQ(run.status, 0) << words.front();
    EXPECT_THAT(run.out, HasSubstr("Usage:"));
    EXPECT_EQ(run.err, "");
  }
}

TEST(CommandLine, VersionIsTheProjectsOwn) {
  EXPECT_EQ(run_glintscope({"--version"}).out, "glintscope " GLINTSCOPE_VERSION "\n");
}

struct BadWords {
  std::vector<std::string> words;
  const char* said;
};

TEST(CommandLine, WordsThatAreOffEndWithStatusTwoAndOneSentence) {
  const std::vector<std::string> flat = {"pndf", "--preset", "flat-oracle"};
  const std::vector<BadWords> cases = {
      {{"pndf"}, "--map FILE or --preset NAME"},
      {{"nonsense"}, "nonsense"},
      {{"pndf", "--nonsense"}, "--nonsense"},
      {{"pndf", "--map", "a.png", "--preset", "b"}, "--preset"},
      {{"pndf", "--preset", "nope"}, "known: car-paint-flakes, flat-oracle, isotropic-noise, scratched-steel"},
      {{"pndf", "--preset", "flat-oracle", "--sigma-r", "-1"}, "--sigma-r"},
      {{"pndf", "--preset", "flat-oracle", "--sigma-r", "0"}, "allowed: a number from 1e-09 to 1"},
      {{"pndf", "--preset", "flat-oracle", "--sigma-r", "1.5"}, "from 1e-09 to 1"},
      {{"pndf", "--preset", "flat-oracle", "--sigma-r", "nan"}, "--sigma-r"},
      {{"pndf", "--preset", "flat-oracle", "--sigma-r", "0,02"}, "--sigma-r"},
      {{"pndf", "--preset", "flat-oracle", "--footprint", "1,2,3"}, "five numbers"},
      {{"pndf", "--preset", "flat-oracle", "--footprint", "1,2,3,9,1"}, "positive definite"},
      {{"pndf", "--preset", "flat-oracle", "--footprint", "1,2,inf,0,1"}, "finite"},
      {{"pndf", "--preset", "flat-oracle", "--footprint", "1,2,1e12,0,1"}, "100000 texels"},
      {{"pndf", "--preset", "flat-oracle", "--pixel", "1"}, "--pixel"},
      {{"pndf", "--preset", "flat-oracle", "--pixel", "1,2", "--radius", "0"}, "--radius"},
      {{"pndf", "--preset", "flat-oracle", "--pixel", "1,2", "--radius", "-3"}, "--radius"},
      {{"pndf", "--preset", "flat-oracle", "--pixel", "1,2", "--radius", "1e6"}, "at most 100000"},
      {{"pndf", "--preset", "flat-oracle", "--radius", "2"}, "--pixel"},
      {{"pndf", "--preset", "flat-oracle", "--method", "magic"},
       "\"exact\", \"mixture\", \"lean\", \"auto\", \"binning\""},
      {{"pndf", "--preset", "flat-oracle", "--method", "exact,exact"}, "twice"},
      {{"pndf", "--preset", "flat-oracle", "--size", "0"}, "--size"},
      {{"pndf", "--preset", "flat-oracle", "--size", "16385"}, "16384"},
      {{"pndf", "--preset", "flat-oracle", "--window", "0.5,-0.5,-1,1"}, "--window"},
      {{"pndf", "--preset", "flat-oracle", "--window", "0,1"}, "--window"},
      {{"pndf", "--preset", "flat-oracle", "--samples", "0"}, "--samples"},
      {{"pndf", "--preset", "flat-oracle", "--vertex-shift=maybe"}, "--vertex-shift"},
      {{"pndf", "--preset", "flat-oracle", "--threads", "0"}, "--threads"},
      {{"pndf", "--preset", "flat-oracle", "--triangles", "3"}, "2 or 32"},
      {{"pndf", "--preset", "flat-oracle", "--triangles", "2", "--surface", "smooth"}, "--triangles"},
      {{"pndf", "--preset", "flat-oracle", "--triangles", "32", "--surface", "constant"}, "--triangles"},
      {{"pndf", "--preset", "flat-oracle", "-o", "out.gif"}, ".exr or .png"},
      {{"pndf", "--preset", "flat-oracle", "-o", "/no/such/folder/out.exr"}, "out.exr"},
      {{"pndf", "--preset", "flat-oracle", "--queries", "-", "-o", "out.exr"}, "--queries"},
      {{"pndf", "--preset", "flat-oracle", "-o", ""}, ".exr or .png"},
      {{"pndf", "--preset", "flat-oracle", "--queries", ""}, "queries"},
      {{"pndf", "--preset", "flat-oracle", "--footprint", ""}, "five numbers"},
      {{"pndf", "--preset", "flat-oracle", "--size", "8", "--size", "9"}, "--size"},
      {{"study", "--preset", "flat-oracle", "--repeat", "0"}, "--repeat"},
      {{"study", "--preset", "flat-oracle", "--reference", "round"}, "--reference"},
      {{"generate"}, "subcommand"},
      {{"generate", "noise"}, "--output"},
      {{"generate", "noise", "-o", "a.exr", "--rms-slope", "nan"}, "--rms-slope"},
      {{"generate", "noise", "-o", "a.exr", "--size", "0"}, "--size"},
      {{"generate", "noise", "-o", "a.jpg"}, ".exr or .png"},
      {{"generate", "noise", "-o", "a.exr", "--wavelengths", "32,8"}, "--wavelengths"},
      {{"generate", "noise", "-o", "a.exr", "--spectrum", "band", "--correlation-length", "8"}, "--correlation-length"},
      {{"generate", "scratches", "-o", "a.exr", "--count", "-1"}, "--count"},
      {{"generate", "flakes", "-o", "a.exr", "--alpha", "-1"}, "--alpha"},
      {{"generate", "flakes", "-o", "a.exr", "--size", "16"}, "--radius"},
      {{"presets", "show", "nope"}, "known:"},
  };
  for (const BadWords& bad : cases) {
    const ProgramRun run = run_glintscope(bad.words);
    std::string shown;
    for (const std::string& word : bad.words) shown += word + " ";
    SCOPED_TRACE(shown);
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, HasSubstr(bad.said));
    expect_one_error_line(run);
  }
}

TEST(CommandLine, WhatAFileHoldsEndsWithStatusOne) {
  const TemporaryFolder folder;
  std::ofstream(folder / "text.png") << "this is no picture";
  std::ofstream(folder / "wrong.json") << "{\"glintscope\": \"preset\", \"version\": 1,\n \"intrinsic_roughness\": 7}";
  for (const std::vector<std::string>& words : {std::vector<std::string>{"pndf", "--map", folder / "missing.png"},
                                                {"pndf", "--map", folder / "text.png"},
                                                {"pndf", "--preset", folder / "wrong.json"},
                                                {"presets", "check", folder / "wrong.json"}}) {
    const ProgramRun run = run_glintscope(words);
    SCOPED_TRACE(words.back());
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.err, HasSubstr(words.back()));
    expect_one_error_line(run);
  }
  EXPECT_THAT(run_glintscope({"presets", "check", folder / "wrong.json"}).err, HasSubstr("wrong.json:2:"));
}

TEST(CommandLine, ShippedPresetsAreListedShownAndRight) {
  const ProgramRun list = run_glintscope({"presets", "list"});
  EXPECT_EQ(list.status, 0);
  for (const std::string name : {"car-paint-flakes", "flat-oracle", "isotropic-noise", "scratched-steel"}) {
    EXPECT_THAT(list.out, HasSubstr(name));
    const ProgramRun show = run_glintscope({"presets", "show", name});
    EXPECT_EQ(show.status, 0);
    const TemporaryFolder folder;
    std::ofstream(folder / "copy.json") << show.out;
    EXPECT_EQ(run_glintscope({"presets", "check", folder / "copy.json"}).status, 0);
  }
}

TEST(CommandLine, GenerateIsRepeatableAndSeeded) {
  const TemporaryFolder folder;
  const auto generate = [&](const char* name, const char* seed, const char* kind) {
    return run_glintscope({"generate", kind, "--size", "64", "--seed", seed, "-o", folder / name, "--quiet"});
  };
  for (const char* kind : {"noise", "scratches", "flakes"}) {
    EXPECT_EQ(generate("a.exr", "3", kind).status, 0);
    EXPECT_EQ(generate("b.exr", "3", kind).err, "");
    generate("c.exr", "4", kind);
    EXPECT_EQ(text_of(folder / "a.exr"), text_of(folder / "b.exr"));
    EXPECT_NE(text_of(folder / "a.exr"), text_of(folder / "c.exr"));
  }
}

TEST(CommandLine, GeneratedMapsAreReadBackByPndf) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_glintscope({"generate", "noise", "--size", "64", "--rms-slope", "0.1", "--correlation-length", "6",
                            "-o", folder / "map.png"})
                .status,
            0);
  const ProgramRun run = run_glintscope({"pndf", "--map", folder / "map.png", "--size", "32", "--sigma-r", "0.05"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out, HasSubstr("exact"));
}

TEST(CommandLine, ADecimalCommaInTheLocaleChangesNothing) {
  const RunOptions german{"0.01 0.02\n", {"LC_ALL=de_DE.UTF-8"}, 0};
  const RunOptions plain{"0.01 0.02\n", {"LC_ALL=C"}, 0};
  const std::vector<std::string> words = {"pndf", "--preset", "flat-oracle", "--sigma-r", "0.04", "--queries", "-"};
  EXPECT_EQ(run_glintscope(words, german).out, run_glintscope(words, plain).out);
}

TEST(CommandLine, CtrlCEndsSoonWithStatus130AndLeavesTheOldFileWhole) {
  const TemporaryFolder folder;
  std::ofstream(folder / "old.exr") << "old";
  RunOptions options;
  options.interrupt_after = 1.0;
  // A job of many seconds.
  const ProgramRun run = run_glintscope(
      {"pndf", "--preset", "isotropic-noise", "--pixel", "500,500", "--radius", "60", "-o", folder / "old.exr"},
      options);
  EXPECT_EQ(run.status, 130);
  EXPECT_LT(run.seconds, 0.5);  // 0.2 is promised; a busy test machine may be late
  EXPECT_EQ(text_of(folder / "old.exr"), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

}  // namespace
}  // namespace glint::test
