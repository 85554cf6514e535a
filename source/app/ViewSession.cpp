#include "source/app/ViewSession.h"

#include "source/view/contexts/Context.h"

namespace ray {

int View(const Options&, const ViewOutputs&, std::shared_ptr<const LoadedScene>) {
  throw ContextError("this build has nothing to draw with");
}

}  // namespace ray
