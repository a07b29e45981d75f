#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/document/parameter.h"
#include "core/document/preset.h"
#include "tests/core/document/example.h"
#include "tests/temporary_folder.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using test::text_of;
using test::write_text;
using testing::HasSubstr;
using testing::StartsWith;

const fs::path k_shipped = fs::path(GLINTSCOPE_SOURCE_DIR) / "presets";

std::vector<std::string> names_of(const std::vector<PresetEntry>& entries) {
  std::vector<std::string> names;
  for (const PresetEntry& entry : entries) names.push_back(entry.name);
  return names;
}

TEST(ShippedPresets, LoadWithoutAFaultUnderTheirOwnName) {
  const std::vector<PresetEntry> entries = list_presets(std::vector{k_shipped});
  EXPECT_THAT(names_of(entries),
              testing::IsSupersetOf({"car-paint-flakes", "flat-oracle", "isotropic-noise", "scratched-steel"}));
  for (const PresetEntry& entry : entries) {
    const Result<Document> document = load_preset(entry.file);
    ASSERT_TRUE(document) << document.error().message();
    EXPECT_EQ(document->name, entry.name);
    EXPECT_EQ(document_fault(*document), std::nullopt);
  }
}

TEST(ShippedPresets, HoldWhatTheirNamesPromise) {
  const Result<Document> steel = load_preset(k_shipped / "scratched-steel.json");
  const Result<Document> noise = load_preset(k_shipped / "isotropic-noise.json");
  const Result<Document> flat = load_preset(k_shipped / "flat-oracle.json");
  const Result<Document> paint = load_preset(k_shipped / "car-paint-flakes.json");
  ASSERT_TRUE(steel && noise && flat && paint);
  EXPECT_EQ(steel->surface.source, SurfaceSource::scratches);
  EXPECT_EQ(steel->methods, (std::vector{PndfMethod::exact, PndfMethod::mixture, PndfMethod::binning}));
  EXPECT_EQ(noise->surface.noise.spectrum, NoiseSettings::Spectrum::band);
  EXPECT_EQ(noise->surface.noise.wavelengths, glm::dvec2(8, 32));
  EXPECT_EQ(noise->surface.noise.rms_slope, 0.15);
  EXPECT_EQ(noise->intrinsic_roughness, 0.005);
  EXPECT_EQ(noise->footprint, isotropic_footprint({512.5, 512.5}, 50.0 / 6.0));
  EXPECT_EQ(flat->surface.noise.rms_slope, 0);
  EXPECT_EQ(flat->intrinsic_roughness, 0.05);
  EXPECT_EQ(paint->surface.source, SurfaceSource::flakes);
  EXPECT_EQ(paint->surface.flakes, FlakeSettings());
  EXPECT_EQ(paint->methods, steel->methods);
}

TEST(ShippedPresets, HaveTheSchemaOfTheDeclarations) {
  const std::string schema = preset_schema();
  const fs::path current = fs::path(testing::TempDir()) / "glintscope_schema.json";
  if (schema != text_of(k_shipped / "schema.json")) write_text(current, schema);
  EXPECT_TRUE(schema == text_of(k_shipped / "schema.json")) << "presets/schema.json must become " << current;
}

TEST(PresetSchema, HoldsEveryParameter) {
  const std::string schema = preset_schema();
  for (const Parameter& p : parameters()) {
    EXPECT_THAT(schema, HasSubstr('"' + std::string(p.path.substr(p.path.rfind('.') + 1)) + "\": {"));
    EXPECT_THAT(schema, HasSubstr(p.help));
  }
}

TEST(PresetFile, IsTheSameDocumentWhenLoadedAgain) {
  const TemporaryFolder folder;
  Document document = test::document_with_all_set();
  document.surface.path = folder / "maps/with space é.png";
  ASSERT_TRUE(save_preset(folder / "p.json", document));
  EXPECT_THAT(text_of(folder / "p.json"), HasSubstr("\"path\": \"maps/with space é.png\""));
  const Result<Document> loaded = load_preset(folder / "p.json");
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_TRUE(*loaded == document);
}

TEST(PresetFile, TakesItsMapFromItsOwnFolder) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "sets");
  write_text(folder / "sets/p.json",
             R"({"glintscope": "preset", "version": 1, "surface": {"source": "file", "path": "../maps/a.png"}})");
  const Result<Document> document = load_preset(folder / "sets/p.json");
  ASSERT_TRUE(document);
  EXPECT_EQ(document->surface.path.lexically_normal(), folder / "maps/a.png");
}

TEST(PresetFile, NamesAMapElsewhereByItsWholePath) {
  const TemporaryFolder folder;
  Document document;
  document.surface.source = SurfaceSource::file;
  document.surface.path = "elsewhere/a.png";  // from the working directory
  ASSERT_TRUE(save_preset(folder / "p.json", document));
  const Result<Document> loaded = load_preset(folder / "p.json");
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->surface.path, fs::current_path() / "elsewhere/a.png");
}

