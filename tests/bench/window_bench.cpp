// How smooth the window is under software OpenGL while jobs take every core: frame times of a drag, a zoom and clicks,
// how many exact pictures a second a drag shows, the time from a click to its first picture, and frames in which
// nothing changes.
//
//   bench_window [PRESET [SIGMA [SIZE]]]
//
// SIGMA is the footprint's, texels; SIZE that of a map that is generated.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "gui/platform/headless.h"

namespace {

using Clock = std::chrono::steady_clock;
using namespace glint;  // NOLINT(google-build-using-namespace): a program of one file

double ms_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

// Frames at 60 a second, as a display would ask for them.
class Bench {
 public:
  Bench(gui::HeadlessWindow& window, double sigma, int size) : window_(window), sigma_(sigma), size_(size) {}

  void warm_up() {
    frames(30);
    app().workbench().change("Footprint", [&](Document& d) {
      d.footprint.covariance = {sigma_ * sigma_, 0, sigma_ * sigma_};
      if (size_ > 0) d.surface.noise.size = d.surface.scratches.size = size_;
    });
    frames(60);
  }

  void frames(int count) {
    for (int k = 0; k < count; ++k) {
      const Clock::time_point begin = Clock::now();
      window_.frame(false);
      window_.gl().Finish();
      const double spent = ms_since(begin);
      times_.push_back(spent);
      if (spent < 16) std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(16 - spent));
    }
  }

  void report(const char* what) {
    std::sort(times_.begin(), times_.end());
    fmt::print("{:<28} {:>5} frames  median {:>6.1f} ms  p95 {:>6.1f} ms  longest {:>6.1f} ms\n", what, times_.size(),
               times_[times_.size() / 2], times_[times_.size() * 95 / 100], times_.back());
    times_.clear();
  }

  void rest() {
    while (!app().jobs_idle()) window_.frame(true);
    frames(10);
    times_.clear();
    frames(60);
    report("at rest");
  }

  void drag() {
    times_.clear();
    const ImVec2 at = app().panels().map().picture().center();
    push(gui::MouseMove{at});
    frames(2);
    push(gui::MouseButton{0, true, {}, true});
    std::set<std::shared_ptr<const PndfImage>> pictures;
    std::set<std::string> labels;
    const Clock::time_point begin = Clock::now();
    for (int k = 0; k < 150; ++k) {
      push(gui::MouseMove{{at.x + 40 * std::sin(0.1F * static_cast<float>(k)), at.y + 0.3F * static_cast<float>(k)}});
      frames(1);
      const auto results = app().workbench().jobs().results();
      if (!results || results->methods.empty() || !results->methods[0].image) continue;
      pictures.insert(results->methods[0].image);
      labels.insert(results->methods[0].coarse_note);
    }
    const double seconds = ms_since(begin) / 1000;
    push(gui::MouseButton{0, false, {}, true});
    frames(2);
    report("dragging the footprint");
    fmt::print("exact pictures in the drag   {:>5.1f} a second:", static_cast<double>(pictures.size()) / seconds);
    for (const std::string& label : labels) fmt::print(" \"{}\"", label);
    fmt::print("\n");
  }

  void zoom() {
    times_.clear();
    push(gui::MouseMove{app().panels().map().picture().center()});
    for (int k = 0; k < 120; ++k) {
      push(gui::MouseWheel{{0, k % 40 < 20 ? 1.0F : -1.0F}});
      frames(1);
    }
    report("zooming the map");
  }

  void clicks() {
    times_.clear();
    std::vector<double> waits;
    const ImVec2 at = app().panels().map().picture().center();
    for (int k = 0; k < 20; ++k) {
      push(gui::MouseMove{{at.x - 60 + 6 * static_cast<float>(k), at.y + 3 * static_cast<float>(k)}});
      frames(1);
      push(gui::MouseButton{0, true, {}, true});
      push(gui::MouseButton{0, false, {}, true});
      const std::uint64_t before = app().workbench().editor().revision();
      const Clock::time_point begin = Clock::now();
      while (ms_since(begin) < 5000 && !shows_exact_after(before)) frames(1);
      waits.push_back(ms_since(begin));
    }
    std::sort(waits.begin(), waits.end());
    report("clicking");
    fmt::print("click to exact on screen     {:>5} clicks  median {:>6.1f} ms  p95 {:>6.1f} ms  longest {:>6.1f} ms\n",
               waits.size(), waits[waits.size() / 2], waits[waits.size() * 95 / 100], waits.back());
  }

 private:
  gui::Application& app() { return window_.application(); }
  void push(gui::InputEvent event) { app().input().push(std::move(event)); }

  bool shows_exact_after(std::uint64_t revision) {
    const auto results = app().workbench().jobs().results();
    return results && app().workbench().editor().revision() > revision && !results->methods.empty() &&
           results->methods[0].image && results->methods[0].revision > revision;
  }

  gui::HeadlessWindow& window_;
  double sigma_;
  int size_;  // 0: the preset's
  std::vector<double> times_;
};

}  // namespace

int main(int argc, char** argv) {
  const BackgroundPriority as_in_a_window;
  gui::Workbench::Places places;
  places.preset_folders = {std::filesystem::path(GLINTSCOPE_SOURCE_DIR) / "presets"};
  auto window = gui::HeadlessWindow::create({1600, 1000}, 1, std::move(places));
  if (!window) {
    fmt::print(stderr, "{}\n", window.error().message());
    return 1;
  }
  const Status opened = (*window)->application().open_preset(argc > 1 ? argv[1] : "isotropic-noise");
  if (!opened) {
    fmt::print(stderr, "{}\n", opened.error().message());
    return 1;
  }
  Bench bench(**window, argc > 2 ? std::atof(argv[2]) : 20.0 / 6, argc > 3 ? std::atoi(argv[3]) : 0);
  bench.warm_up();
  bench.rest();
  bench.drag();
  bench.zoom();
  bench.clicks();
  return 0;
}
