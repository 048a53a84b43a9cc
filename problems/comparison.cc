#include "problems/comparison.h"

namespace brachium {

std::string NameOf(ComparedPair::Outcome outcome) {
  switch (outcome) {
    case ComparedPair::Outcome::kDone:
      return "done";
    case ComparedPair::Outcome::kRefused:
      return "refused";
    case ComparedPair::Outcome::kFailed:
      return "failed";
    case ComparedPair::Outcome::kUnreadable:
      break;
  }
  return "unreadable";
}

}  // namespace brachium
