#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace ray {

/// A place for a file, found fit to be written before the work that fills it begins.
struct OutputFile {
  std::string name;              // as typed
  std::filesystem::path target;  // the same, or what it leads to if it is a link
  bool is_link = false;
  bool is_standard_output = false;
};

/// Checks that `name` can be written: it is no folder, no device and none of `inputs`, its folder exists and takes new
/// files. Removes temporaries that killed processes left for the same target. Throws OutputError.
OutputFile CheckOutput(const std::string& name, std::span<const std::string> inputs);

/// Throws OutputError when the output is one of the files.
void RefuseInputs(const OutputFile& output, std::span<const std::string> inputs);

/// Whether there is something of that name, as far as can be told.
bool IsThere(const std::filesystem::path& file);

/// "out.depth.png" for "out.png" and "depth".
std::string NameBeside(const std::string& name, const std::string& word);

/// Writes the file whole or not at all. If that fails, the bytes are kept under the system's temporary folder instead,
/// and the OutputError says where.
void WriteWhole(const OutputFile& output, std::span<const unsigned char> bytes);

/// Writes to standard output. A reader that has closed its end has seen enough; any other failure is an OutputError.
void WriteStandardOutput(const std::string& text);

}  // namespace ray
