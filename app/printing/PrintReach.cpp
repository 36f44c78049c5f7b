#include "printing/PrintReach.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "printing/PrintFile.h"
#include "sheet/page/CutContour.h"
#include "sheet/page/InkedPixels.h"
#include "sheet/page/SheetLayout.h"
#include "sheet/page/SheetRows.h"
#include "sheet/prepress/PrinterColour.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Printing)
};

// Returns the bounding box, in mm, of the page area that has ink from the film's plates.
QRectF paintedBox(const Sheet& sheet, InkedPlates plates) {
    if (sheet.rows && !sheet.pieces.empty()) { // the pieces' pictures are what is painted
        QRectF painted;
        for (const SheetPiece& piece : sheet.pieces) {
            painted |= piece.pictureOnPage();
        }
        return painted;
    }
    const QRect box = inkedBox(sheet, plates);
    const QSizeF film(sheet.filmWidth.value(), sheet.filmHeight.value());
    const QSizeF page = pageSize(sheet);
    const QPointF corner((page.width() - film.width()) / 2, (page.height() - film.height()) / 2);
    const QSize pixels = filmPixels(sheet);
    const double x = film.width() / pixels.width();
    const double y = film.height() / pixels.height();
    return box.isEmpty() ? QRectF()
                         : QRectF(corner + QPointF(box.x() * x, box.y() * y),
                                  QSizeF(box.width() * x, box.height() * y));
}

// If the page is rotated, its left edge is the paper's top edge.
QMarginsF lostOnPage(const Sheet& sheet, const QMarginsF& margins,
                     const PrintCorrection& correction) {
    const QSizeF page = pageSize(sheet);
    if (!correction.acrossPaper) {
        return clippedEdges(page, margins, correction);
    }
    const QMarginsF lost = clippedEdges(page.transposed(), margins, correction);
    return {lost.top(), lost.right(), lost.bottom(), lost.left()};
}

// Returns how much farther inside marks on the film stand on the second sheet than on the first, or
// than the film's corners if the first has none, mm.
double markShift(const Sheet& sheet, const Sheet& inside) {
    if (!sheet.settings.marks || !sheet.pieces.empty()) {
        return 0;
    }
    const QPointF corner(sheet.filmWidth.value() / 2, sheet.filmHeight.value() / 2);
    const std::optional<QPointF> after = marksOnFilm(inside);
    return after ? marksOnFilm(sheet).value_or(corner).x() - after->x() : 0;
}

} // namespace

Sheet withinReach(const Sheet& sheet, const QMarginsF& margins, const PrintCorrection& correction,
                  bool accept, const QString& where, QStringList& warnings) {
    constexpr double sharpness = 0.05; // mm
    Sheet inside = sheet;
    inside.clearance =
        std::max(sheet.clearance, clearanceFor(pageSize(sheet), margins, correction));
    if (const double moved = markShift(sheet, inside); moved > sharpness) {
        warnings << Text::tr("The registration marks are printed %1 mm farther inside than the "
                             "pins of traveller and cradle, because this printer needs wider "
                             "margins than the job's profile has. Before you use the pins, enter "
                             "these margins in the profile and run the job again")
                        .arg(numberText(moved, 1));
    }
    const QString covered = coveredPictureNote(inside);
    if (!covered.isEmpty() && coveredPictureNote(sheet).isEmpty()) { // else the verdict says it
        warnings << covered;
    }
    const QMarginsF lost = lostOnPage(sheet, margins, correction);
    const double lostWidth = std::round(widest(lost) * 100) / 100;
    const QRectF reach = QRectF({0, 0}, pageSize(sheet)).marginsRemoved(lost);
    const bool inks = correction.colour && correction.colour->isCmyk();
    const QRectF paper =
        QRectF({0, 0}, pageSize(sheet)).marginsRemoved(lostOnPage(sheet, {}, correction));
    const QRectF cut = inks ? cutContour(sheet, sheetLayout(sheet)).boundingRect() : QRectF();
    const auto liesIn = [](const QRectF& box, const QRectF& area) {
        return box.isEmpty() ||
               area.adjusted(-sharpness, -sharpness, sharpness, sharpness).contains(box);
    };
    if (!liesIn(cut, paper)) {
        const QString sentence = Text::tr("At the printer profile's scale, the cut contour reaches "
                                          "past the edge of the paper");
        if (!accept) {
            throw Error(Text::tr("%1; choose larger paper, or accept that a part of it is lost")
                            .arg(sentence),
                        where);
        }
        warnings << sentence;
    } else if (!liesIn(cut, reach)) { // not refused: a cutter may reach farther than the printer
        warnings << Text::tr("The printer does not reach the outer %1 mm of the paper, and a part "
                             "of the cut contour lies there; check that the cutter reaches it")
                        .arg(lostWidth);
    }
    const QRectF painted = paintedBox(sheet, inks ? InkedPlates::All : InkedPlates::Picture);
    if (liesIn(painted, reach)) {
        return inside;
    }
    const QString sentence =
        Text::tr("The printer does not reach the outer %1 mm of the paper, and the sheet has "
                 "colour there")
            .arg(lostWidth);
    if (!accept) {
        throw Error(
            Text::tr("%1; choose larger or borderless paper, or accept that this colour is lost")
                .arg(sentence),
            where);
    }
    warnings << sentence;
    return inside;
}

PackingFilm withinReach(PackingFilm film, const QMarginsF& ofPrinter,
                        const std::optional<PrinterProfile>& profile) {
    constexpr double stripClearance = 2; // mm between the ruler and the pieces
    const QMarginsF lost =
        clippedEdges(film.size, unreachable(ofPrinter, profile), printCorrection(profile, nullptr));
    film.edges = larger(film.edges, lost);
    if (!film.wholeSheets) { // whole sheets have their own rulers
        film.edges.setBottom(
            std::max(film.edges.bottom(), widest(lost) + rulerDepth + stripClearance));
    }
    return film;
}

} // namespace dipwright
