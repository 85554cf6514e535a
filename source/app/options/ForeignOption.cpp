#include "source/app/options/ForeignOption.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "source/app/options/OptionTable.h"
#include "source/text/Words.h"

namespace ray {
namespace {

constexpr const char* name_image = "the image is named behind the scene: raypro scene.scn out.png";
constexpr const char* name_scene = "the scene is named without an option: raypro scene.scn out.png";
constexpr const char* of_comp30019 =
    "raypro scene.scn out.png names both; '-as comp30019' before all else takes that course's options";
constexpr const char* by_extension = "the extension of the image's name chooses its format";
constexpr const char* both_sizes = "use -width and -height";
constexpr const char* in_scene = "the scene states its camera, lights and background";
constexpr const char* one_frame = "a scene is one frame; rayimg movie joins JPEG images";
constexpr const char* no_window = "raypro opens no window; leave it out";
constexpr const char* no_gpu = "raypro renders on the processor alone; leave it out";
constexpr const char* afterwards =
    "values are written as they are, or with -srgb; rayimg convert has -exposure and -tonemap";
constexpr const char* overwrites = "a finished image is replaced without asking; -restart replaces an unfinished one";

// clang-format off
constexpr ForeignOption foreign_options[] = {
    {"-aa", "-samples"},
    {"-antialias", "-samples"},
    {"-antialiasing", "-samples"},
    {"-n", "-samples"},
    {"-pixelsamples", "-samples"},
    {"-rays", "-samples"},
    {"-s", "-samples"},
    {"-samples-per-pixel", "-samples"},
    {"-samples_per_pixel", "-samples"},
    {"-spp", "-samples"},
    {"-w", "-width"},
    {"-W", "-width"},
    {"-x", "-width"},
    {"-xres", "-width"},
    {"-H", "-height"},
    {"-y", "-height"},
    {"-yres", "-height"},
    {"-dimensions", both_sizes},
    {"-geometry", both_sizes},
    {"-r", both_sizes},
    {"-res", both_sizes},
    {"-resolution", both_sizes},
    {"-size", both_sizes},
    {"-bounces", "-max_depth"},
    {"-depth", "-max_depth"},
    {"-d", "-max_depth"},
    {"-max_bounces", "-max_depth"},
    {"-max-bounces", "-max_depth"},
    {"-recursion", "-max_depth"},
    {"-reflections", "-max_depth"},
    {"-o", "-image"},
    {"-o", name_image},
    {"-O", name_image},
    {"-out", "-image"},
    {"-out", name_image},
    {"-outfile", name_image},
    {"-output", "-image"},
    {"-output", name_image},
    {"-render-output", name_image},
    {"-f", of_comp30019},
    {"-file", name_scene},
    {"-i", name_scene},
    {"-I", name_scene},
    {"-in", name_scene},
    {"-input", name_scene},
    {"-scene", name_scene},
    {"-F", by_extension},
    {"-output_format", by_extension},
    {"-render-format", by_extension},
    {"-cores", "-threads"},
    {"-cpus", "-threads"},
    {"-j", "-threads"},
    {"-jobs", "-threads"},
    {"-nproc", "-threads"},
    {"-nthreads", "-threads"},
    {"-t", "-threads"},
    {"-p", "-threads"},
    {"-T", "-time"},
    {"-max_time", "-time"},
    {"-timeout", "-time"},
    {"-e", "-error"},
    {"-noise", "-error"},
    {"-noise_threshold", "-error"},
    {"-threshold", "-error"},
    {"-E", "-mode"},
    {"-engine", "-mode"},
    {"-integrator", "-mode"},
    {"-m", "-mode"},
    {"-method", "-mode"},
    {"-renderer", "-mode"},
    {"-gi", "-mode path"},
    {"-path", "-mode path"},
    {"-pathtracing", "-mode path"},
    {"-pt", "-mode path"},
    {"-normals", "-mode normal"},
    {"-draft", "-quality draft"},
    {"-fast", "-quality draft"},
    {"-quick", "-quality draft"},
    {"-preset", "-quality"},
    {"-q", "-quiet"},
    {"-silent", "-quiet"},
    {"-log-level", "-verbose"},
    {"-log_level", "-verbose"},
    {"-progress", "progress is shown unless -quiet"},
    {"-json", "-report"},
    {"-log", "-report"},
    {"-l", "-list"},
    {"-V", "-version"},
    {"-?", "-help"},
    {"-man-page", "-man"},
    {"-usage", "-help"},
    {"-lint", "-check"},
    {"-parse-only", "-check"},
    {"-validate", "-check"},
    {"-verify", "-check"},
    {"-debug", "-debugpixel"},
    {"-pixel", "-debugpixel"},
    {"-cropwindow", "-crop"},
    {"-pixelbounds", "-crop"},
    {"-region", "-crop"},
    {"-window", "-crop"},
    {"-c", "-resume"},
    {"-continue", "-resume"},
    {"-write-partial-images", "-checkpoint"},
    {"-force", overwrites},
    {"-overwrite", overwrites},
    {"-dof", "-aperture"},
    {"-fstop", "-aperture"},
    {"-lens_radius", "-aperture"},
    {"-focal_distance", "-focus"},
    {"-focal_length", "-focus"},
    {"-focus_distance", "-focus"},
    {"-background", "-headless"},
    {"-background", "the background is the scene's: 'background r g b' in a .scn file"},
    {"-b", "-headless"},
    {"-b", no_window},
    {"-display", no_window},
    {"-gui", "rayview shows a scene in a window"},
    {"-interactive", "rayview shows a scene in a window"},
    {"-preview", "rayview shows a scene in a window"},
    {"-cuda", no_gpu},
    {"-gpu", no_gpu},
    {"-optix", no_gpu},
    {"-a", one_frame},
    {"-frame", one_frame},
    {"-frames", one_frame},
    {"-render-anim", one_frame},
    {"-render-frame", one_frame},
    {"-bg", in_scene},
    {"-camera", in_scene},
    {"-lookat", "-eye"},
    {"-D", "a scene has no parameters; options such as -samples 64 take their place"},
    {"-P", "a scene has no parameters; options such as -samples 64 take their place"},
    {"-envmap", "-env"},
    {"-environment", "-env"},
    {"-hdri", "-env"},
    {"-ibl", "-env"},
    {"-sky", "-env"},
    {"-accelerator", "-accel"},
    {"-bvh", "-accel bvh"},
    {"-grid", "-accel grid"},
    {"-kdtree", "-accel bvh"},
    {"-octree", "-accel octree"},
    {"-oidn", "-denoise -denoiser oidn"},
    {"-exposure", afterwards},
    {"-g", afterwards},
    {"-gamma", afterwards},
    {"-tonemap", afterwards},
    {"-tonemapping", afterwards},
    {"-L", "-allow_path"},
    {"-include_path", "-allow_path"},

    {"+A", "-samples"},
    {"+C", "-resume"},
    {"+D", no_window},
    {"+F", by_extension},
    {"+H", "-height"},
    {"+I", name_scene},
    {"+L", "-allow_path"},
    {"+O", name_image},
    {"+P", no_window},
    {"+Q", "-quality"},
    {"+R", "-samples"},
    {"+SR", "-crop"},
    {"+V", "-verbose"},
    {"+W", "-width"},
    {"+WT", "-threads"},
};
// clang-format on

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// What the program can do about it, with the value that was typed as one word with it.
std::string AnswerText(Program program, std::string_view answer, const std::string& value) {
  if (!answer.starts_with('-')) return "; " + std::string(answer);
  const std::string option(answer.substr(1, answer.find(' ') - 1));
  if (!FindOption(program, option)) return {};
  return "; did you mean '" + std::string(answer) + (value.empty() ? "" : " " + value) + "'?";
}

/// The entry that is the longest beginning of POV-Ray's option.
const ForeignOption* FindPlus(std::string_view word) {
  const ForeignOption* best = nullptr;
  for (const ForeignOption& foreign : foreign_options)
    if (word.starts_with(foreign.word) &&
        (!best || std::string_view(foreign.word).size() > std::string_view(best->word).size()))
      best = &foreign;
  return best;
}

/// Of the entries of a word the first that the program can do something about.
std::string AnswerTo(Program program, const std::string& word, const std::string& value) {
  for (const ForeignOption& foreign : foreign_options)
    if (word == foreign.word)
      if (std::string text = AnswerText(program, foreign.answer, value); !text.empty()) return text;
  return {};
}

/// "512" of "-w512", and of "+W512".
std::string DigitsAtTheEnd(const std::string& word) {
  std::size_t begin = word.size();
  while (begin > 0 && IsDigit(word[begin - 1])) --begin;
  return word.substr(begin);
}

}  // namespace

std::span<const ForeignOption> ForeignOptions() { return foreign_options; }

bool IsOfPovRay(const std::string& word) {
  return word.size() > 1 && word[0] == '+' && std::isalpha(static_cast<unsigned char>(word[1]));
}

std::string ForeignHint(Program program, const std::string& word) {
  if (program == Program::rayimg || program == Program::raygrade) return {};
  if (IsOfPovRay(word)) {
    const ForeignOption* const foreign = FindPlus(word);
    return foreign ? AnswerText(program, foreign->answer, DigitsAtTheEnd(word)) : std::string();
  }
  const std::string option = "-" + SplitOption(word).name, digits = DigitsAtTheEnd(option);
  const std::string answer = AnswerTo(program, option, {});
  return answer.empty() ? AnswerTo(program, option.substr(0, option.size() - digits.size()), digits) : answer;
}

}  // namespace ray
