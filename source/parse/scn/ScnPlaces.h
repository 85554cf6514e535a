#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "source/parse/Text.h"

namespace ray {

/// The positions of the statements of a .scn scene in its files, for programs that edit these. Filled in by the reader
/// if ParseOptions::places is set.
struct ScnPlaces {
  static constexpr std::uint32_t nowhere = ~std::uint32_t{0};

  struct File {
    std::string canonical;             // its absolute path without links, or standard_input_name
    std::shared_ptr<const Text> text;  // the text read, under its name in messages
  };
  struct Statement {
    std::uint32_t file = 0;   // index into `files`, equal to that into Scene::files
    std::uint32_t begin = 0;  // offset of the command's first byte in the file; files are at most 1 GiB long
  };

  std::vector<File> files;
  std::vector<Statement> statements;     // in the order of reading: those of a file included twice occur twice
  std::vector<std::uint32_t> materials;  // the statement that made each of Scene::materials, or nowhere
  std::vector<std::uint32_t> lights;     // likewise for Scene::lights; shorter if the lights are the default ones
};

/// One word of a statement.
struct ScnWord {
  std::string text;       // as in the file, including quotes and dollar signs
  std::size_t begin = 0;  // offset of its first byte in the file
  std::size_t End() const { return begin + text.size(); }
};

/// Returns the words of a statement, the command first, without comments.
std::vector<ScnWord> WordsOf(const ScnPlaces& places, std::uint32_t statement);

/// Returns the first statement that begins at this offset of the file, or std::nullopt.
std::optional<std::uint32_t> StatementAt(const ScnPlaces& places, std::uint32_t file, std::size_t begin);

/// Returns the statement that a node, or a message, of the scene refers to; std::nullopt for a location without a line.
std::optional<std::uint32_t> StatementAt(const ScnPlaces& places, const Location& location);

/// Returns the location of an offset of a file, with lines and characters counted from 1 as by LocationOf.
Location LocationAt(const ScnPlaces& places, std::uint32_t file, std::size_t offset);

}  // namespace ray
