#include "pipeline/SheetMemory.h"

#include "base/Error.h"
#include "base/PhysicalMemory.h"
#include "project/Project.h"
#include "sheet/page/Sheet.h"

#include <QCoreApplication>
#include <QLocale>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

// Measured peak memory per pixel of the film's picture (docs/speed.md, "Memory").
constexpr double bytesOfPixel = 8;    // once per job
constexpr double bytesOfSheet = 10.5; // for each immersion
constexpr double bytesOfPlate = 8;    // for each further plate of an immersion
constexpr double gigabyte = 1e9;
constexpr double noteFrom = 1 * gigabyte; // from this size on, the user gets a note

QString gigabytes(double bytes) {
    return QLocale().toString(bytes / gigabyte, 'f', 1);
}

} // namespace

double sheetMemory(const Project& project) {
    const QSize pixels =
        sheetPixels(project.film.width, project.film.height, project.sheet.resolution);
    const auto plates =
        double(project.artwork.spots().size()) + (project.sheet.white == WhiteLayer::None ? 0 : 1);
    return double(pixels.width()) * double(pixels.height()) *
           (bytesOfPixel +
            double(project.immersions.size()) * (bytesOfSheet + bytesOfPlate * plates));
}

QString memoryNote(const Project& project) {
    const double bytes = sheetMemory(project);
    return bytes < noteFrom ? QString()
                            : Text::tr("The run needs about %1 GB of memory for the sheets")
                                  .arg(gigabytes(bytes));
}

void checkMemory(const Project& project) {
    const double bytes = sheetMemory(project);
    const auto there = double(physicalMemory());
    if (there > 0 && bytes > there) {
        throw Error(Text::tr("The sheets need about %1 GB of memory, but this computer has %2 GB; "
                             "choose a lower resolution or a smaller film")
                        .arg(gigabytes(bytes), gigabytes(there)),
                    QStringLiteral("sheet.dpi"));
    }
}

} // namespace dipwright
