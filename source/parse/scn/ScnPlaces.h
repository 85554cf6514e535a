#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "source/parse/Text.h"

namespace ray {

/// Where the statements of a .scn scene stand in its files, for programs that edit these. Filled in by the reader where
/// ParseOptions::places asks for it.
struct ScnPlaces {
  static constexpr std::uint32_t nowhere = ~std::uint32_t{0};

  struct File {
    std::string canonical;             // its absolute path without links, or standard_input_name
    std::shared_ptr<const Text> text;  // what was read, under the name that messages use
  };
  struct Statement {
    std::uint32_t file = 0;   // index into `files`, which is also that into Scene::files
    std::uint32_t begin = 0;  // offset of the command's first byte in the file; files are at most 1 GiB long
  };

  std::vector<File> files;
  std::vector<Statement> statements;     // in the order of reading: those of a file included twice are there twice
  std::vector<std::uint32_t> materials;  // the statement that made each of Scene::materials, or nowhere
  std::vector<std::uint32_t> lights;     // likewise of Scene::lights; shorter where the lights are the default ones
};

/// One word of a statement.
struct ScnWord {
  std::string text;       // as it stands in the file: quotes and dollar signs included
  std::size_t begin = 0;  // offset of its first byte in the file
  std::size_t End() const { return begin + text.size(); }
};

/// The words of a statement, the command first; comments are left out.
std::vector<ScnWord> WordsOf(const ScnPlaces& places, std::uint32_t statement);

/// The first statement that begins at this offset of the file; nothing if none does.
std::optional<std::uint32_t> StatementAt(const ScnPlaces& places, std::uint32_t file, std::size_t begin);

/// The statement that a node, or a message, of the scene points to; nothing for a location without a line.
std::optional<std::uint32_t> StatementAt(const ScnPlaces& places, const Location& location);

/// The location of an offset of a file, as LocationOf has it: lines and characters counted from 1.
Location LocationAt(const ScnPlaces& places, std::uint32_t file, std::size_t offset);

}  // namespace ray
