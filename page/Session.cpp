#include <algorithm>
#include <cstdlib>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "page/MemoryFiles.h"
#include "page/PixelRays.h"
#include "page/Warnings.h"
#include "source/app/PreparedScene.h"
#include "source/app/Status.h"
#include "source/app/manual/Manual.h"
#include "source/app/options/CommandLine.h"
#include "source/app/report/Check.h"
#include "source/film/Film.h"
#include "source/parse/SceneError.h"
#include "source/render/FirstLook.h"
#include "source/render/Layer.h"
#include "source/render/Parts.h"
#include "source/render/PixelTrace.h"
#include "source/render/Render.h"
#include "source/text/Quoting.h"

/// What a page calls. An instance of the module holds one session: a scene that is open, and an image of it. Several
/// instances render an image together, each its own part (source/render/Parts.h); one of them collects the parts. Each
/// call returns a status; text and bytes that it leaves are valid until the next one.
namespace ray {
namespace {

using Bytes = std::vector<unsigned char>;

// What instances exchange is of one page, which gave all of them the same scene and options.
constexpr const char* identity = "page";

// A worker has one thread and takes twice the time of raypro, so images are smaller; all have smooth edges.
constexpr DefaultImage image_of_page{.side = 512, .samples = 16, .samples_of_a_chosen_size = 16};

struct Session {
  explicit Session(const RenderOptions& asked) : scene(asked), prepared(scene) {}

  ReadScene scene;
  const PreparedScene prepared;
  std::optional<Film> empty_film;
  RenderState state;  // of the round: what is due, and the samples that are there
  bool has_looked = false;
  std::uint32_t pass_end = 0;  // samples per pixel and stream of the pass that is over
  std::optional<RenderResult> result;
};

std::unique_ptr<Session> session;
std::string text;
Bytes bytes;

/// Calls `work` and returns what it does; negative for a mistake, which is then the text.
template <typename Work>
int Guarded(const Work& work) {
  text.clear();
  try {
    return work();
  } catch (const SceneErrors& errors) {
    text = errors.what();
    return -status::bad_scene;
  } catch (const UsageError& error) {
    text = error.what();
    return -status::wrong_arguments;
  } catch (const std::bad_alloc&) {
    text = "there is not enough memory";
  } catch (const std::exception& error) {
    text = error.what();
  }
  return -status::failed;
}

std::vector<std::string> Lines(const char* all) {
  std::vector<std::string> lines;
  std::string_view rest = all;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    lines.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return lines;
}

/// What asks for files, clocks or other machines has no meaning in a page.
void RefuseOthers(const RenderOptions& options) {
#ifndef RAYPRO_YAML
  if (options.files.scene.ends_with(".yaml") || options.files.scene.ends_with(".yml"))
    throw UsageError("this page was built without YAML; JSON with the same keys is read");
#endif
  if (options.request) throw UsageError("a page takes the options of an image, not requests");
  for (const char* name : {"time", "part", "parts", "missing", "report", "replay", "reference", "layers", "out_folder",
                           "resume", "restart", "checkpoint", "keep_checkpoint", "allow_path"})
    if (options.IsGiven(name)) throw UsageError("-" + std::string(name) + " has no meaning in a page");
}

void Warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) Warnings() += warning + "\n";
}

int Open(const std::vector<std::string>& words) {
  session.reset();  // so that its memory can be used
  Warnings().clear();
  RenderOptions asked = ReadCommandLine(Program::raypro, words);
  asked.default_image = image_of_page;
  RefuseOthers(asked);
  auto opened = std::make_unique<Session>(asked);
  const RenderSettings& render = opened->scene.options.render;
  Warn(opened->scene.parsed.warnings);
  Warn(opened->prepared.world.Warnings());
  Warn(PlainMistakes(opened->prepared.world, render));
  opened->empty_film = EmptyFilmOf(render);
  opened->state = FirstRound(render, *opened->empty_film);
  session = std::move(opened);
  text = Warnings();
  return status::done;
}

Session& Opened() {
  if (!session) throw std::runtime_error("no scene is open");
  return *session;
}

/// Samples per pixel and stream after the next pass. Each pass doubles them, so that looking on costs little.
std::uint32_t NextEnd(std::uint32_t done) {
  constexpr std::uint32_t most_at_once = 64;  // the film adds up samples in steps of so many at most
  return done < most_at_once ? std::max(done * 2, std::uint32_t{1}) : done + most_at_once;
}

