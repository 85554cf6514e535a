#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace ray {

/// An output file, checked to be writable before the work that fills it begins.
struct OutputFile {
  std::string name;              // as typed
  std::filesystem::path target;  // the same, or the target if it is a link
  bool is_link = false;
  bool is_standard_output = false;
};

/// Checks that `name` can be written: it is not a folder, a device or one of `inputs`, and its folder exists and
/// accepts new files. Removes temporary files that killed processes left for the same target. Throws OutputError.
OutputFile CheckOutput(const std::string& name, std::span<const std::string> inputs);

/// Throws OutputError if the output is one of the files.
void RefuseInputs(const OutputFile& output, std::span<const std::string> inputs);

/// Returns true if a file with that name exists, as far as can be determined.
bool IsThere(const std::filesystem::path& file);

/// Returns "out.depth.png" for "out.png" and "depth".
std::string NameBeside(const std::string& name, const std::string& word);

/// Writes the file completely or not at all. If that fails, saves the bytes in the system's temporary folder instead,
/// and throws an OutputError that states where.
void WriteWhole(const OutputFile& output, std::span<const unsigned char> bytes);

/// Writes to standard output. Ignores readers that have closed their end; any other failure is an OutputError.
void WriteStandardOutput(const std::string& text);

}  // namespace ray
