#include "pipeline/SheetMemory.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "base/PhysicalMemory.h"
#include "geometry/TriangleMesh.h"
#include "model/TexturedMesh.h"
#include "project/Project.h"
#include "sheet/page/Sheet.h"
#include "texture/InkAppearance.h"

#include <QCoreApplication>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

// Measured peak memory per printed pixel (docs/speed.md, "Memory").
constexpr double bytesOfSheet = 10.5; // for each immersion
constexpr double bytesOfPlate = 8;    // for each further plate of an immersion
// Bleed and film that is pushed together print more than the body's surface.
constexpr double surfaceMargin = 1.5;
constexpr double gigabyte = 1e9;
constexpr double noteFrom = 1 * gigabyte; // from this size on, the user gets a note

QString gigabytes(double bytes) {
    return numberText(bytes / gigabyte, 1);
}

// Returns the number of pixels of one film that are printed, at most.
double printedPixels(const Project& project, Printed printed) {
    const QSize pixels =
        sheetPixels(project.film.width, project.film.height, project.sheet.resolution);
    const double whole = double(pixels.width()) * double(pixels.height());
    if (printed == Printed::WholeFilm || !project.model) {
        return whole;
    }
    const double perMillimetre = pixelsPerMillimetre(project.sheet.resolution);
    return std::min(whole, surfaceMargin * surfaceArea(project.model->mesh) * perMillimetre *
                               perMillimetre);
}

} // namespace

double sheetMemory(const Project& project, Printed printed) {
    const auto plates = double(project.artwork.spots().size()) +
                        (project.sheet.white == WhiteLayer::None ? 0 : 1) +
                        (project.model && !inkSpaceOf(*project.model).isEmpty() ? 2 : 0);
    return printedPixels(project, printed) * double(project.immersions.size()) *
           (bytesOfSheet + bytesOfPlate * plates);
}

QString memoryNote(const Project& project, Printed printed) {
    const double bytes = sheetMemory(project, printed);
    return bytes < noteFrom ? QString()
                            : Text::tr("The run needs about %1 GB of memory for the sheets")
                                  .arg(gigabytes(bytes));
}

void checkMemory(const Project& project, Printed printed) {
    const double bytes = sheetMemory(project, printed);
    const auto there = double(physicalMemory());
    if (there > 0 && bytes > there) {
        throw Error(Text::tr("The sheets need about %1 GB of memory, but this computer has %2 GB; "
                             "choose a lower resolution or a smaller film")
                        .arg(gigabytes(bytes), gigabytes(there)),
                    QStringLiteral("sheet.dpi"));
    }
}

} // namespace dipwright
