// The registry's entries of the View menu.

#include <memory>
#include <optional>
#include <utility>

#include "gui/window/action_registrar.h"
#include "viewers/map/map_elements.h"

namespace glint::gui {
namespace {

class ViewRegistrar : private ActionRegistrar {
 public:
  using ActionRegistrar::ActionRegistrar;

  void add_all() {
    add_map_view();
    add_pndf_view();
    add_window_view();
  }

 private:
  void add_map_view() {
    view::NormalMapView& map = app_.panels().map();
    add("View", "view.whole_map", "Whole map", plain(Key::home), "Shows the whole normal map.",
        [&] { map.show_all(); });
    done();
    add("View", "view.footprint", "Footprint", plain(Key::f), "Shows the footprint up to five sigma.",
        [&] { map.show_footprint(); });
    done();
    add("View", "view.texels", "Texels", plain(Key::t), "Zooms in until single texels and their normals are seen.",
        [&] { map.show_texels(); });
    done();
    add("View", "view.zoom_in", "Zoom in", plain(Key::equal), "Zooms the normal map in.", [&] {
      map.zoom_by(1.25);
    }).more_chords = {shift(Key::equal)};
    done();
    add("View", "view.zoom_out", "Zoom out", plain(Key::minus), "Zooms the normal map out.", [&] { map.zoom_by(0.8); });
    done();
    const auto colors = [&](const char* name, const char* title, Key key, MapColors wanted, const char* tooltip) {
      Action* action = &add("View", name, title, plain(key), tooltip, [this, wanted] {
        bench().change("Map colours", [&](Document& d) { d.view.map_colors = wanted; });
      });
      action->checked = [this, wanted] { return bench().document().view.map_colors == wanted; };
      action->separator_before = wanted == MapColors::normal;
      done();
    };
    colors("view.map_normal", "Map as normals", Key::digit_1, MapColors::normal,
           "Shows the map in normal-map colours.");
    colors("view.map_slope", "Map as slope", Key::digit_2, MapColors::slope, "Shows how steep the map is.");
    colors("view.map_curvature", "Map as curvature", Key::digit_3, MapColors::curvature,
           "Shows how fast the normal turns from texel to texel.");
    Action* action = &add(
        "View", "view.elements", "Elements of the mixture", plain(Key::e),
        "Shows the mixture's elements on the map: what they weigh, or which light up at the crosshair.",
        [this] { bench().change("Elements on the map", [](Document& d) { d.view.elements = !d.view.elements; }); });
    action->checked = [this] { return bench().document().view.elements; };
    action->reason_disabled = [this] { return view::reason_without_elements(bench().document()); };
    done();
  }

  void add_pndf_view() {
    Action* action = &add("View", "view.log", "Logarithmic density", plain(Key::l),
                          "Shows densities on a logarithmic scale, or on a linear one.", [this] {
                            bench().change("Density scale", [](Document& d) {
                              const bool log = d.view.density_scale == ColorScale::logarithmic;
                              d.view.density_scale = log ? ColorScale::linear : ColorScale::logarithmic;
                            });
                          });
    action->checked = [this] { return bench().document().view.density_scale == ColorScale::logarithmic; };
    action->separator_before = true;
    done();
    action = &add("View", "view.fit_range", "Fit the colours", plain(Key::a),
                  "Lets the colour bar follow the densities again.", [this] {
                    bench().change("Fit the colours", [](Document& d) {
                      d.view.density_range.reset();
                      d.view.difference_range.reset();
                    });
                  });
    action->reason_disabled = [this] {
      const ViewSettings& view = bench().document().view;
      return view.density_range || view.difference_range ? "" : "The colours follow the densities already";
    };
    done();
    action = &add("View", "view.whole_disk", "Whole disk of normals", plain(Key::d),
                  "Shows the P-NDF over the whole disk, or fitted to its lobe.", [this] {
                    bench().change("P-NDF window", [](Document& d) {
                      d.grid.window = d.grid.window ? std::nullopt : std::optional(glm::dvec4(-1, 1, -1, 1));
                    });
                  });
    action->checked = [this] { return bench().document().grid.window == glm::dvec4(-1, 1, -1, 1); };
    done();
    action = &add("View", "view.reference", "Show the reference", plain(Key::r),
                  "While R is held, every picture shows the reference; from the menu it stays so until chosen again.",
                  [this] { app_.flip_switch() = !app_.flip_switch(); });
    action->checked = [this] { return app_.flip_switch(); };
    done();
  }

  void add_window_view() {
    const auto maximise = [&](const char* name, const char* title, Key key, Panel panel) {
      Action* action = &add("View", name, title, plain(key), "Fills the window with this panel, or takes it back.",
                            [this, panel] { app_.toggle_maximised(panel); });
      action->checked = [this, panel] { return bench().settings().maximised_panel == panel_name(panel); };
      action->separator_before = panel == Panel::map;
      done();
    };
    maximise("view.maximise_map", "Normal map alone", Key::f2, Panel::map);
    maximise("view.maximise_pndf", "P-NDF alone", Key::f3, Panel::pndf);
    maximise("view.maximise_inspector", "Inspector alone", Key::f4, Panel::inspector);
    add("View", "view.next_panel", "Next panel", plain(Key::f6), "Gives the keyboard to the next panel.",
        [this] { app_.focus_panel(1); });
    done();
    add("View", "view.previous_panel", "Previous panel", shift(Key::f6), "Gives the keyboard to the panel before.",
        [this] { app_.focus_panel(-1); });
    done();
    add("View", "view.next_control", "Next control", plain(Key::tab),
        "Gives the keyboard to the next control; Enter and Space press it, arrows slide it.",
        [this] { app_.move_focus(false); });
    done();
    add("View", "view.previous_control", "Previous control", shift(Key::tab),
        "Gives the keyboard to the control before.", [this] { app_.move_focus(true); });
    done();
    add("View", "view.larger", "Larger interface", ctrl(Key::equal), "Makes everything in the window larger.", [this] {
      app_.set_ui_scale(app_.ui_scale() + 0.25);
    }).separator_before = true;
    done();
    add("View", "view.smaller", "Smaller interface", ctrl(Key::minus), "Makes everything in the window smaller.",
        [this] { app_.set_ui_scale(app_.ui_scale() - 0.25); });
    done();
    add("View", "view.own_size", "Size of the desktop", ctrl(Key::digit_0),
        "Takes the size of the interface from the desktop.", [this] { app_.set_ui_scale(0); });
    done();
    add("View", "view.reset_layout", "Reset the layout", std::nullopt,
        "Takes panels, splitters and sections back to where they were at first.", [this] {
          Settings& settings = bench().settings();
          settings.splitters.clear();
          settings.open_sections.clear();
          settings.maximised_panel.clear();
        });
    done();
  }
};

}  // namespace

void add_view_actions(Actions& actions, Application& application) {
  auto registrar = std::make_shared<ViewRegistrar>(actions, application);
  registrar->add_all();
  application.keep(std::move(registrar));
}

}  // namespace glint::gui
