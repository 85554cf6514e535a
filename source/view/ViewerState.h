#pragma once

#include <memory>
#include <optional>
#include <string>

#include "source/inspect/Pick.h"
#include "source/inspect/RayInspector.h"
#include "source/inspect/SceneLines.h"
#include "source/inspect/SectionView.h"
#include "source/inspect/TracedQuad.h"
#include "source/view/FileReader.h"
#include "source/view/FileWatch.h"
#include "source/view/Notices.h"
#include "source/view/ViewedScene.h"
#include "source/view/ViewerHost.h"
#include "source/view/camera/Bookmarks.h"
#include "source/view/camera/Navigator.h"
#include "source/view/compare/ImageStrip.h"
#include "source/view/edit/SceneEditor.h"
#include "source/view/live/AcceleratorCost.h"
#include "source/view/live/JobStatus.h"
#include "source/view/live/TracedImages.h"
#include "source/view/panels/Panels.h"

namespace ray {

/// The user's selection.
struct Selection {
  std::optional<Pick> pick;         // the pixel that was clicked
  std::optional<std::size_t> node;  // of the scene graph, into World::Nodes
};

/// The parts of the drawing, from the left: the view of the scene, the cross section and the column of panels, which
/// is as high as the drawing. The status bar is above the first two. All but the view may be hidden.
struct Layout {
  /// `column`: the width of the panels, `bar`: the height of their status bar; 0 if they are hidden.
  static Layout Of(const DrawingSize& all, double column, double bar, bool has_section);

  /// Returns true if a position in the drawing is on the cross section.
  bool IsOnSection(const R2::Point& position) const;
  /// A position in the drawing as one on the cross section.
  R2::Point OnSection(const R2::Point& position) const { return {position.x - view.width, position.y}; }
  /// Returns the place of an image of that many pixels in the view: centered, as large as fits.
  PixelBox PlaceFor(double width, double height) const;

  DrawingSize view, section;  // at least 1 x 1; of width 0 if it is hidden
  int bottom = 0;             // of both, in the drawing
};

/// The state of a viewer; each part has rules of its own. The commands in source/view/commands change it, as keys
/// (KeyBindings.h), the pointer (PointerInput.h) and panels request; source/view/show draws it.
struct ViewerState {
  /// `shown`: read from the settings' file. The host must outlive it.
  ViewerState(ViewerSettings begin, const LoadedScene& shown, ViewerHost& around);
  ViewerState(const ViewerState&) = delete;

  ViewerHost& host;
  ViewerSettings settings;
  struct {
    int number = 0;       // of changes so far
    std::string problem;  // the reason why the last one was refused; empty if it was not
  } option_changes;
  Notices notices;

  ViewedScene scene;
  FileReader reader;  // of the scene to show next
  FileWatch watch;    // over its files
  Navigator navigator;
  Bookmarks bookmarks;
  SceneEditor editor{*this};
  Selection selection;

  TracedImages traced;
  RenderStatus status;
  ImageStrip images;
  std::shared_ptr<const R2::Image> shown_image;  // of these, while it is the reference; null for the current one
  double exposure_steps = 0;                     // each doubles the light
  FlatView flat;
  AcceleratorComparisons accelerators;
  /// The inputs of an image of key S.
  struct TracedAs {
    int scene = 0, options = 0;  // numbers
    std::string camera;          // as a line
    DrawingSize size;
    std::optional<PixelRectangle> crop;
    friend bool operator==(const TracedAs&, const TracedAs&) = default;
  };
  TracedAs traced_as;
  std::optional<PixelRectangle> crop;  // the part of the view that key S renders; std::nullopt for all of it

  SpaceOverlays overlays;
  RayInspector rays;
  SectionView section;
  struct {
    std::shared_ptr<const SliceAxes> drawing;  // null if it is out of date
    DrawingSize size;                          // of that
    PanelTheme theme = PanelTheme::dark;       // likewise
    bool takes_arrows = false;                 // else the pixel
    std::optional<R2::Point> measured_from;    // the place of the press, while the button is held
  } section_pane;

  const std::unique_ptr<Panels> panels;
  struct {
    bool panels = false, help = false, scenes = false;
  } shows;

  struct {
    DrawingSize size;
    double scale = 1;           // pixels per unit of length
    R2::Point pointer{-1, -1};  // its last position, in pixels of the drawing
  } screen;
  bool is_closed = false;

  PanelParts Parts() const { return {shows.panels, shows.help, shows.panels || settings.shows_bar}; }
  Layout layout() const;
  /// The settings to render the view, pixel by pixel; and those of key S, for the whole drawing.
  RenderSettings SettingsOfView() const { return SettingsFor(layout().view); }
  RenderSettings SettingsOfImage() const { return SettingsFor(screen.size); }
  bool HasMovedCamera() const { return SettingsOfView().view.has_value(); }
  /// Returns the ray through a position in the drawing, by the projection of the image there: the camera's own in a
  /// traced image, otherwise a pinhole's; std::nullopt outside of its view.
  std::optional<R3::Ray> RayAt(const R2::Point& position) const;
  /// Returns the first point that it hits; std::nullopt for the background.
  std::optional<R3::Point> PointAt(const R2::Point& position) const;

  // The image: the image shown flat, if any, or the view.
  /// Returns the job of the image shown flat; null if none is.
  const RenderJob* FlatJob() const;
  RenderSettings SettingsOfShownImage() const;
  Camera CameraOfShownImage() const;
  /// The rectangle that the preview is drawn in: the view, or the flat image up to its slider.
  DrawingSize SizeOfPreview() const;
  /// Returns its place in the drawing; and its largest possible place.
  PixelBox PlaceOfShownImage() const { return FlatJob() ? flat.Place(FittingPlace()) : FittingPlace(); }
  PixelBox FittingPlace() const;
  /// A position in the drawing as one in that image.
  R2::Point InShownImage(const R2::Point& position) const;
  /// Returns the part of the drawing that a job renders: a crop, or all of it.
  PixelBox PlaceOf(const RenderJob& job) const;
  R2::Point PointerInShownImage() const { return InShownImage(screen.pointer); }

  /// A position in the drawing as one in the image that key S renders.
  R2::Point InImage(const R2::Point& position) const;

  /// Returns the image of key S in space; std::nullopt if it is not shown.
  std::optional<TracedQuad> Quad() const;
  /// Returns the end of a message that a scene is open: "; the scene is unlit".
  std::string NotesAfterMessage() const { return scene.Notes().empty() ? "" : "; " + scene.Notes(); }

 private:
  RenderSettings SettingsFor(const DrawingSize& size) const;
};

}  // namespace ray
