#include "source/app/rayview/LoadingWindow.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <variant>

#include "source/app/Status.h"
#include "source/draw/gl/Canvas.h"
#include "source/render/forecast/SecondsOf.h"

namespace ray {

std::unique_ptr<Window> WindowUntilLoaded(const std::future<std::shared_ptr<const LoadedScene>>& loading, int width,
                                          int height, const std::string& file) {
  constexpr std::chrono::milliseconds moment{1000};
  constexpr double seconds_between_looks = 0.1;
  constexpr R2::Color ground{0.15, 0.15, 0.17};
  const auto start = std::chrono::steady_clock::now();
  if (loading.wait_for(moment) == std::future_status::ready) return nullptr;
  std::unique_ptr<Window> window;
  try {
    window = MakeWindow(width, height, "rayview");
  } catch (const ContextError&) {
    return nullptr;  // the error is reported once there is something to draw
  }
  Canvas canvas(Canvas::Target::window);
  const std::string name = std::filesystem::path(file).filename().string();
  while (loading.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    const auto seconds = static_cast<int>(SecondsSince(start));
    window->SetTitle("rayview: reading " + name + (seconds > 0 ? ", " + std::to_string(seconds) + " s" : ""));
    canvas.Begin(window->Width(), window->Height(), ground);
    window->Show();
    for (const Event& event : window->Wait(seconds_between_looks))
      if (std::holds_alternative<CloseEvent>(event)) std::_Exit(status::done);  // nothing has been written yet
  }
  return window;
}

}  // namespace ray