/// Costs depend on what was traced before, and subsampled images are looks already.
bool BeginsWithLook(const Session& of) {
  return !of.has_looked && of.state.schedule.targets.places.empty() && !ShowsCosts(of.scene.options.render.mode);
}

/// Changes what is due in the round to what is due in the next pass.
void LimitToPass(Session& of, PassTargets& due) {
  if (BeginsWithLook(of)) {
    due = LookTargets(due.samples.size(), BlockOrder::places / 16);
  } else {
    of.pass_end = NextEnd(of.pass_end);
    for (std::uint32_t& samples : due.samples) samples = std::min(samples, of.pass_end);
  }
  of.has_looked = true;
}

ImagePart PartOf(int index, int of) {
  if (index < 1 || index > of || of > most_image_parts) throw UsageError("there is no such part of an image");
  return {index, of};
}

/// Takes one more pass of samples in the blocks of a part. Returns whether more are due in this round.
bool RenderPass(Session& of, const ImagePart& part) {
  RenderState pass = of.state;
  const std::uint32_t target = std::ranges::max(pass.schedule.targets.samples);
  LimitToPass(of, pass.schedule.targets);
  RenderSettings settings = of.scene.options.render;
  settings.part = part;
  RenderMonitor monitor;
  monitor.resume = [&](const Film&) { return std::move(pass); };
  monitor.save = [&](const RenderState& now) {
    of.state.blocks = now.blocks;
    of.state.rays = now.rays;
  };
  RenderPart(of.prepared.world, *of.prepared.accelerator, settings, monitor);
  return of.pass_end < target;
}

/// The image so far as bytes r g b a; a is 0 where another part has the pixel.
Bytes Preview(const Session& of, const ImagePart& part) {
  Film film = *of.empty_film;
  const std::vector<int> parts = PartsOfBlocks(film, part.of);
  for (int i = 0; i < film.Blocks(); ++i) film[i] = of.state.blocks[static_cast<std::size_t>(i)];
  const RenderSettings& render = of.scene.options.render;
  const R2::Image shown = LayerAsShown(render.mode, film.Image(render.quantization));
  const Bytes ppm = R2::FormatForName("image.ppm")->encode(shown, of.scene.options.encoding, {});
  const auto pixels = static_cast<std::size_t>(film.Region().Area());
  const unsigned char* rgb = ppm.data() + (ppm.size() - 3 * pixels);
  Bytes rgba;
  rgba.reserve(4 * pixels);
  for (int y = film.Region().y1 - 1; y >= film.Region().y0; --y)
    for (int x = film.Region().x0; x < film.Region().x1; ++x, rgb += 3) {
      rgba.insert(rgba.end(), rgb, rgb + 3);
      rgba.push_back(parts[static_cast<std::size_t>(film.BlockOf(x, y))] == part.index ? 255 : 0);
    }
  return rgba;
}

/// Decides about the next round once all parts are there. Returns whether there is one; else the image is finished.
bool FinishRound(Session& of) {
  if (auto next = NextRound(of.prepared.world, *of.prepared.accelerator, of.scene.options.render, of.state)) {
    of.state = std::move(*next);
    return true;
  }
  RenderMonitor monitor;
  monitor.resume = [&](const Film&) { return std::move(of.state); };
  of.result = Render(of.prepared.world, *of.prepared.accelerator, of.scene.options.render, monitor);
  return false;
}

Bytes FileOf(const Session& of, const std::string& name) {
  if (!of.result) throw std::runtime_error("the image is not finished");
  const R2::ImageFormat* const format = R2::FormatForName(name);
  if (!format) throw UsageError("cannot write " + Quoted(name));
  const R2::Image& image = of.result->image;
  return format->encode(format->is_linear ? image : LayerAsShown(of.scene.options.render.mode, image),
                        of.scene.options.encoding, {});
}

/// The rays of a pixel as a tree, and as lines in the image.
struct PixelRays {
  std::string tree, lines;
};

PixelRays RaysThrough(const Session& of, int x, int y) {
  const RenderSettings& render = of.scene.options.render;
  if (x < 0 || y < 0 || x >= render.width || y >= render.height) throw UsageError("the image has no such pixel");
  const World& world = of.prepared.world;
  const Accelerator& accelerator = *of.prepared.accelerator;
  const PixelTrace trace = TracePixel(world, accelerator, render, x, y);
  return {RayTree(trace, world, render), RaysInImage(trace, world, accelerator, render)};
}

}  // namespace

std::string& Warnings() {
  static std::string lines;
  return lines;
}

}  // namespace ray

#define EXPORT(name) extern "C" __attribute__((export_name(name)))

using namespace ray;

