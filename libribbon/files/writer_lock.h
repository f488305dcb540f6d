// Who may write to a file.
#pragma once

#include "files/descriptor.h"

namespace ribbon {

// Locks the whole open file for one writer, for as long as it stays open: the lock ends with the
// process, however that ends. False where another writer holds it. A file system without locks
// lets everybody write.
bool lock_for_writing(const FileDescriptor& file);

// Does somebody else hold that lock? Asks without taking it.
bool is_locked_for_writing(const FileDescriptor& file);

}  // namespace ribbon
