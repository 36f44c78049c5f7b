#include "sheet/page/SheetLayout.h"

#include "base/Error.h"
#include "sheet/page/InkedPixels.h"
#include "sheet/page/PrintableText.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPageSize>
#include <QTransform>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Sheet)
};

constexpr double stripClearance = 2;  // mm between two strips or marks
constexpr double jobLineMargin = 0.5; // mm above and below the text
constexpr double leastType = 1.2;     // mm; smaller text cannot be read
constexpr int longestName = 40;       // longest name on the job line, in letters

QSizeF paperSize(const SheetSettings& settings, QSizeF film) {
    const QString& paper = settings.paper;
    if (paper == u"film") {
        return film;
    }
    if (paper == u"custom") {
        return {settings.customWidth.value(), settings.customHeight.value()};
    }
    const QPageSize::PageSizeId id = paper == u"A4"       ? QPageSize::A4
                                     : paper == u"A3"     ? QPageSize::A3
                                     : paper == u"Letter" ? QPageSize::Letter
                                                          : QPageSize::Custom;
    if (id == QPageSize::Custom) {
        throw Error(
            Text::tr("Unknown paper \"%1\"; choose film, A4, A3, Letter or custom").arg(paper),
            QStringLiteral("sheet.paper"));
    }
    const QSizeF portrait = QPageSize::size(id, QPageSize::Millimeter);
    return settings.landscape ? portrait.transposed() : portrait;
}

// Computes which share of an area of the page gets ink from the film's plates. Keeps a reference to
// the sheet.
class Paint {
public:
    Paint(const Sheet& sheet, const QRectF& film) : sheet_(sheet), film_(film) {}

    double share(const QRectF& box) const { return inkedShare(sheet_, film_, box); }

private:
    const Sheet& sheet_;
    QRectF film_;
};

// Finds places along the page's edges for strips that overlap neither each other nor ink.
class Places {
public:
    Places(const SheetLayout& layout, double clearance, const Paint& paint)
        : page_(layout.page), clearance_(clearance), paint_(paint) {
        for (const SheetMark& mark : layout.marks) {
            taken_.push_back(mark.box());
        }
        for (const SheetPiece& piece : layout.pieces) {
            taken_.push_back(piece.box());
        }
    }

    double longest() const { return std::max(page_.width(), page_.height()) - 2 * clearance_; }

    // Takes the place with the least ink, and only one whose share of ink is at most `mostInk`.
    // `edges` lists the edges by preference: 0 top, 1 right, 2 bottom, 3 left.
    std::optional<SheetStrip> take(QSizeF size, const std::array<int, 4>& edges, double mostInk) {
        std::optional<SheetStrip> best;
        double bestShare = std::nextafter(mostInk, 2);
        for (int edge : edges) {
            for (double along : {0.5, 0.0, 1.0, 0.25, 0.75}) {
                SheetStrip strip = stripAt(edge, along, size);
                if (!isFree(strip.box())) {
                    continue;
                }
                const double share = paint_.share(strip.box());
                if (share < bestShare) {
                    strip.overPaint = share > 0;
                    best = strip;
                    bestShare = share;
                }
            }
        }
        if (best) {
            taken_.push_back(best->box());
        }
        return best;
    }

private:
    bool isFree(const QRectF& box) const {
        const QRectF page(QPointF(0, 0), page_);
        const double c = clearance_ - 1e-6;
        const QRectF wide =
            box.adjusted(-stripClearance, -stripClearance, stripClearance, stripClearance);
        return page.adjusted(c, c, -c, -c).contains(box) &&
               std::none_of(taken_.begin(), taken_.end(),
                            [&](const QRectF& other) { return wide.intersects(other); });
    }

    SheetStrip stripAt(int edge, double along, QSizeF size) const {
        const double w = page_.width();
        const double h = page_.height();
        const double reserve = clearance_ + 2 * markReach + stripClearance;
        const bool upright = edge % 2 == 1;
        const double room = (upright ? h : w) - size.width() - 2 * reserve;
        const double start = room < 0 ? reserve + room / 2 : reserve + room * along;
        switch (edge) {
        case 0:
            return {{start, clearance_}, 0, size};
        case 1:
            return {{w - clearance_, start}, 90, size};
        case 2:
            return {{start, h - clearance_ - size.height()}, 0, size};
        default:
            return {{clearance_, h - start}, -90, size};
        }
    }

