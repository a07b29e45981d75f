// The registry's entries, those of the View menu apart (view_actions.cpp). Menus, shortcuts, the list of shortcuts, the
// palette and scripts all follow from them.

#include <algorithm>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/document/names.h"
#include "gui/window/action_registrar.h"

namespace glint::gui {
namespace {

class Registrar : private ActionRegistrar {
 public:
  using ActionRegistrar::ActionRegistrar;

  void add_all() {
    add_file();
    add_edit();
    add_footprint();
    add_view_actions(actions_, app_);
    add_presets();
    add_compute();
    add_help();
  }

 private:
  void add_file() {
    add("File", "file.open", "Open map…", ctrl(Key::o),
        "Opens a normal map, a height field, a preset, or an EXR with its recipe.",
        [this] { app_.overlays().open_browser(Purpose::open_map); });
    done();
    add("File", "file.open_preset", "Open preset file…", ctrl_shift(Key::o), "Opens a preset from a file.",
        [this] { app_.overlays().open_browser(Purpose::open_preset); });
    done();
    add("File", "file.reload", "Read the map again", plain(Key::f5),
        "Reads the map's file again, or generates the map again: for files that changed on disk.",
        [this] { bench().jobs().reload_surface(); });
    done();
    add("File", "file.save", "Save preset", ctrl(Key::s),
        "Saves the document to its preset; one that ships is saved under another name.", [this] { app_.save(); })
        .separator_before = true;
    done();
    add("File", "file.save_as", "Save preset as…", ctrl_shift(Key::s), "Saves the document as a preset of your own.",
        [this] { app_.overlays().open_save_as(); });
    done();
    add("File", "file.export", "Export…", ctrl(Key::e), "Exports a panel as a picture or its data as EXR, CSV or JSON.",
        [this] { app_.export_panel(app_.panels().focused()); })
        .separator_before = true;
    done();
    add("File", "file.quit", "Quit", ctrl(Key::q), "Ends the program; unsaved work is asked about first.", [this] {
      app_.request_end();
    }).separator_before = true;
    done();
  }

  void add_edit() {
    Action* action = &add("Edit", "edit.undo", "Undo", ctrl(Key::z), "Takes the last edit back; a drag is one edit.",
                          [this] { app_.undo(); });
    action->reason_disabled = [this] { return bench().editor().can_undo() ? "" : "There is nothing to undo"; };
    done();
    action =
        &add("Edit", "edit.redo", "Redo", ctrl_shift(Key::z), "Does again what was undone.", [this] { app_.redo(); });
    action->more_chords = {ctrl(Key::y)};
    action->reason_disabled = [this] { return bench().editor().can_redo() ? "" : "There is nothing to redo"; };
    done();
    add("Edit", "edit.copy", "Copy values", ctrl(Key::c),
        "Copies the values under the cursor, of the map or of every method, with all their digits.",
        [this] { app_.copy_values(); })
        .separator_before = true;
    done();
    action = &add("Edit", "edit.revert", "Revert to saved", std::nullopt,
                  "Takes the document back to what was last saved or opened; this can be undone.",
                  [this] { bench().revert(); });
    action->reason_disabled = [this] {
      return bench().editor().is_saved() ? "Nothing differs from what is saved" : "";
    };
    done();
    action = &add("Edit", "edit.escape", "Leave, or cancel", plain(Key::escape),
                  "Closes what is open, takes back a drag, leaves a full-size panel, or cancels what is computed.",
                  [this] { app_.escape(); });
    action->separator_before = true;
    done();
  }

