#include "sheet/page/PaperMargins.h"

#include <algorithm>

namespace dipwright {
namespace {

// Returns the width, in mm, that the drawing loses at a margin of the paper. `half` is half the
// paper's size.
double lostEdge(double half, double margin, double scale) {
    return std::max(margin, half - (half - margin) * scale);
}

} // namespace

PrintCorrection printCorrection(const std::optional<PrinterProfile>& profile,
                                const PrinterColour* colour) {
    PrintCorrection correction;
    correction.colour = colour;
    if (profile) {
        correction.scaleX = profile->scaleX;
        correction.scaleY = profile->scaleY;
        correction.totalInk = profile->totalInk;
        correction.pdfTarget = profile->pdfTarget;
        correction.squarePixels = profile->squarePixels;
    }
    return correction;
}

QMarginsF larger(const QMarginsF& a, const QMarginsF& b) {
    return {std::max(a.left(), b.left()), std::max(a.top(), b.top()),
            std::max(a.right(), b.right()), std::max(a.bottom(), b.bottom())};
}

double widest(const QMarginsF& margins) {
    return std::max({margins.left(), margins.top(), margins.right(), margins.bottom()});
}

QMarginsF unreachable(const QMarginsF& ofPrinter, const std::optional<PrinterProfile>& profile) {
    if (!profile) {
        return ofPrinter;
    }
    const auto& m = profile->margins;
    return larger(ofPrinter, {m[0].value(), m[1].value(), m[2].value(), m[3].value()});
}

QMarginsF clippedEdges(QSizeF paper, const QMarginsF& margins, const PrintCorrection& correction) {
    const double x = paper.width() / 2;
    const double y = paper.height() / 2;
    return {lostEdge(x, margins.left(), correction.scaleX),
            lostEdge(y, margins.top(), correction.scaleY),
            lostEdge(x, margins.right(), correction.scaleX),
            lostEdge(y, margins.bottom(), correction.scaleY)};
}

Millimetres clearanceFor(QSizeF page, const QMarginsF& margins, const PrintCorrection& correction) {
    const double clear = Sheet().clearance.value();
    const QMarginsF kept = larger(margins, {clear, clear, clear, clear});
    return Millimetres(std::max(widest(clippedEdges(page, kept, correction)),
                                widest(clippedEdges(page.transposed(), kept, correction))));
}

} // namespace dipwright
