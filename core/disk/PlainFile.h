// Opens files for reading. Every path that a user or another file names is opened here.
#pragma once

#include <QFile>
#include <QString>

namespace dipwright {

// Opens the file for reading. Returns an empty string on success, else the reason, worded as part
// of a sentence. Opens only regular files, links to them, and files built into the program. Never
// opens pipes or devices, because they may never send anything, or never end.
QString openToRead(QFile& file);

} // namespace dipwright
