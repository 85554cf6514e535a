// How soon the viewer answers, drawing without a window.
//   build/bench/view [scene [width height]]     scenes/hello.scn unless named, 512 x 512; run where scenes/ is
//     bench/scenes/large.sh FOLDER           makes a city and a mesh, of a million triangles each
// Figures: start to the first drawing; from an event to its drawing while a live image and a trace run beside; what
// an idle viewer asks of the processor is told by the window itself: /proc/PID/stat.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <vector>

#include "source/draw/MotionDetail.h"
#include "source/draw/contexts/Context.h"
#include "source/draw/gl/Drawer.h"
#include "source/view/Viewer.h"

namespace {

using Clock = std::chrono::steady_clock;
using namespace ray;

class Nobody : public ViewerHost {
  std::string SaveTraced(const RenderJob&) override { return {}; }
  void SaveDrawing() override {}
  std::string SaveRays(const std::string&) override { return {}; }
  std::string SaveText(const std::string&, const std::string&) override { return {}; }
  ReferenceImage ReadImage(const std::string&) override { return {}; }
  void SetClipboard(const std::string&) override {}
  void Print(const std::string&) override {}
};

constexpr int most_moves = 200, least_moves = 1;  // of a drag
constexpr double enough_milliseconds = 5000;       // then a drag of at least `least_moves` ends

double MillisecondsSince(Clock::time_point then) {
  return std::chrono::duration<double, std::milli>(Clock::now() - then).count();
}

/// CPU time, whatever else the machine does. CLOCK_THREAD_CPUTIME_ID gives that of this thread;
/// CLOCK_PROCESS_CPUTIME_ID includes the drawing's own threads and those that trace.
double CpuMilliseconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

void PrintTimes(const char* what, std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const auto at = [&](double share) { return times[static_cast<std::size_t>(share * double(times.size() - 1))]; };
  std::printf("%-44s p50 %7.2f ms   p95 %7.2f ms   p99 %7.2f ms   of %zu\n", what, at(0.5), at(0.95), at(0.99),
              times.size());
  std::fflush(stdout);
}

/// From events until all of their drawing is done: by the clock, and of this thread for each part of it.
struct AnswerTimes {
  std::vector<double> all, handling, showing, drawing, of_process;

  void Print(const char* what) const {
    PrintTimes(what, all);
    PrintTimes("  of this thread: events", handling);
    PrintTimes("  of this thread: what is to be drawn", showing);
    PrintTimes("  of this thread: drawing it", drawing);
    PrintTimes("  of all threads", of_process);
  }
};

/// Times of the moves of a long drag, each drawn as a window draws it: in fewer pixels where a drawing in full takes
/// too long. `detail`: null for all drawings in full.
AnswerTimes Answers(Viewer& viewer, Drawer& drawer, MotionDetail* detail) {
  AnswerTimes times;
  viewer.Handle(ButtonEvent{Button::left, true, 100, 200, {}});
  const auto begun_at = Clock::now();
  for (int i = 0; i < most_moves && (i < least_moves || MillisecondsSince(begun_at) < enough_milliseconds); ++i) {
    const auto start = Clock::now();
    const double begun_by_all = CpuMilliseconds(CLOCK_PROCESS_CPUTIME_ID);
    const double begun = CpuMilliseconds(CLOCK_THREAD_CPUTIME_ID);
    viewer.Handle(MoveEvent{110.0 + 8 * (i % 20), 203});
    const double handled = CpuMilliseconds(CLOCK_THREAD_CPUTIME_ID);
    viewer.Update();
    FrameState shown = viewer.Show();
    if (detail) {
      shown.detail = detail->For(shown, 1e-3 * MillisecondsSince(Clock::time_point()));
    }
    const double to_draw = CpuMilliseconds(CLOCK_THREAD_CPUTIME_ID);
    drawer.Draw(shown);
    Canvas::Finish();
    if (detail) detail->Took(1e-3 * MillisecondsSince(start));
    times.of_process.push_back(CpuMilliseconds(CLOCK_PROCESS_CPUTIME_ID) - begun_by_all);
    times.all.push_back(MillisecondsSince(start));
    times.handling.push_back(handled - begun);
    times.showing.push_back(to_draw - handled);
    times.drawing.push_back(CpuMilliseconds(CLOCK_THREAD_CPUTIME_ID) - to_draw);
  }
  viewer.Handle(ButtonEvent{Button::left, false, 270, 203, {}});
  return times;
}

/// Times of laying out and drawing panels in which nothing has changed, over the time without them.
std::vector<double> PanelTimes(Viewer& viewer, Drawer& drawer) {
  std::vector<double> times;
  for (int i = 0; i < 100; ++i) {
    FrameState shown = viewer.Show();
    const auto start = Clock::now();
    shown = viewer.Show();
    const double laid_out = MillisecondsSince(start);
    const auto with = Clock::now();
    drawer.Draw(shown);
    glFinish();
    const double drawn = MillisecondsSince(with);
    shown.panels.reset();
    const auto without = Clock::now();
    drawer.Draw(shown);
    glFinish();
    times.push_back(laid_out + drawn - MillisecondsSince(without));
  }
  return times;
}

}  // namespace

int main(int argc, char** argv) {
  const auto start = Clock::now();
  ViewerSettings settings;
  settings.scene = argc > 1 ? argv[1] : "scenes/hello.scn";
  settings.render.width = argc > 3 ? std::atoi(argv[2]) : 512;
  settings.render.height = argc > 3 ? std::atoi(argv[3]) : 512;
  settings.render.samples = 1 << 20;  // so that images are never done
  Nobody host;
  const auto scene = std::make_shared<const LoadedScene>(settings.scene, settings.parse, settings.accelerator);
  const auto context = MakeOffscreenContext("auto");
  Painter painter(Canvas::Target::own);
  Drawer drawer(painter);
  Viewer viewer(settings, scene, host);
  drawer.Draw(viewer.Show());
  glFinish();
  std::printf("%s, %s\n", settings.scene.c_str(), context->Name().c_str());
  std::printf("%-44s %7.2f ms\n", "start to first drawing", MillisecondsSince(start));
  const auto answers = [&](const std::string& meanwhile) {
    MotionDetail detail;
    Answers(viewer, drawer, nullptr).Print(("event to drawing in full, " + meanwhile).c_str());
    Answers(viewer, drawer, &detail).Print(("event to drawing, " + meanwhile).c_str());
  };
  answers("nothing traced");
  viewer.Handle(KeyEvent{Key::tab, {}, true});
  answers("panels shown");
  PrintTimes("of that, drawing the panels again", PanelTimes(viewer, drawer));
  viewer.Handle(KeyEvent{Key::tab, {}, true});
  viewer.Handle(KeyEvent{Key::s, {}, true});
  viewer.Update();
  answers("while S renders");
  viewer.Handle(KeyEvent{Key::escape, {}, true});
  viewer.Handle(KeyEvent{Key::p, {}, true});
  viewer.Update();
  answers("live picture");
}
