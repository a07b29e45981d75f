// A real window under Xvfb, with a real mouse and keyboard by xdotool; and the same script there and without a display.

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/document/preset.h"
#include "tests/gui/application_stage.h"
#include "tests/gui/run_program.h"
#include "tests/temporary_folder.h"

namespace glint::test {
namespace {

using ::testing::HasSubstr;

bool is_installed(const char* program) {
  return std::system(("command -v " + std::string(program) + " >/dev/null 2>&1").c_str()) == 0;
}

// What a shell command prints, without the last line break.
std::string output_of(const std::string& command) {
  std::string text;
  FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  ::pclose(pipe);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

pid_t start(std::vector<std::string> words, const std::vector<std::string>& environment,
            const std::filesystem::path& log) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  if (std::freopen(log.c_str(), "w", stderr) == nullptr) ::_exit(126);
  if (std::freopen("/dev/null", "w", stdout) == nullptr) ::_exit(126);
  for (const std::string& setting : environment) ::putenv(::strdup(setting.c_str()));
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execvp(pointers[0], pointers.data());
  ::_exit(127);
}

// An X server without a screen, of a display number that nobody else uses.
class Display {
 public:
  Display() {
    number_ = 200 + static_cast<int>(::getpid() % 2000);
    server_ = start({"Xvfb", name(), "-screen", "0", "1600x1000x24", "-nolisten", "tcp"}, {}, log_ / "xvfb");
    const std::string socket = "/tmp/.X11-unix/X" + std::to_string(number_);
    for (int k = 0; k < 200 && !std::filesystem::exists(socket); ++k) rest(0.05);
  }
  ~Display() {
    ::kill(server_, SIGTERM);
    ::waitpid(server_, nullptr, 0);
  }
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  [[nodiscard]] std::string name() const { return ":" + std::to_string(number_); }
  static void rest(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

  /// One call of xdotool on this display.
  [[nodiscard]] std::string hand(const std::string& words) const {
    return output_of("DISPLAY=" + name() + " xdotool " + words + " 2>/dev/null");
  }

 private:
  TemporaryFolder log_;
  int number_ = 0;
  pid_t server_ = 0;
};

class RealWindow : public ::testing::Test {
 protected:
  void SetUp() override {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the drivers behind a real window are not clean; everything else of it runs without a display";
#endif
    if (!is_installed("Xvfb") || !is_installed("xdotool")) GTEST_SKIP() << "Xvfb or xdotool is not installed";
  }

  // No settings of the person who runs the tests are read or written.
  [[nodiscard]] std::vector<std::string> environment(const Display& display) const {
    return {"DISPLAY=" + display.name(), "XDG_CONFIG_HOME=" + (folder / "config").string(),
            "XDG_STATE_HOME=" + (folder / "state").string(), "LIBGL_ALWAYS_SOFTWARE=1"};
  }
  [[nodiscard]] std::filesystem::path small_preset() const {
    write_text(folder / "small.json", k_small_preset);
    return folder / "small.json";
  }

  TemporaryFolder folder;
};

constexpr const char* k_script = R"(wait jobs
map-click 60.5,62.25
wait jobs
drag map.handle.1 24,-10
click pndf.picture.exact
click view.density_scale.linear
drag intrinsic_roughness.slider 12,0
click surface.interpolation
wait 3
key Esc
click methods.binning
key Ctrl+Z
key Right
key Right
set binning.samples 50000
wait jobs
)";

TEST_F(RealWindow, AScriptGivesTheSameDocumentThereAndWithoutADisplay) {
  const Display display;
  const std::string there = (folder / "there.json").string();
  const std::string headless = (folder / "headless.json").string();
  write_text(folder / "there.txt", k_script + ("export document " + there + "\n"));
  write_text(folder / "headless.txt", k_script + ("export document " + headless + "\n"));
  const ProgramRun first =
      run_glintscope({small_preset(), "--script", folder / "there.txt"}, RunOptions{{}, environment(display), 0});
  EXPECT_EQ(first.status, 0) << first.err;
  const ProgramRun second =
      run_glintscope({"screenshot", small_preset(), "--script", folder / "headless.txt", "--size", "1600x1000"});
  EXPECT_EQ(second.status, 0) << second.err;
  const std::string text = text_of(there);
  EXPECT_THAT(text, HasSubstr("\"density_scale\": \"linear\""));
  EXPECT_EQ(text, text_of(headless));
}

TEST_F(RealWindow, AMouseAndAKeyboardMoveTheFootprintAndACrashLosesNothing) {
  const Display display;
  const pid_t program = start({GLINTSCOPE_PROGRAM, small_preset()}, environment(display), folder / "said");
  std::string window;
  for (int k = 0; k < 400 && window.empty(); ++k) {
    Display::rest(0.05);
    window = display.hand("search --onlyvisible --name Glintscope | head -n 1");
  }
  ASSERT_FALSE(window.empty()) << text_of(folder / "said");
  Display::rest(2);  // first frames, and the small document's pictures
  // The middle of the map panel at 1600 x 1000.
  (void)display.hand("windowfocus --sync " + window);
  (void)display.hand("mousemove --window " + window + " 300 400");
  Display::rest(0.2);
  (void)display.hand("mousedown 1");
  Display::rest(0.2);
  (void)display.hand("mouseup 1");
  Display::rest(0.5);
  (void)display.hand("key --window " + window + " Right");
  Display::rest(0.5);
  // It was edited, so it asks before it quits; and the session keeps the document through a kill.
  (void)display.hand("key --window " + window + " ctrl+q");
  Display::rest(4);
  EXPECT_EQ(::waitpid(program, nullptr, WNOHANG), 0) << "the program ended without asking";
  ::kill(program, SIGKILL);
  ::waitpid(program, nullptr, 0);
  const std::string session = text_of(folder / "state" / "glintscope" / "session-1.json");
  ASSERT_THAT(session, HasSubstr("\"saved\": false"));
  const Result<Document> small = load_preset(small_preset());
  ASSERT_TRUE(small);
  const std::size_t at = session.find("\"center\"");
  ASSERT_NE(at, std::string::npos) << session;
  EXPECT_EQ(session.find("[64, 60]", at), std::string::npos)
      << "the click and the key moved the footprint: " << session;
}

TEST_F(RealWindow, WithoutADisplayOneSentenceSaysSoAndWhatStillWorks) {
  const ProgramRun run = run_glintscope({"flat-oracle"}, RunOptions{{}, {"DISPLAY=", "WAYLAND_DISPLAY="}, 0});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_THAT(run.err, HasSubstr("display"));
  EXPECT_THAT(run.err, HasSubstr("glintscope screenshot"));
}

}  // namespace
}  // namespace glint::test