/// Memory for what the page hands over; it belongs to the call that takes it.
EXPORT("allocate") void* Allocate(std::size_t size) { return std::malloc(size > 0 ? size : 1); }
EXPORT("release") void Release(void* memory) { std::free(memory); }

EXPORT("text") const char* Text() { return text.data(); }
EXPORT("text_size") std::size_t TextSize() { return text.size(); }
EXPORT("bytes") const unsigned char* BytesLeft() { return bytes.data(); }
EXPORT("bytes_size") std::size_t BytesSize() { return bytes.size(); }

/// Puts a file where scenes look for it: an absolute name.
EXPORT("put_file") int PutFile(const char* name, const char* begin, std::size_t size) {
  return Guarded([&] {
    MemoryFiles()[name].assign(begin, size);
    return status::done;
  });
}
EXPORT("remove_files") void RemoveFiles() { MemoryFiles().clear(); }

/// Opens a scene: the words of raypro's command line, one a line. The text is warnings, or what is wrong.
EXPORT("open") int OpenScene(const char* words) {
  return Guarded([&] { return Open(Lines(words)); });
}

/// The text is what -check prints of the open scene.
EXPORT("check") int Check() {
  return Guarded([] {
    text = SceneSummary(Opened().prepared.world, Opened().scene.options.render);
    for (const std::string& mistake : LikelyMistakes(Opened().prepared.world, Opened().scene.options.render))
      text += mistake + "\n";
    return status::done;
  });
}

/// The text is what -list prints of a subject.
EXPORT("list") int List(const char* subject) {
  return Guarded([&] {
    text = Listing(Program::raypro, subject);
    return status::done;
  });
}

EXPORT("left") int Left() { return session ? RegionOf(session->scene.options.render).x0 : 0; }
EXPORT("bottom") int Bottom() { return session ? RegionOf(session->scene.options.render).y0 : 0; }
EXPORT("width") int Width() { return session ? RegionOf(session->scene.options.render).Width() : 0; }
EXPORT("height") int Height() { return session ? RegionOf(session->scene.options.render).Height() : 0; }

/// Takes a pass of samples in part `index` of `of`, 1-based. The bytes are the image so far, r g b a. Returns 1 while
/// more samples are due in this round, 0 when they are there.
EXPORT("render_part") int RenderPartOf(int index, int of) {
  return Guarded([&] {
    const ImagePart part = PartOf(index, of);
    const bool has_more = RenderPass(Opened(), part);
    bytes = Preview(Opened(), part);
    return has_more ? 1 : 0;
  });
}

/// The bytes are the samples so far, for another instance.
EXPORT("part") int Part() {
  return Guarded([] {
    bytes = Encoded(Opened().state, identity);
    return status::done;
  });
}

/// Joins the samples of another instance's part.
EXPORT("take_part") int TakePart(int index, int of, const unsigned char* begin, std::size_t size) {
  return Guarded([&] {
    Session& s = Opened();
    PartOf(index, of);
    RenderState theirs = DecodedState({begin, size}, identity, *s.empty_film);
    s.state.rays += theirs.rays;
    TakeBlocks(s.state, std::move(theirs), index, PartsOfBlocks(*s.empty_film, of));
    return status::done;
  });
}

/// Goes on from a round that another instance has decided about.
EXPORT("take_round") int TakeRound(const unsigned char* begin, std::size_t size) {
  return Guarded([&] {
    Opened().state = DecodedState({begin, size}, identity, *Opened().empty_film);
    return status::done;
  });
}

/// To be called once all parts are joined. Returns 1 when another round is due, of which the bytes are the beginning;
/// 0 when the image is finished.
EXPORT("finish_round") int FinishRoundOf() {
  return Guarded([] {
    if (!FinishRound(Opened())) return 0;
    bytes = Encoded(Opened().state, identity);
    return 1;
  });
}

/// The bytes are the finished image as a file; the name's extension chooses the format.
EXPORT("film") int FilmAs(const char* name) {
  return Guarded([&] {
    bytes = FileOf(Opened(), name);
    return status::done;
  });
}

/// The text is the tree of rays of a pixel of the whole image, columns from the left and rows from the bottom. The
/// bytes are the same rays as lines in the image, see PixelRays.h.
EXPORT("debug_pixel") int DebugPixelAt(int x, int y) {
  return Guarded([&] {
    PixelRays rays = RaysThrough(Opened(), x, y);
    bytes.assign(rays.lines.begin(), rays.lines.end());
    text = std::move(rays.tree);
    return status::done;
  });
}
