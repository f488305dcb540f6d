#include "simulation/start/start_report.h"

namespace ribbon {

std::string_view word_for(StartKind kind) {
  switch (kind) {
    case StartKind::free:
      return "free";
    case StartKind::grown:
      return "grown";
    case StartKind::recovered:
      return "recovered";
  }
  return "";
}

}  // namespace ribbon