TEST(PresetFile, IsNotWrittenWithAFault) {
  const TemporaryFolder folder;
  Document document;
  document.intrinsic_roughness = 2;
  const Status status = save_preset(folder / "p.json", document);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().subject, "intrinsic_roughness");
  EXPECT_FALSE(fs::exists(folder / "p.json"));
}

TEST(PresetFile, ErrorsNameTheFile) {
  const TemporaryFolder folder;
  const auto fault = [](const fs::path& file) {
    const Result<Document> document = load_preset(file);
    EXPECT_TRUE(!document && document.error().kind == ErrorKind::content);
    return document ? "loaded" : document.error().message();
  };
  const fs::path file = folder / "p.json";
  EXPECT_EQ(fault(file), file.string() + ": cannot be read: there is no such file");
  EXPECT_EQ(fault(folder.path()), folder.path().string() + ": cannot be read: it is a folder, not a preset");
  write_text(file, "{\n \"glintscope\": \"preset\", \"version\": 1, \"seed\": -1}");
  EXPECT_EQ(fault(file),
            file.string() + ":2:48: field 'seed': is -1; allowed: a whole number from 0 to 18446744073709551615");
  write_text(file, std::string((1U << 20U) + 1, ' '));
  EXPECT_EQ(fault(file), file.string() + ": is larger than 1 MiB, which no preset is");
  EXPECT_EQ(fault("/dev/zero"), "/dev/zero: is larger than 1 MiB, which no preset is");
  EXPECT_EQ(save_preset(folder / "missing/p.json", Document()).error().kind, ErrorKind::request);
}

TEST(PresetFile, MayBeAsLargeAsTheLimit) {
  const TemporaryFolder folder;
  std::string text = preset_text(Document());
  text.resize(std::size_t{1} << 20U, ' ');
  write_text(folder / "p.json", text);
  const Result<Document> document = load_preset(folder / "p.json");
  ASSERT_TRUE(document) << document.error().message();
  EXPECT_TRUE(*document == Document());
}

TEST(PresetNames, AreFoundInTheFirstFolderThatHasThem) {
  const TemporaryFolder mine;
  const TemporaryFolder shipped;
  write_text(shipped / "steel.json", "");
  write_text(shipped / "brass.json", "");
  write_text(shipped / "schema.json", "");
  write_text(shipped / "notes.txt", "");
  fs::create_directories(shipped / "folder.json");
  write_text(mine / "steel.json", "");
  const std::vector<fs::path> folders{mine.path(), shipped / "missing", shipped.path()};
  EXPECT_EQ(names_of(list_presets(folders)), (std::vector<std::string>{"brass", "steel"}));
  EXPECT_EQ(*find_preset("steel", folders), mine / "steel.json");
  EXPECT_EQ(*find_preset("brass", folders), shipped / "brass.json");
  EXPECT_EQ(*find_preset("./brass", folders), "./brass");
  EXPECT_EQ(*find_preset("other.json", folders), "other.json");

  const Result<fs::path> unknown = find_preset("gold", folders);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().kind, ErrorKind::request);
  EXPECT_EQ(unknown.error().message(), "gold: is no known preset; known: brass, steel");
  EXPECT_THAT(find_preset("gold", {}).error().message(), StartsWith("gold: is no known preset; known: none"));
}

TEST(PresetNames, AreLookedForBesideTheExecutableUnlessTheEnvironmentSaysWhere) {
  const char* before = std::getenv("GLINTSCOPE_PRESETS");
  const std::string kept = before ? before : "";
  ::unsetenv("GLINTSCOPE_PRESETS");
  const TemporaryFolder prefix;
  fs::create_directories(prefix / "bin");
  write_text(prefix / "bin/glintscope", "");
  fs::create_symlink(prefix / "bin/glintscope", prefix / "link");
  const fs::path root = fs::canonical(prefix.path());
  EXPECT_THAT(preset_folders(prefix / "bin/glintscope"), testing::ElementsAre(root / "share/glintscope/presets"));
  EXPECT_THAT(preset_folders(prefix / "link"), testing::ElementsAre(root / "share/glintscope/presets"));
  ::setenv("GLINTSCOPE_PRESETS", "/my/presets", 1);
  EXPECT_THAT(preset_folders("/usr/bin/glintscope"), testing::ElementsAre(fs::path("/my/presets")));
  ::unsetenv("GLINTSCOPE_PRESETS");
  if (before) ::setenv("GLINTSCOPE_PRESETS", kept.c_str(), 1);
}

}  // namespace
}  // namespace glint
