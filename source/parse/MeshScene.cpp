#include "source/parse/MeshScene.h"

#include <utility>

#include "source/parse/SceneBuilder.h"
#include "source/parse/Text.h"

namespace ray {

Scene ReadMeshScene(const Files& files, Assets& assets, Report& report) {
  SceneBuilder builder;
  builder.scene.files.push_back(files.TopName());
  try {
    const Assets::BoxedMesh boxed = assets.MeshOf(files.Top());
    Node node;
    node.shape = boxed.mesh;
    node.bounds = boxed.bounds;
    builder.Add(std::move(node));
  } catch (const FileError& error) {
    report.Error(ErrorIn(files.TopName(), error.message, error.hint));
  } catch (const SceneError& error) {
    report.Error(error);
  }
  return builder.Finish();
}

}  // namespace ray
