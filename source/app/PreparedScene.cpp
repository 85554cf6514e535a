#include "source/app/PreparedScene.h"

#include "source/app/options/RenderChecks.h"
#include "source/app/options/SceneSettings.h"
#include "source/app/report/Memory.h"
#include "source/render/RenderInputs.h"
#include "source/render/SharingGain.h"

namespace ray {
namespace {

ParsedScene ParsedFor(const RenderOptions& asked) {
  CheckMachine(asked.render, asked.accelerator);
  return Parse(asked.files.scene, asked.parse);
}

std::unique_ptr<const Accelerator> AcceleratorFor(const World& world, const RenderOptions& options) {
  CheckMemory(world, ImageBytes(options.render, options.files, options.checkpoint.seconds > 0), options.memory);
  AcceleratorSettings settings = options.accelerator;
  settings.expected_rays = ExpectedRays(options.render);
  return FindAcceleratorKind(settings.name)->Make(world, settings);
}

}  // namespace

ReadScene::ReadScene(const RenderOptions& asked)
    : parsed(ParsedFor(asked)), options(WithSettingsOf(parsed.scene, asked)) {}

PreparedScene::PreparedScene(ReadScene& read)
    : world(read.parsed.scene), accelerator(AcceleratorFor(world, read.options)) {
  read.options.render.shares_light = SharesLight(world, *accelerator, read.options.render);
}

}  // namespace ray
