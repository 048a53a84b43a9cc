// Contacts that cannot be what they are said to be.
#pragma once

#include "io/findings.h"
#include "problems/observations.h"

namespace brachium {

// Warns of a contact with a single instant, which tells nothing of the arm, and of one in whose
// instants the touching segment turns so fast that its point cannot stay where it is.
void CheckContacts(const Observations& observations, Findings* findings);

}  // namespace brachium
