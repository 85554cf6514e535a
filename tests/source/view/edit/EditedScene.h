#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "source/inspect/LoadedScene.h"
#include "source/view/edit/ScnEdits.h"
#include "tests/source/parse/Folder.h"

namespace ray {

/// A .scn file in a folder of its own, and what editing makes of it.
class EditedScene {
 public:
  explicit EditedScene(const std::string& text) {
    Write("scene.scn", text);
    Read();
  }

  void Write(const std::string& name, const std::string& text) const { folder_.Write(name, text); }
  void Read() { loaded_ = std::make_unique<const LoadedScene>(File(), options_, AcceleratorSettings{}); }
  std::string File() const { return folder_ / "scene.scn"; }
  const ScnPlaces& Places() const { return loaded_->places; }
  const Scene& scene() const { return loaded_->parsed.scene; }

  /// The number of the n-th statement of a command, from 0.
  std::uint32_t Statement(const std::string& command, int n = 0) const {
    for (std::uint32_t i = 0; i < Places().statements.size(); ++i)
      if (CommandOf(Places(), i) == command && n-- == 0) return i;
    throw std::runtime_error("no statement " + command);
  }
  ScnField Field(std::uint32_t statement, const std::string& name) const {
    for (const ScnField& field : FieldsOf(Places(), statement))
      if (field.name == name) return field;
    throw std::runtime_error("no field " + name);
  }
  /// The text of a file after the edits, with which the scene is read again.
  std::string After(const TextEdits& edits, const std::string& file = "scene.scn") {
    EditedFiles files;
    for (const ScnPlaces::File& f : Places().files) files[f.canonical] = f.text->bytes;
    options_.edited = std::make_shared<const EditedFiles>(Edited(files, edits));
    Read();
    return options_.edited->at(folder_ / file);
  }

 private:
  Folder folder_;
  ParseOptions options_;
  std::unique_ptr<const LoadedScene> loaded_;
};

}  // namespace ray
