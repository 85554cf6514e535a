#include "source/app/files/ConvertScene.h"

#include <fstream>
#include <iterator>

#include "source/app/Status.h"
#include "source/app/files/OutputFile.h"
#include "source/app/options/SceneSettings.h"
#include "source/app/report/Messages.h"
#include "source/parse/scn/ScnText.h"
#include "source/text/LowerCase.h"
#include "source/text/Quoting.h"

namespace ray {
namespace {

namespace fs = std::filesystem;

/// Returns the real path, on which relative names in the file depend.
fs::path Canonical(const fs::path& target) {
  return fs::canonical(target.parent_path().empty() ? "." : target.parent_path()) / target.filename();
}

std::span<const unsigned char> BytesOfText(const std::string& text) {
  return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

/// Checks a mesh file, whose name the user did not type: an existing file with different content is not replaced.
OutputFile CheckMesh(const fs::path& file, const std::string& content, std::span<const std::string> inputs) {
  OutputFile output = CheckOutput(file, inputs);
  std::ifstream there(output.target, std::ios::binary);
  if (there && std::string(std::istreambuf_iterator<char>(there), {}) != content)
    throw OutputError(QuotedPath(file.string()) +
                      " already exists with different content; remove it, or use another name for the scene");
  return output;
}

void WarnOfText(const ScnText& text, const std::string& name, bool quiet) {
  const std::string warning = Escaped(name) + ": warning: ";
  for (const std::string& what : text.warnings) PrintError(warning + what);
  if (quiet) return;
  for (const std::string& folder : text.other_folders)
    PrintError(warning + "it names files outside its folder; -allow_path " + Escaped(folder) + " allows reading them");
}

}  // namespace

OutputFile CheckScnOutput(const std::string& name, const std::string& scene) {
  if (LowerCase(fs::path(name).extension().string()) != ".scn")
    throw UsageError("-convert " + Quoted(name) + ": scenes are written as .scn, so the name must end in .scn");
  const std::string inputs[] = {scene};
  return CheckOutput(name, inputs);
}

std::string WriteSceneAsScn(const Scene& scene, const OutputFile& output, bool quiet) {
  const ScnText text = WriteScn(scene, Canonical(output.target));
  std::vector<OutputFile> meshes;
  for (const ScnText::Mesh& mesh : text.meshes)
    meshes.push_back(CheckMesh(output.target.parent_path() / mesh.name, mesh.text, scene.files));
  std::string messages;
  const auto write = [&](const OutputFile& file, const std::string& content) {
    WriteWhole(file, BytesOfText(content));
    messages += "wrote " + QuotedPath(file.name) + "\n";
  };
  for (std::size_t i = 0; i < meshes.size(); ++i) write(meshes[i], text.meshes[i].text);
  write(output, text.text);
  WarnOfText(text, output.name, quiet);
  return quiet ? std::string() : messages;
}

}  // namespace ray
