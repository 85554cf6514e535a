#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace ray {

/// The file that was probably meant by a name that no file in `folder` has: in other letter case, with backslashes for
/// slashes, with a slip or two in a part of its path, or with another extension. Empty if there is none.
///   unlike     an extension, with its dot, that a file of another extension does not mean: that of the file which
///              names it, beside which a file of the same stem often lies
///   may_list   whether a folder, which exists, may be looked through
std::string SimilarFile(const std::filesystem::path& folder, const std::string& name, const std::string& unlike,
                        const std::function<bool(const std::filesystem::path&)>& may_list);

}  // namespace ray
