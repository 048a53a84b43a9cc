// Whether sensors are worn in a way that a chain of segments can be made of.
#pragma once

#include <string>

#include "problems/observations.h"

namespace brachium {

// Every sensor's mounting is known (a sensor alone needs none) and no segment is missing between
// the first and the last of the arm. If not, `why` says what is missing and how to get it.
bool IsWholeChain(const Observations& observations, std::string* why);

}  // namespace brachium
