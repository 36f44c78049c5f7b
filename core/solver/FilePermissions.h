// Finds out who may change a file. System-dependent.
#pragma once

#include <QString>

namespace dipwright {

// Returns the file, or a folder above it, that other users can write to or replace; empty if there
// is none. This user and the system's administrator are not other users. A folder in which users
// may remove only their own files (such as the one for temporary files) counts as safe. A group
// with write permission counts as other users, unless it is the private group of this user or of
// root. A private group is the primary group, with the user's name and no other members. Always
// empty on Windows.
QString writableByOthers(const QString& path);

} // namespace dipwright
