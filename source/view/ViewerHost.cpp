#include "source/view/ViewerHost.h"

#include <stdexcept>

namespace ray {

ViewerSettings ViewerHost::ChangeOption(const std::string& name, const std::string&) {
  throw std::invalid_argument("there is no option " + name);
}

}  // namespace ray
