// Limits on the contents of files from untrusted sources, and on the cost of reading them. The
// limits are far above any real model, picture or project, and far below what overloads a computer.
// Most limits grow with the file's size, so that a small file cannot use much memory or time.
#pragma once

#include <QString>

namespace dipwright {

enum class Budget {
    FileBytes,  // size of one file
    NamedFiles, // number of other files that a model refers to
    Triangles,  // number of triangles of a model; repeated parts count again
    PolygonCorners,
    Nesting, // levels of nested parts in a model
    Materials,
    UnpackedBytes,  // size of all entries of an archive after unpacking
    Entries,        // number of entries of an archive
    DocumentBytes,  // size of project.json
    DocumentDepth,  // levels of nested values in any JSON file
    DocumentValues, // number of values in any JSON file
    OtherBytes,     // unpacked bytes of a project file's entries that the program does not use
    PictureSide,    // width or height of a picture, pixels
    // Pixels of all pictures of a model or project. A picture that is used twice counts twice; a
    // wide picture also counts twice.
    Pixels,
    Memory,       // bytes of memory that the reading process may use
    Milliseconds, // computing time until the file is read
    // Limits for CAD files only, because a small CAD file can describe a large model.
    Faces,
    CadTriangles,
    CadMemory,
    CadMilliseconds
};

// Returns the limit for files of `fileBytes` bytes in total.
qint64 budgetLimit(Budget budget, qint64 fileBytes = 0);

// Throws Error if `amount` exceeds the limit. The error names `where`.
void requireWithin(Budget budget, qint64 amount, const QString& where, qint64 fileBytes = 0);

// Returns only the message: which limit was exceeded and what to do.
QString sentenceOf(Budget budget, qint64 fileBytes = 0);

} // namespace dipwright
