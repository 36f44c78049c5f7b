#include "base/Budgets.h"

#include "base/Error.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

namespace dipwright {
namespace {

constexpr char context[] = "dipwright::Budgets";
constexpr double mebi = 1 << 20, gibi = 1 << 30;
constexpr double notFromTheFile = 0;
#if defined(DIPWRIGHT_SANITIZED)
// factor by which a sanitizer slows reading; libraries are built without it
constexpr double sanitizerFactor = 3;
#else
constexpr double sanitizerFactor = 1;
#endif

// The limit is `always` plus `perByte` for each byte of the file, but at most `ever`.
struct Row {
    Budget budget;
    double always, perByte, ever;
    double unit; // the unit of the number in the message
    const char* sentence;
};

constexpr Row table[] = {
    {Budget::FileBytes, 4 * gibi, notFromTheFile, 4 * gibi, mebi,
     QT_TRANSLATE_NOOP("dipwright::Budgets", "The file is larger than %1 MB; make it smaller")},
    {Budget::NamedFiles, 1000, notFromTheFile, 1000, 1,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The model refers to more than %1 other files; reduce their number")},
    // The most compact format needs two bytes for each triangle.
    {Budget::Triangles, 1e6, 1, 50e6, 1e6,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The model has more than %1 million triangles, which is the limit for a "
                       "file of its size; reduce their number")},
    // assimp's time to triangulate a polygon grows with the square of its corners.
    {Budget::PolygonCorners, 4096, notFromTheFile, 4096, 1,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "A face of the model has more than %1 corners; cut it into triangles in a "
                       "modelling program")},
    {Budget::Nesting, 256, notFromTheFile, 256, 1,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The model cannot be read: its objects are nested more than %1 levels deep; "
                       "merge them in a modelling program")},
    {Budget::Materials, 65536, notFromTheFile, 65536, 1,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The model has more than %1 materials; reduce their number")},
    // Compression reduces meshes to 10 % of their size at best, and pictures hardly at all.
    {Budget::UnpackedBytes, 32 * mebi, 20, 4 * gibi, mebi,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The file is not opened, because it would take more than %1 MB after "
                       "unpacking, far too much for its size; ask its author for another file")},
    {Budget::Entries, 10'000, notFromTheFile, 10'000, 1,
     QT_TRANSLATE_NOOP("dipwright::Budgets", "The file is not opened, because it contains more "
                                             "than %1 entries; ask its author for another file")},
    {Budget::DocumentBytes, 16 * mebi, notFromTheFile, 16 * mebi, mebi,
     QT_TRANSLATE_NOOP("dipwright::Budgets", "project.json is larger than %1 MB and is not read; "
                                             "ask the project's author for another file")},
    {Budget::DocumentDepth, 32, notFromTheFile, 32, 1,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The file is not read, because its values are nested more than %1 levels "
                       "deep; ask its author for another file")},
    {Budget::DocumentValues, 1e6, notFromTheFile, 1e6, 1e6,
     QT_TRANSLATE_NOOP("dipwright::Budgets", "The file is not read, because it contains more than "
                                             "%1 million values; ask its author for another file")},
    {Budget::OtherBytes, 256 * mebi, notFromTheFile, 256 * mebi, mebi,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The project contains more than %1 MB of files that do not belong to it; "
                       "remove them with an archive program")},
    {Budget::PictureSide, 32768, notFromTheFile, 32768, 1,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The picture is more than %1 pixels wide or high; make it smaller")},
    // Any file may hold 8192 × 8192 pixels. More pixels are allowed only in larger files.
    {Budget::Pixels, 8192.0 * 8192, 10, 16384.0 * 16384, 1e6,
     QT_TRANSLATE_NOOP(
         "dipwright::Budgets",
         "The pictures have more than %1 million pixels in total, too many for a file "
         "of this size; reduce the pictures in width and height")},
    {Budget::Memory, 512 * mebi, 40, 64 * gibi, mebi,
     QT_TRANSLATE_NOOP(
         "dipwright::Budgets",
         "Reading the file takes more than %1 MB of memory, far too much for its size; make the "
         "file smaller, or save it again in the program that created it")},
    // A picture with the most pixels for its size may take 5 s, if its colours are converted.
    {Budget::Milliseconds, 5e3 * sanitizerFactor, 5e-4 * sanitizerFactor, 1e6 * sanitizerFactor,
     1e3,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "Reading the file takes more than %1 seconds, far too long for its size; "
                       "make the file smaller, or save it again in the program that created it")},
    {Budget::Faces, 65'000, notFromTheFile, 65'000, 1,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The CAD model has more than %1 faces; save only the part that is dipped, "
                       "without its inner parts")},
    {Budget::CadTriangles, 5e6, notFromTheFile, 5e6, 1e6,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The CAD model would have more than %1 million triangles; choose a larger "
                       "tolerance for its triangles")},
    {Budget::CadMemory, 1 * gibi, 200, 64 * gibi, mebi,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "Reading the CAD file takes more than %1 MB of memory; choose a larger "
                       "tolerance for its triangles, or save only the part that is dipped")},
    {Budget::CadMilliseconds, 20e3 * sanitizerFactor, 1e-2 * sanitizerFactor, 1e6 * sanitizerFactor,
     1e3,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "Reading the CAD file takes more than %1 seconds; choose a larger tolerance "
                       "for its triangles, or save only the part that is dipped")},
};

const Row& row(Budget budget) {
    return *std::find_if(std::begin(table), std::end(table),
                         [budget](const Row& entry) { return entry.budget == budget; });
}

} // namespace

qint64 budgetLimit(Budget budget, qint64 fileBytes) {
    const Row& entry = row(budget);
    return qint64(std::min(entry.always + entry.perByte * double(fileBytes), entry.ever));
}

void requireWithin(Budget budget, qint64 amount, const QString& where, qint64 fileBytes) {
    if (amount > budgetLimit(budget, fileBytes)) {
        throw Error(sentenceOf(budget, fileBytes), where);
    }
}

QString sentenceOf(Budget budget, qint64 fileBytes) {
    const Row& entry = row(budget);
    const double amount = double(budgetLimit(budget, fileBytes)) / entry.unit;
    return QCoreApplication::translate(context, entry.sentence)
        .arg(amount, 0, amount < 10 ? 'g' : 'f', amount < 10 ? 2 : 0);
}

} // namespace dipwright
