// Independent pieces of work on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace brachium {

// Calls work(i) once for each i below `count`, in their order but several at a time. After an
// exception no further piece begins; of several the one of the least i is thrown. 0 threads: as many
// as the machine has.
void InParallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace brachium