    QSizeF page_;
    double clearance_; // distance from the page's edge, mm
    const Paint& paint_;
    std::vector<QRectF> taken_;
};

// Places the marks outside the film if the paper has room, so that they also show where to cut;
// otherwise inside the film.
std::vector<SheetMark> placeMarks(const QRectF& film, double clearance, const Paint& paint) {
    const double inset = clearance + markReach;
    const bool outside = std::min(film.left(), film.top()) >= 2 * inset;
    const QRectF centres = outside ? film.adjusted(-inset, -inset, inset, inset)
                                   : film.adjusted(inset, inset, -inset, -inset);
    if (centres.width() < 4 * markReach || centres.height() < 4 * markReach) {
        return {};
    }
    std::vector<SheetMark> marks;
    for (const QPointF& corner :
         {centres.topLeft(), centres.topRight(), centres.bottomLeft(), centres.bottomRight()}) {
        SheetMark mark{corner};
        mark.overPaint = paint.share(mark.box()) > 0;
        marks.push_back(mark);
    }
    return marks;
}

std::optional<SheetStrip> placeRuler(Places& places, double mostInk) {
    const double room = places.longest() - 2 * rulerEndRoom;
    for (int length = std::min(100, int(room / 10) * 10); length >= 20; length -= 10) {
        const QSizeF size(length + 2 * rulerEndRoom, rulerDepth);
        if (auto strip = places.take(size, {2, 0, 3, 1}, mostInk)) {
            return strip;
        }
    }
    return std::nullopt;
}

// Returns texts for the job line, from the full text to the shortest, which is for tiny sheets.
std::vector<QStringList> jobLineTexts(const JobLine& job) {
    const QString names =
        QStringLiteral("%1 · %2 · %3")
            .arg(nameOnPaper(job.project), nameOnPaper(job.immersion), job.date.simplified());
    const QString number = Text::tr("Job %1").arg(job.hash.simplified());
    const QString facts = Text::tr("Film %1 · Scale %2 · %3")
                              .arg(nameOnPaper(job.film), nameOnPaper(job.scale), number);
    return {{QStringLiteral("%1 · %2").arg(names, facts)},
            {names, facts},
            {QStringLiteral("%1 · %2").arg(nameOnPaper(job.immersion), number)},
            {job.hash.simplified()}};
}

// Prefers a shorter text to a smaller font, and covers ink before the font shrinks.
void placeJobLine(SheetLayout& layout, Places& places, const JobLine& job, double mostInk) {
    const QFontMetricsF metrics(sheetFont(jobLineType));
    const std::vector<QStringList> texts = jobLineTexts(job);
    const double least = mostInk > 0 ? leastType : 0.99 * jobLineType;
    for (double type = jobLineType; type > least; type *= 0.85) {
        for (const QStringList& lines : texts) {
            double width = 0;
            for (const QString& line : lines) {
                width = std::max(width, metrics.horizontalAdvance(line) * typeUnit);
            }
            const QSizeF size(width * type / jobLineType,
                              double(lines.size()) * jobLinePitch + jobLineMargin);
            if ((layout.jobLine = places.take(size, {0, 2, 3, 1}, mostInk))) {
                layout.jobLineText = lines;
                layout.jobLineHeight = type;
                return;
            }
        }
    }
}

bool fitsOnPaper(const Sheet& sheet) {
    constexpr double tolerance = 0.01; // mm
    const QSizeF page = paperSize(sheet);
    return page.width() >= sheet.filmWidth.value() - tolerance &&
           page.height() >= sheet.filmHeight.value() - tolerance;
}

} // namespace

QRectF SheetStrip::box() const {
    return QTransform::fromTranslate(origin.x(), origin.y())
        .rotate(angle)
        .mapRect(QRectF({0, 0}, size));
}

