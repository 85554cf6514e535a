#pragma once

#include <string>

#include "source/app/options/Options.h"
#include "source/app/options/PictureName.h"

/// The conditions that rows of the option table name as their needs.
namespace ray::needs {

inline bool HasFormat(const std::string& picture, const std::string& name) {
  const R2::ImageFormat* format = FormatOfPicture(picture);
  return format && format->name == name;
}

inline bool HasColoredLamps(const RenderSettings& render) {
  return render.mode == RenderMode::whitted || (render.mode == RenderMode::path && !EmitsRadiance(render));
}

inline bool ReportsError(const RenderSettings& render, const FileOptions& files) {
  return render.budget.IsOpen() || render.denoise || !files.report.empty() || !files.reference.empty();
}

template <RenderMode mode>
constexpr OptionNeed InMode(const char* otherwise) {
  return {[](const Options& o) { return o.render.mode == mode; }, otherwise};
}

inline constexpr OptionNeed png{[](const Options& o) { return HasFormat(o.files.picture, "png"); },
                                "unless the image is a PNG"};
inline constexpr OptionNeed jpeg{[](const Options& o) { return HasFormat(o.files.picture, "jpeg"); },
                                 "unless the image is a JPEG"};
inline constexpr OptionNeed format_of_bytes{[](const Options& o) {
                                              const R2::ImageFormat* format = FormatOfPicture(o.files.picture);
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
inline constexpr OptionNeed mode_zbuffer = InMode<RenderMode::zbuffer>("without -mode zbuffer");
inline constexpr OptionNeed mode_gooch = InMode<RenderMode::gooch>("without -mode gooch");
inline constexpr OptionNeed mode_toon = InMode<RenderMode::toon>("without -mode toon");
inline constexpr OptionNeed mode_hatching = InMode<RenderMode::hatching>("without -mode hatching");
inline constexpr OptionNeed mode_path = InMode<RenderMode::path>("without -mode path");
inline constexpr OptionNeed mode_of_light{[](const Options& o) { return ShowsLight(o.render.mode); },
                                          "without a mode of light: whitted, path, gooch, toon or hatching"};
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
inline constexpr OptionNeed reported_error{[](const Options& o) { return o.stats || ReportsError(o.render, o.files); },
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
