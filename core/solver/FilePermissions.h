// Who may change a file: the system's part.
#pragma once

#include <QString>

namespace dipwright {

// The file, or the folder above it, that others than this user and the system's administrator can
// write to, or could put another in the place of; empty where there is none. A folder in which each
// may remove only what is his own (such as that for temporary files) counts as safe for what lies
// in it. A group that may write counts as others unless it is the private one of this user or of
// root: its first, of its name, without other members. Nothing is known of it on Windows.
QString writableByOthers(const QString& path);

} // namespace dipwright