  void add_footprint() {
    const auto move = [&](const char* name, const char* title, Key key, glm::dvec2 by) {
      add("Edit", name, title, plain(key), "Moves the footprint by one texel.", [this, by] {
        app_.move_footprint(by);
      }).more_chords = {};
      done();
      const std::string far = std::string(name) + "_far";
      add("", far.c_str(), (std::string(title) + " by ten").c_str(), shift(key), "Moves the footprint by ten texels.",
          [this, by] { app_.move_footprint(10.0 * by); });
      done();
    };
    move("footprint.left", "Footprint left", Key::left, {-1, 0});
    move("footprint.right", "Footprint right", Key::right, {1, 0});
    move("footprint.up", "Footprint up", Key::up, {0, -1});
    move("footprint.down", "Footprint down", Key::down, {0, 1});
    add("Edit", "footprint.widen", "Widen the footprint", plain(Key::right_bracket),
        "Makes the footprint a quarter wider in every direction.", [this] { app_.scale_footprint(1.25); });
    done();
    add("Edit", "footprint.narrow", "Narrow the footprint", plain(Key::left_bracket),
        "Makes the footprint a fifth narrower in every direction.", [this] { app_.scale_footprint(0.8); });
    done();
    add("Edit", "footprint.turn", "Turn the footprint", plain(Key::period),
        "Turns the footprint by 15 degrees, from the u axis towards the top of the picture.",
        [this] { app_.turn_footprint(std::numbers::pi / 12); });
    done();
    add("Edit", "footprint.turn_back", "Turn the footprint back", plain(Key::comma),
        "Turns the footprint by 15 degrees the other way.", [this] { app_.turn_footprint(-std::numbers::pi / 12); });
    done();
  }

  void add_presets() {
    for (const PresetEntry& entry : bench().presets()) {
      const std::string name = "preset.open." + entry.name;
      const std::string tooltip = fmt::format("Opens the preset {}.", entry.name);
      Action* action = &add("Preset", name.c_str(), entry.name.c_str(), std::nullopt, tooltip.c_str(),
                            [this, file = entry.file] { bench().open(file); });
      action->checked = [this, file = entry.file] { return bench().preset_file() == file; };
      done();
    }
    const auto step = [&](const char* name, const char* title, Key key, int by, const char* tooltip) {
      add("Preset", name, title, ctrl(key), tooltip, [this, by] { step_preset(by); }).separator_before = by > 0;
      done();
    };
    step("preset.next", "Next preset", Key::page_down, 1, "Opens the next preset of the list.");
    step("preset.previous", "Previous preset", Key::page_up, -1, "Opens the preset before this one in the list.");
    const auto own = [this] { return bench().is_user_preset() ? "" : "Only presets of your own can be changed"; };
    Action* action =
        &add("Preset", "preset.rename", "Rename preset…", std::nullopt,
             "Gives the preset of your own that is open another name.", [this] { app_.overlays().open_rename(); });
    action->reason_disabled = own;
    action->separator_before = true;
    done();
    action = &add("Preset", "preset.delete", "Delete preset…", std::nullopt,
                  "Deletes the file of the preset of your own that is open, after a question.",
                  [this] { app_.overlays().ask_delete(); });
    action->reason_disabled = own;
    done();
  }

  void step_preset(int by) {
    const std::vector<PresetEntry>& presets = bench().presets();
    const int count = static_cast<int>(presets.size());
    if (count == 0) return;
    int at = by > 0 ? -1 : count;
    for (int k = 0; k < count; ++k) {
      if (presets[static_cast<std::size_t>(k)].file == bench().preset_file()) at = k;
    }
    bench().open(presets[static_cast<std::size_t>((at + by + count) % count)].file);
  }

