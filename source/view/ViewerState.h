#pragma once

#include <memory>
#include <optional>
#include <string>

#include "source/draw/DrawingDetail.h"
#include "source/view/FileWatch.h"
#include "source/view/Layout.h"
#include "source/view/Notices.h"
#include "source/view/ViewedScene.h"
#include "source/view/ViewerHost.h"
#include "source/view/camera/Bookmarks.h"
#include "source/view/camera/Navigator.h"
#include "source/view/compare/ImageStrip.h"
#include "source/view/edit/SceneEditor.h"
#include "source/view/live/AcceleratorComparisons.h"
#include "source/view/live/RenderStatus.h"
#include "source/view/live/TracedPictures.h"
#include "source/view/overlay/Pick.h"
#include "source/view/overlay/RayInspector.h"
#include "source/view/overlay/SectionView.h"
#include "source/view/overlay/SpaceOverlays.h"
#include "source/view/overlay/TracedQuad.h"
#include "source/view/panels/Panels.h"

namespace ray {

/// What the user has chosen to look at.
struct Selection {
  std::optional<Pick> pick;         // the pixel that was clicked
  std::optional<std::size_t> node;  // of the scene graph, into World::Nodes
};

/// All that a viewer knows, each part with rules of its own. The commands in source/view/commands change it, as keys
/// (KeyBindings.h), the pointer (PointerInput.h) and panels ask for; what is drawn is made of it in source/view/show.
struct ViewerState {
  /// `shown`: read from the settings' file. The host must outlive it.
  ViewerState(ViewerSettings begin, const LoadedScene& shown, ViewerHost& around);
  ViewerState(const ViewerState&) = delete;

  ViewerHost& host;
  ViewerSettings settings;
  int options_number = 0;      // another after each change of an option
  std::string option_problem;  // why the last change of an option was refused; empty when it was not
  Notices notices;

  ViewedScene scene;
  FileWatch watch;  // over its files
  Navigator navigator;
  Bookmarks bookmarks;
  SceneEditor editor;
  Selection selection;

  TracedPictures pictures;
  RenderStatus status;
  ImageStrip images;
  std::shared_ptr<const R2::Image> shown_image;  // of these, while it is the reference; null for the current one
  double exposure_steps = 0;                     // each doubles the light
  FlatView flat;
  AcceleratorComparisons accelerators;
  /// What a picture of key S depends on.
  struct TracedAs {
    int scene = 0, options = 0;  // numbers
    std::string camera;          // as a line
    DrawingSize size;
    std::optional<PixelRectangle> crop;
    friend bool operator==(const TracedAs&, const TracedAs&) = default;
  };
  TracedAs traced_as;
  std::optional<PixelRectangle> crop;  // of the view, that key S renders; nothing for all of it

  SpaceOverlays overlays;
  RayInspector rays;
  SectionView section;
  std::shared_ptr<const SliceAxes> section_drawing;  // null when it must be made again
  DrawingSize section_size;                          // of that
  PanelTheme section_theme = PanelTheme::dark;       // likewise
  bool arrows_move_section = false;                  // else the pixel

  const std::unique_ptr<Panels> panels;
  bool shows_panels = false, shows_help = false, lists_scenes = false;

  DrawingDetail detail;  // that the preview was drawn in last
  DrawingSize size;
  double scale = 1;                        // of the screen: pixels per unit of length
  R2::Point pointer{-1, -1};               // where it was last seen, in pixels of the drawing
  std::optional<R2::Point> measured_from;  // where on the cross section it was pressed, while it is
  bool was_asked_to_quit = false, is_closed = false;

  Layout layout() const;
  /// The settings to render the present view with.
  RenderSettings SettingsOfView() const;
  bool HasMovedCamera() const { return SettingsOfView().view.has_value(); }
  /// The ray through a position in the drawing, and what it meets first; nothing where that is the background.
  R3::Ray RayAt(const R2::Point& position) const;
  std::optional<R3::Point> PointAt(const R2::Point& position) const;

  // The picture: the image shown flat, where one is, or the view.
  /// What is shown flat; null where nothing is.
  const RenderJob* FlatJob() const;
  RenderSettings SettingsOfPicture() const;
  Camera CameraOfPicture() const;
  /// The rectangle that the preview is drawn in: the view, or the flat image beside its slider.
  DrawingSize SizeOfPreview() const;
  /// Where it is in the drawing, and where it would be as large as there is room.
  PixelBox PlaceOfPicture() const { return FlatJob() ? flat.Place(FittingPicture()) : FittingPicture(); }
  PixelBox FittingPicture() const;
  /// A position in the drawing as one in that picture.
  R2::Point InPicture(const R2::Point& position) const;
  /// Where in the drawing is what a job has rendered of it: a crop, or all.
  PixelBox PlaceOf(const RenderJob& job) const;
  R2::Point PictureUnderPointer() const { return InPicture(pointer); }

  /// The image of key S in space; nothing where it is not shown.
  std::optional<TracedQuad> Quad() const;
  /// How a message that something is open ends: "; the scene is unlit".
  std::string NotesAfterMessage() const { return scene.Notes().empty() ? "" : "; " + scene.Notes(); }
};

}  // namespace ray
