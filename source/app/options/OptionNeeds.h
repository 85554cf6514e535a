#pragma once

#include <string>

#include "source/app/options/FileNames.h"
#include "source/app/options/OptionFacts.h"
#include "source/app/options/RenderOptions.h"
#include "source/render/SharingGain.h"

/// The conditions that rows of the option table state as their needs.
namespace ray::needs {

inline const RenderOptions& Of(const Options& all) { return As<RenderOptions>(all); }

inline bool HasFormat(const std::string& file, const std::string& name) {
  const R2::ImageFormat* format = FormatOfImage(file);
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
  return {[](const Options& all) { return Of(all).render.mode == mode; }, otherwise};
}

inline constexpr OptionNeed png{[](const Options& all) { return HasFormat(Of(all).files.image, "png"); },
                                "unless the image is a PNG"};
inline constexpr OptionNeed jpeg{[](const Options& all) { return HasFormat(Of(all).files.image, "jpeg"); },
                                 "unless the image is a JPEG"};
inline constexpr OptionNeed format_of_bytes{[](const Options& all) {
                                              const R2::ImageFormat* format = FormatOfImage(Of(all).files.image);
                                              return format && !format->is_linear;
                                            },
                                            "on an image of linear values, as EXR, HDR and PFM are"};
inline constexpr OptionNeed denoise{[](const Options& all) { return Of(all).render.denoise; }, "without -denoise"};
inline constexpr OptionNeed whole_samples{[](const Options& all) { return !IsSubsampled(Of(all).render); },
                                          "where pixels have at most one sample, at their centers"};
inline constexpr OptionNeed lens{[](const Options& all) { return Of(all).render.camera.HasLens(); },
                                 "without -aperture"};
inline constexpr OptionNeed grid{[](const Options& all) { return IsGrid(Of(all).render.trace.sampler); },
                                 "without -sampler grid"};
inline constexpr OptionNeed spiral{[](const Options& all) { return Of(all).render.camera.lens != LensPattern::random; },
                                   "without -lens spiral"};
inline constexpr OptionNeed mode_zbuffer = InMode<RenderMode::zbuffer>("without -mode zbuffer");
inline constexpr OptionNeed mode_gooch = InMode<RenderMode::gooch>("without -mode gooch");
inline constexpr OptionNeed mode_toon = InMode<RenderMode::toon>("without -mode toon");
inline constexpr OptionNeed mode_hatching = InMode<RenderMode::hatching>("without -mode hatching");
inline constexpr OptionNeed mode_path = InMode<RenderMode::path>("without -mode path");
inline constexpr OptionNeed shared_light{[](const Options& all) {
                                           const RenderSettings& render = Of(all).render;
                                           return render.share != Sharing::on || SharesLight(render).value_or(true);
                                         },
                                         "with -max_depth 0, -shadows off or -adaptive neighbors"};
inline constexpr OptionNeed mode_of_light{[](const Options& all) { return ShowsLight(Of(all).render.mode); },
                                          "without a mode of light: whitted, path, gooch, toon or hatching"};
inline constexpr OptionNeed colored_lamps{[](const Options& all) { return HasColoredLamps(Of(all).render); },
                                          "without -mode whitted or -emission color"};
inline constexpr OptionNeed error_of_tiles{
    [](const Options& all) { return Of(all).render.budget.adaptive != Adaptive::tile || Of(all).render.budget.error; },
    "without -error"};
inline constexpr OptionNeed samples_of_neighbors{[](const Options& all) {
                                                   return Of(all).render.budget.adaptive != Adaptive::neighbors ||
                                                          Of(all).render.samples > 1;
                                                 },
                                                 "without -samples"};
inline constexpr OptionNeed samples_to_limit{
    [](const Options& all) { return Of(all).render.samples > 1 || !Of(all).render.budget.IsOpen(); },
    "with -time or -error unless it is 2 or more"};
inline constexpr OptionNeed reported_error{
    [](const Options& all) { return Of(all).stats || ReportsError(Of(all).render, Of(all).files); },
    "without -error, -time, -denoise, -reference, -stats or -report"};
inline constexpr OptionNeed out_folder{[](const Options& all) { return !Of(all).out_folder.empty(); },
                                       "without -out_folder"};
inline constexpr OptionNeed structure{
    [](const Options& all) { return Of(all).accelerator.name != "none" && Of(all).accelerator.name != "graph"; },
    "with -accel none or graph"};
inline constexpr OptionNeed small_leaves{
    [](const Options& all) { return Of(all).accelerator.name != "bvh" || Of(all).accelerator.resolution <= 8; },
    "above 8 with -accel bvh"};
inline constexpr OptionNeed octree{[](const Options& all) { return Of(all).accelerator.name == "octree"; },
                                   "without -accel octree"};
inline constexpr OptionNeed graph{[](const Options& all) { return Of(all).accelerator.name == "graph"; },
                                  "without -accel graph"};

}  // namespace ray::needs