  void add_compute() {
    Action* action =
        &add("Compute", "compute.cancel", "Cancel", ctrl(Key::period),
             "Ends what is being computed; the pictures that are there stay.", [this] { bench().jobs().cancel(); });
    action->reason_disabled = [this] { return bench().jobs().idle() ? "Nothing is being computed" : ""; };
    done();
    action = &add("Compute", "compute.restart", "Compute again", plain(Key::f9), "Computes what was cancelled.",
                  [this] { bench().jobs().restart(); });
    action->reason_disabled = [this] { return bench().jobs().cancelled() ? "" : "Nothing was cancelled"; };
    done();
    const auto method = [&](const char* name, const char* title, Key key, PndfMethod which) {
      Action* m = &add("Compute", name, title, ctrl(key), "Computes the P-NDF by this method too, or no more.",
                       [this, which] { toggle_method(which); });
      m->checked = [this, which] { return has_method(which); };
      m->reason_disabled = [this, which] {
        return has_method(which) && bench().document().methods.size() == 1 ? "It is the only method" : "";
      };
      m->separator_before = which == PndfMethod::exact;
      done();
    };
    method("compute.exact", "Exact", Key::digit_1, PndfMethod::exact);
    method("compute.mixture", "Mixture", Key::digit_2, PndfMethod::mixture);
    method("compute.lean", "LEAN", Key::digit_3, PndfMethod::lean);
    method("compute.auto", "Auto", Key::digit_4, PndfMethod::automatic);
    method("compute.binning", "Binning", Key::digit_5, PndfMethod::binning);
    const auto surface = [&](const char* name, const char* title, Key key, std::optional<Interpolation> which) {
      Action* s =
          &add("Compute", name, title, shift(key), "Chooses the surface between the map's samples.",
               [this, which] { bench().change("Surface", [&](Document& d) { d.surface.interpolation = which; }); });
      s->checked = [this, which] { return bench().document().surface.interpolation == which; };
      s->separator_before = !which;
      done();
    };
    action =
        &add("Compute", "compute.check_precision", "Check against double precision", plain(Key::c),
             "Computes the exact density at the crosshair in double precision and says how far the picture is off.",
             [this] { bench().jobs().check_precision(app_.panels().pndf().reading()->s); });
    action->reason_disabled = [this]() -> std::string {
      const auto& reading = app_.panels().pndf().reading();
      if (!reading) return "There is no crosshair: click in a P-NDF first";
      return PrecisionCheck::reason_against(bench().jobs().results().get(), reading->s);
    };
    action->separator_before = true;
    done();
    surface("compute.automatic", "Surface: automatic", Key::digit_1, std::nullopt);
    surface("compute.smooth", "Surface: smooth, 32 triangles", Key::digit_2, Interpolation::smooth);
    surface("compute.linear", "Surface: linear, 2 triangles", Key::digit_3, Interpolation::linear);
    surface("compute.constant", "Surface: constant texels", Key::digit_4, Interpolation::constant);
  }

  [[nodiscard]] bool has_method(PndfMethod method) const {
    const std::vector<PndfMethod>& methods = bench().document().methods;
    return std::find(methods.begin(), methods.end(), method) != methods.end();
  }

  void toggle_method(PndfMethod method) {
    bench().change("Methods", [&](Document& d) {
      const auto found = std::find(d.methods.begin(), d.methods.end(), method);
      if (found == d.methods.end()) {
        d.methods.push_back(method);
        std::sort(d.methods.begin(), d.methods.end());
      } else if (d.methods.size() > 1) {
        d.methods.erase(found);
      }
    });
  }

  void add_help() {
    add("Help", "help.shortcuts", "Keys and gestures", plain(Key::f1), "Lists every key and gesture of the window.",
        [this] { app_.overlays().open_shortcuts(); })
        .works_while_typing = true;
    done();
    add("Help", "help.find_action", "Find an action…", ctrl(Key::p),
        "Finds any action or field by a few letters of its name.", [this] { app_.overlays().open_palette(); })
        .works_while_typing = true;
    done();
    add("Help", "help.dismiss", "Dismiss all messages", ctrl_shift(Key::d), "Takes all messages away.",
        [this] { bench().messages().dismiss_all(); });
    done();
    add("Help", "help.about", "About Glintscope", std::nullopt, "Version, licence, and what this machine draws with.",
        [this] { app_.overlays().open_about(); })
        .separator_before = true;
    done();
  }
};

}  // namespace

void add_actions(Actions& actions, Application& application) {
  // The registrar stays behind the callbacks for as long as the registry lives.
  auto registrar = std::make_shared<Registrar>(actions, application);
  registrar->add_all();
  application.keep(std::move(registrar));
}

}  // namespace glint::gui
