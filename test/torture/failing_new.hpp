// The program's operator new, which can be told to fail once.
#pragma once

namespace mixed_palletizing::torture {

/// Allocations by operator new so far, of all threads.
long allocations();

/// The `count`-th allocation from now on, of whichever thread, throws std::bad_alloc (once).
void failAllocation(long count);

/// Nothing fails any more. True when one has failed since failAllocation().
bool stopFailing();

}  // namespace mixed_palletizing::torture
