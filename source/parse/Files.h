#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace ray {

/// An error about a file named by a scene; the reader adds the position of the name.
struct FileError {
  std::string message, hint;
  std::string similar{};  // the name of an existing file that resembles the missing one; may be empty
};

/// A file that exists and may be read.
struct FoundFile {
  std::string shown;      // the name in messages: relative to the file that names it
  std::string canonical;  // absolute and without links: the same for every name of a file
};

/// The name of standard input in messages and in lists of a scene's files. On the command line it is "-".
inline constexpr const char* standard_input_name = "<stdin>";
/// Returns all of standard input; read on the first call and kept, since it can be read only once. Throws FileError.
const std::string& StandardInput();

/// The files of one scene. A scene may come from an untrusted source, so it can read only regular files below its own
/// folder, the current folder and the folders that the user allows.
class Files {
 public:
  /// The maximum length of a file.
  static constexpr std::size_t max_bytes = std::size_t{1} << 30;

  /// Opens the top scene wherever it is, since the user named it. "-" is standard input, treated as a file in the
  /// current folder. Throws FileError if a folder to be allowed is not a folder.
  Files(const std::string& top_scene, const std::vector<std::string>& allowed_folders);

  const std::string& TopName() const { return top_; }
  bool IsStandardInput() const { return top_ == standard_input_name; }
  /// Returns the top scene; throws FileError.
  FoundFile Top() const;
  /// Searches the folder of the file that names it, then the current folder. If the path is that of another folder or
  /// computer, such as "../x.png", "/home/me/x.png" or "C:\x.png", and does not exist, the file is searched by its name
  /// in each of these folders, in their textures/, and in the same two places above them. Throws FileError, with the
  /// name of a similar file if there is one.
  FoundFile Find(const std::string& name, const std::string& named_in) const;
  /// Searches these folders in order; "" is the current one. Throws FileError.
  FoundFile FindIn(std::span<const std::string> folders, const std::string& name) const;
  /// Returns warnings about files that were found elsewhere than their paths state; one per path.
  const std::set<std::string>& Remarks() const { return remarks_; }
  /// Returns the whole file. Throws FileError, also if a link or another kind of file has replaced it since Find.
  std::string Read(const FoundFile& file) const;

 private:
  /// Throws FileError, but stores it in `denied` instead if the system denies access to the folder.
  std::optional<FoundFile> FindAt(const std::string& folder, const std::string& name,
                                  std::optional<FileError>& denied) const;
  std::optional<FoundFile> FindElsewhere(std::span<const std::string> folders, const std::string& name) const;
  bool IsAllowed(const std::string& canonical) const;
  std::string SimilarIn(std::span<const std::string> folders, const std::string& name) const;

  std::string top_;
  std::vector<std::string> roots_;  // canonical
  mutable std::set<std::string> remarks_;
};

/// Returns the contents of a regular file found by Files. Throws FileError, also if a link or another kind of file has
/// replaced it since. Only this function, of ReadFile.cpp, and StandardInput read input; the page in a browser has its
/// own version.
std::string ReadFile(const FoundFile& file);

}  // namespace ray
