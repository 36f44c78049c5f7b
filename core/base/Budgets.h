// Limits on what a file from elsewhere may hold or ask for. They are far above any real model,
// picture or project, and far below what overloads a computer. Most limits grow with the file's
// size, so that a small file cannot ask for much.
#pragma once

#include <QString>

namespace dipwright {

enum class Budget {
    FileBytes,  // size of one file
    NamedFiles, // other files that a model names
    Triangles,  // of a model as it is read, copies included
    PolygonCorners,
    Nesting, // how deep parts are nested
    Materials,
    UnpackedBytes,  // of an archive
    Entries,        // of an archive
    DocumentBytes,  // of project.json
    DocumentDepth,  // how deep the values of any JSON file are nested
    DocumentValues, // number of values in any JSON file
    OtherBytes,     // unpacked bytes of all entries of a project file that the program does not use
    PictureSide,    // pixels
    // of all pictures of a model or project; repeated use counts again, wide pictures count twice
    Pixels,
    Memory,      // bytes that the reading process may use
    Milliseconds // computing time until the file is read
};

// Returns the limit for files with this total size.
qint64 budgetLimit(Budget budget, qint64 fileBytes = 0);

// Throws Error with the budget's message about `where` if `amount` exceeds the limit.
void requireWithin(Budget budget, qint64 amount, const QString& where, qint64 fileBytes = 0);

// Returns only the message: which limit was exceeded and what to do.
QString sentenceOf(Budget budget, qint64 fileBytes = 0);

} // namespace dipwright
