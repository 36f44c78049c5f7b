// Opening a file to read it: the one place for paths that a user or another file names.
#pragma once

#include <QFile>
#include <QString>

namespace dipwright {

// Opens the file for reading. Empty when done, else why not, in words that stand in a sentence.
// Only regular files are opened, links to them, and what the program brings along: a pipe or a
// device may never send anything, or never end, and is not waited for.
QString openToRead(QFile& file);

} // namespace dipwright
