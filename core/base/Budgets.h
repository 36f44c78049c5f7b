// How much a file from elsewhere may hold or ask for: the one table of it, far above any real
// model, picture or project and far below what hurts. Most budgets grow with the file, so that a
// small one cannot ask for much.
#pragma once

#include <QString>

namespace dipwright {

enum class Budget {
    FileBytes,  // of one file
    NamedFiles, // how many others a model names
    Triangles,  // of a model as it is read, those of copies too
    PolygonCorners,
    Nesting, // parts in parts
    Materials,
    UnpackedBytes,  // of an archive
    Entries,        // of an archive
    DocumentBytes,  // of project.json
    DocumentDepth,  // values in values, of any JSON
    DocumentValues, // of any JSON
    OtherBytes,     // of all entries of a project that are not its own, unpacked
    PictureSide,    // pixels
    Pixels,         // of all pictures of a model or project, as often as named, wide ones twice
    Memory,         // bytes, of the process that reads
    Milliseconds    // of computing, until it has read
};

// The most of it for files of these many bytes together.
qint64 mostOf(Budget budget, qint64 fileBytes = 0);

// Throws Error with the budget's sentence about `where` where `amount` is more than that.
void requireWithin(Budget budget, qint64 amount, const QString& where, qint64 fileBytes = 0);

// The sentence alone, for what ran out of it: what and what to do.
QString sentenceOf(Budget budget, qint64 fileBytes = 0);

} // namespace dipwright
