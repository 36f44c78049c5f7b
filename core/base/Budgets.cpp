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
constexpr double slowDown = 3; // by a sanitizer, of reading: libraries are not compiled with it
#else
constexpr double slowDown = 1;
#endif

// At most `always` and `perByte` for each byte of the file, and never more than `ever`.
struct Row {
    Budget budget;
    double always, perByte, ever;
    double unit; // in which the sentence says it
    const char* sentence;
};

constexpr Row table[] = {
    {Budget::FileBytes, 4 * gibi, notFromTheFile, 4 * gibi, mebi,
     QT_TRANSLATE_NOOP("dipwright::Budgets", "The file is larger than %1 MB; reduce it")},
    {Budget::NamedFiles, 1000, notFromTheFile, 1000, 1,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The model names more than %1 other files; reduce it")},
    // The shortest of all formats has two bytes a triangle.
    {Budget::Triangles, 1e6, 1, 50e6, 1e6,
     QT_TRANSLATE_NOOP(
         "dipwright::Budgets",
         "The model has more than %1 million triangles, too many for a file of its size "
         "or for any computer; reduce it")},
    // assimp's time to cut a polygon grows with their square.
    {Budget::PolygonCorners, 4096, notFromTheFile, 4096, 1,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "A face of the model has more than %1 corners; cut it into triangles in a "
                       "modelling program")},
    {Budget::Nesting, 256, notFromTheFile, 256, 1,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The model cannot be read: its parts hold one another more "
                       "than %1 deep; join them in a modelling program")},
    {Budget::Materials, 65536, notFromTheFile, 65536, 1,
     QT_TRANSLATE_NOOP("dipwright::Budgets", "The model has more than %1 materials; reduce them")},
    // Meshes pack to a tenth at best; pictures not at all.
    {Budget::UnpackedBytes, 32 * mebi, 20, 4 * gibi, mebi,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The file would unpack to more than %1 MB, more than any of its size needs, "
                       "and is not opened; ask whoever made it for another")},
    {Budget::Entries, 10'000, notFromTheFile, 10'000, 1,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The file holds more entries than %1 and is not opened; "
                       "ask whoever made it for another")},
    {Budget::DocumentBytes, 16 * mebi, notFromTheFile, 16 * mebi, mebi,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "project.json is larger than %1 MB and is not read; ask "
                       "whoever made the project for another")},
    {Budget::DocumentDepth, 32, notFromTheFile, 32, 1,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The file's values hold one another more than %1 deep and it is not read; "
                       "ask whoever made it for another")},
    {Budget::DocumentValues, 1e6, notFromTheFile, 1e6, 1e6,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The file holds more than %1 million values and is not read; ask whoever "
                       "made it for another")},
    {Budget::OtherBytes, 256 * mebi, notFromTheFile, 256 * mebi, mebi,
     QT_TRANSLATE_NOOP(
         "dipwright::Budgets",
         "The project holds more than %1 MB that is not its own; take that out with an "
         "archive program")},
    {Budget::PictureSide, 32768, notFromTheFile, 32768, 1,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The texture has more than %1 pixels a side; make it smaller")},
    // Always one of 8192 × 8192 pixels; more only where there is detail in it.
    {Budget::Pixels, 8192.0 * 8192, 10, 16384.0 * 16384, 1e6,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "The pictures have more than %1 million pixels together, too many for files "
                       "of their size or for any sheet; make them smaller")},
    {Budget::Memory, 512 * mebi, 40, 64 * gibi, mebi,
     QT_TRANSLATE_NOOP(
         "dipwright::Budgets",
         "Reading the file takes more than %1 MB of memory, more than any of its size "
         "needs; reduce it or save it anew")},
    {Budget::Milliseconds, 2e3 * slowDown, 5e-4 * slowDown, 1e6 * slowDown, 1e3,
     QT_TRANSLATE_NOOP("dipwright::Budgets",
                       "Reading the file takes more than %1 seconds, more than any of its size "
                       "needs; reduce it or save it anew")},
};

const Row& row(Budget budget) {
    return *std::find_if(std::begin(table), std::end(table),
                         [budget](const Row& entry) { return entry.budget == budget; });
}

} // namespace

qint64 mostOf(Budget budget, qint64 fileBytes) {
    const Row& entry = row(budget);
    return qint64(std::min(entry.always + entry.perByte * double(fileBytes), entry.ever));
}

void requireWithin(Budget budget, qint64 amount, const QString& where, qint64 fileBytes) {
    if (amount > mostOf(budget, fileBytes)) {
        throw Error(sentenceOf(budget, fileBytes), where);
    }
}

QString sentenceOf(Budget budget, qint64 fileBytes) {
    const Row& entry = row(budget);
    const double amount = double(mostOf(budget, fileBytes)) / entry.unit;
    return QCoreApplication::translate(context, entry.sentence)
        .arg(amount, 0, amount < 10 ? 'g' : 'f', amount < 10 ? 2 : 0);
}

} // namespace dipwright