QRectF SheetMark::box() const {
    return {centre.x() - markReach, centre.y() - markReach, 2 * markReach, 2 * markReach};
}

QSizeF paperSize(const Sheet& sheet) {
    return paperSize(sheet.settings, {sheet.filmWidth.value(), sheet.filmHeight.value()});
}

QSizeF pageSize(const Sheet& sheet) {
    const QSizeF film(sheet.filmWidth.value(), sheet.filmHeight.value());
    const QSizeF page = paperSize(sheet);
    if (!fitsOnPaper(sheet)) {
        throw Error(
            Text::tr("The paper of %1 × %2 mm is smaller than the film of %3 × %4 mm; choose "
                     "larger paper, turn it or make the film smaller")
                .arg(page.width())
                .arg(page.height())
                .arg(film.width())
                .arg(film.height()),
            QStringLiteral("sheet.paper"));
    }
    return page;
}

SheetLayout sheetLayout(const Sheet& sheet) {
    SheetLayout layout;
    layout.page = pageSize(sheet);
    const QSizeF film(sheet.filmWidth.value(), sheet.filmHeight.value());
    layout.film = QRectF(QPointF((layout.page.width() - film.width()) / 2,
                                 (layout.page.height() - film.height()) / 2),
                         film);
    const Paint paint(sheet, layout.film);
    const double clearance = sheet.clearance.value();
    layout.pieces = sheet.pieces;
    if (sheet.settings.marks && sheet.pieces.empty()) {
        layout.marks = placeMarks(layout.film, clearance, paint);
    }
    Places places(layout, clearance, paint);
    for (const double mostInk : {0.0, 1.0}) { // a short one beside the picture first
        if (sheet.settings.ruler && !layout.ruler) {
            layout.ruler = placeRuler(places, mostInk);
        }
        if (sheet.settings.jobLine && !layout.jobLine) {
            placeJobLine(layout, places, sheet.job, mostInk);
        }
    }
    return layout;
}

QString coveredPictureNote(const Sheet& sheet) {
    if (!fitsOnPaper(sheet)) {
        return {};
    }
    const SheetLayout layout = sheetLayout(sheet);
    const auto covers = [](const auto& item) { return item.overPaint; };
    const bool isCovered = std::any_of(layout.marks.begin(), layout.marks.end(), covers) ||
                           (layout.ruler && covers(*layout.ruler)) ||
                           (layout.jobLine && covers(*layout.jobLine));
    return isCovered ? Text::tr("The marks, the ruler or the job line cover a part of the picture, "
                                "because there is no room beside it. Use larger film or paper, or "
                                "do not print them")
                     : QString();
}

std::optional<QPointF> marksOnFilm(const Sheet& sheet) {
    Sheet bare = sheet;
    bare.image = {};
    bare.settings.marks = true;
    bare.settings.ruler = false;
    bare.settings.jobLine = false;
    const SheetLayout layout = sheetLayout(bare);
    const bool isOn = !layout.marks.empty() && layout.film.contains(layout.marks[3].centre);
    return isOn ? std::optional(layout.marks[3].centre - layout.film.center()) : std::nullopt;
}

QString nameOnPaper(const QString& name) {
    const QString text = printableText(name.simplified(), sheetFont(jobLineType));
    return text.size() <= longestName ? text : text.left(longestName - 1) + u'…';
}

QFont sheetFont(double height) {
    QFont font;
    font.setFamilies({QStringLiteral("DejaVu Sans"), QStringLiteral("Noto Sans"),
                      QStringLiteral("Arial"), QStringLiteral("Helvetica")});
    font.setStyleHint(QFont::SansSerif);
    font.setHintingPreference(QFont::PreferNoHinting);
    // Spacing prevents ligatures, so that the "ff" in a job number stays two letters and can be
    // searched for.
    constexpr double leastSpacing = 0.05; // spacing in units of the painter
    font.setLetterSpacing(QFont::AbsoluteSpacing, leastSpacing);
    font.setPixelSize(std::max(1, int(std::lround(height / typeUnit))));
    return font;
}

} // namespace dipwright
