#pragma once

#include <string>

#include "source/app/options/Options.h"
#include "source/app/options/PictureName.h"

/// The conditions that rows of the option table name as their needs.
namespace ray::needs {

inline bool HasFormat(const Options& options, const std::string& name) {
  const R2::ImageFormat* format = FormatOfPicture(options.picture);
  return format && format->name == name;
}

inline bool HasColoredLamps(const RenderSettings& render) {
  return render.mode == RenderMode::whitted || (render.mode == RenderMode::path && !EmitsRadiance(render));
}

inline bool ReportsError(const Options& options) {
  return options.render.budget.IsOpen() || options.render.denoise || options.stats || !options.report.empty() ||
         !options.reference.empty();
}

template <RenderMode mode>
bool HasMode(const Options& options) {
  return options.render.mode == mode;
}

inline constexpr OptionNeed png{[](const Options& o) { return HasFormat(o, "png"); }, "unless the image is a PNG"};
inline constexpr OptionNeed jpeg{[](const Options& o) { return HasFormat(o, "jpeg"); }, "unless the image is a JPEG"};
inline constexpr OptionNeed format_of_bytes{[](const Options& o) {
                                              const R2::ImageFormat* format = FormatOfPicture(o.picture);
                                              return format && !format->is_linear;
                                            },
                                            "on an image of linear values, as EXR, HDR and PFM are"};
inline constexpr OptionNeed denoise{[](const Options& o) { return o.render.denoise; }, "without -denoise"};
inline constexpr OptionNeed whole_samples{[](const Options& o) { return !IsSubsampled(o.render); },
                                          "where pixels have at most one sample, at their centers"};
inline constexpr OptionNeed lens{[](const Options& o) { return o.render.camera.HasLens(); }, "without -aperture"};
inline constexpr OptionNeed grid{[](const Options& o) { return IsGrid(o.render.trace.sampler); },
                                 "without -sampler grid"};
inline constexpr OptionNeed spiral{[](const Options& o) { return o.render.camera.lens != LensPattern::random; },
                                   "without -lens spiral"};
inline constexpr OptionNeed mode_zbuffer{HasMode<RenderMode::zbuffer>, "without -mode zbuffer"};
inline constexpr OptionNeed mode_gooch{HasMode<RenderMode::gooch>, "without -mode gooch"};
inline constexpr OptionNeed mode_toon{HasMode<RenderMode::toon>, "without -mode toon"};
inline constexpr OptionNeed mode_hatching{HasMode<RenderMode::hatching>, "without -mode hatching"};
inline constexpr OptionNeed mode_path{HasMode<RenderMode::path>, "without -mode path"};
inline constexpr OptionNeed colored_lamps{[](const Options& o) { return HasColoredLamps(o.render); },
                                          "without -mode whitted or -emission color"};
inline constexpr OptionNeed error_of_tiles{
    [](const Options& o) { return o.render.budget.adaptive != Adaptive::tile || o.render.budget.error; },
    "without -error"};
inline constexpr OptionNeed samples_of_neighbors{
    [](const Options& o) { return o.render.budget.adaptive != Adaptive::neighbors || o.render.samples > 1; },
    "without -samples"};
inline constexpr OptionNeed samples_to_limit{
    [](const Options& o) { return o.render.samples > 1 || !o.render.budget.IsOpen(); },
    "with -time or -error unless it is 2 or more"};
inline constexpr OptionNeed reported_error{ReportsError,
                                           "without -error, -time, -denoise, -reference, -stats or -report"};
inline constexpr OptionNeed out_folder{[](const Options& o) { return !o.out_folder.empty(); }, "without -out_folder"};
inline constexpr OptionNeed structure{
    [](const Options& o) { return o.accelerator.name != "none" && o.accelerator.name != "graph"; },
    "with -accel none or graph"};
inline constexpr OptionNeed small_leaves{
    [](const Options& o) { return o.accelerator.name != "bvh" || o.accelerator.resolution <= 8; },
    "above 8 with -accel bvh"};
inline constexpr OptionNeed octree{[](const Options& o) { return o.accelerator.name == "octree"; },
                                   "without -accel octree"};
inline constexpr OptionNeed graph{[](const Options& o) { return o.accelerator.name == "graph"; },
                                  "without -accel graph"};

}  // namespace ray::needs
