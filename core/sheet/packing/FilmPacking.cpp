#include "sheet/packing/FilmPacking.h"

#include "base/Error.h"
#include "base/ImageRows.h"
#include "base/WideGamut.h"
#include "sheet/page/CutContour.h"
#include "sheet/page/InkedPixels.h"
#include "sheet/page/PieceInk.h"
#include "sheet/page/SheetLayout.h"
#include "texture/StretchPlane.h"

#include <QColorSpace>
#include <QCoreApplication>
#include <QLocale>
#include <QTransform>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <tuple>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Sheet)
};

QString nameOf(const PieceToPack& piece) {
    return QStringLiteral("%1, %2").arg(piece.sheet.job.project, piece.sheet.job.immersion);
}

// The same dip of the same job. Its copies are numbered through, even if the job is packed twice.
using DipKey = std::pair<QString, int>;

DipKey keyOf(const PieceToPack& piece) {
    return {piece.sheet.job.hash, piece.dip};
}

int copiesOf(const DipKey& key, const std::vector<PieceToPack>& pieces) {
    int copies = 0;
    for (const PieceToPack& piece : pieces) {
        copies += keyOf(piece) == key ? piece.copies : 0;
    }
    return copies;
}

// Collects the plates of all pieces, without their tints. White becomes the last plate of its
// group. One group is printed before the four inks, the other after them.
std::vector<SheetPlate> platesOf(const std::vector<PieceToPack>& pieces) {
    std::vector<SheetPlate> plates;
    std::vector<SheetPlate> white;
    const auto find = [](std::vector<SheetPlate>& kind, const QString& name) {
        const auto known = std::find_if(kind.begin(), kind.end(), [&](const SheetPlate& other) {
            return other.name.compare(name, Qt::CaseInsensitive) == 0;
        });
        return known == kind.end() ? nullptr : &*known;
    };
    for (const PieceToPack& piece : pieces) {
        for (SheetPlate plate : piece.sheet.plates) {
            plate.tint = {};
            const bool belongsToWhite = isWhite(plate, piece.sheet.settings);
            std::vector<SheetPlate>& kind = belongsToWhite ? white : plates;
            const SheetPlate* known = find(kind, plate.name);
            if (find(belongsToWhite ? plates : white, plate.name)) {
                throw Error(Text::tr("The ink %1 is a spot ink in one job and the white ink in "
                                     "another; rename one of them")
                                .arg(plate.name),
                            nameOf(piece));
            }
            if (known && known->name != plate.name) {
                throw Error(Text::tr("This job's spot ink %1 is named %2 in another job; write "
                                     "both alike, with the same capital letters")
                                .arg(plate.name, known->name),
                            nameOf(piece));
            }
            if (known && (known->first != plate.first || known->alternate != plate.alternate)) {
                throw Error(
                    Text::tr("This job's spot ink %1 has another colour or printing order than in "
                             "another job; give it the same colour and order in both jobs")
                        .arg(plate.name),
                    nameOf(piece));
            }
            if (!known) {
                kind.push_back(plate);
            }
        }
    }
    plates.insert(plates.end(), white.begin(), white.end());
    return plates;
}

// Throws Error if the jobs differ in their white, because a printer prints white either before all
// colours or after all colours.
void refuseMixedWhite(const std::vector<PieceToPack>& pieces) {
    const Sheet* first = nullptr;
    for (const PieceToPack& piece : pieces) {
        if (piece.sheet.settings.white == WhiteLayer::None || piece.sheet.plates.empty()) {
            continue;
        }
        if (first && (first->settings.white != piece.sheet.settings.white ||
                      first->settings.whiteName != piece.sheet.settings.whiteName)) {
            throw Error(Text::tr("This job's white layer differs from the white layer of %1; give "
                                 "both the same kind of white and the same ink name")
                            .arg(first->job.project),
                        nameOf(piece));
        }
        first = &piece.sheet;
    }
}

// Returns which setting of the cut contour differs; empty if the contours can share a film.
QString cutDifference(const SheetSettings& a, const SheetSettings& b) {
    const bool isCut = a.cutLine != CutLine::None;
    const bool isInk = a.cutLine == CutLine::Ink;
    return a.cutLine != b.cutLine                    ? Text::tr("Cut contour")
           : isCut && a.cutName != b.cutName         ? Text::tr("Name of the cut contour")
           : isInk && a.cutDistance != b.cutDistance ? Text::tr("Distance of the cut contour")
           : isInk && a.cutBleed != b.cutBleed       ? Text::tr("Bleed at the cut contour")
                                                     : QString();
}

// The layout of an upright piece around its picture, in pixels.
struct PieceLayout {
    QSize size;
    QRect picture;
};

class Pixels {
public:
    explicit Pixels(DotsPerInch resolution) : unit_(pixelsPerMillimetre(resolution)) {}
    int of(double millimetres) const { return int(std::ceil(millimetres * unit_ - 1e-9)); }
    double unit() const { return unit_; }

private:
    double unit_; // pixels per mm
};

PieceLayout layoutOf(const PieceToPack& piece, QSize picture, const PackingFilm& film) {
    if (film.wholeSheets) {
        return {picture, {{0, 0}, picture}};
    }
    const Pixels pixels(piece.sheet.settings.resolution);
    const int margin =
        pixels.of(std::max(film.margin.value(), leastPieceMargin + cutReach(piece.sheet.settings)));
    const bool hasFoot = piece.sheet.settings.jobLine;
    const int width =
        std::max(picture.width() + 2 * margin, hasFoot ? pixels.of(leastPieceWidth) : 0);
    const int height = picture.height() + 2 * margin + (hasFoot ? pixels.of(pieceFoot) : 0);
    return {{width, height}, {{(width - picture.width()) / 2, margin}, picture}};
}

// Throws Error if the film is too wide for an image, or too long for a page.
QSize filmSizeInPixels(QSizeF size, DotsPerInch resolution) {
    if (size.height() > mostFilmLength) {
        throw Error(Text::tr("A film of %1 mm is longer than the limit of %2 mm; choose a shorter "
                             "film")
                        .arg(size.height())
                        .arg(mostFilmLength),
                    QStringLiteral("film"));
    }
    const int width =
        sheetPixels(Millimetres(size.width()), Millimetres(size.width()), resolution).width();
    return {width, std::max(int(std::lround(size.height() * Pixels(resolution).unit())), 1)};
}

} // namespace

void checkSettings(const std::vector<PieceToPack>& pieces) {
    int count = 0;
    for (const PieceToPack& piece : pieces) {
        count += piece.copies;
        if (piece.sheet.settings.resolution.value() !=
            pieces.front().sheet.settings.resolution.value()) {
            throw Error(Text::tr("This job's sheet has %1 dpi, but the sheet of %2 has %3 dpi; "
                                 "give both the same resolution")
                            .arg(piece.sheet.settings.resolution.value())
                            .arg(nameOf(pieces.front()))
                            .arg(pieces.front().sheet.settings.resolution.value()),
                        nameOf(piece));
        }
        if (piece.sheet.passes != pieces.front().sheet.passes) {
            throw Error(Text::tr("This job's sheet is printed in %1 passes, but the sheet of %2 in "
                                 "%3; give both the same number of passes")
                            .arg(piece.sheet.passes)
                            .arg(nameOf(pieces.front()))
                            .arg(pieces.front().sheet.passes),
                        nameOf(piece));
        }
        const QString cut = cutDifference(piece.sheet.settings, pieces.front().sheet.settings);
        if (!cut.isEmpty()) {
            throw Error(Text::tr("The setting “%1” differs between this job and %2; give both the "
                                 "same value")
                            .arg(cut, nameOf(pieces.front())),
                        nameOf(piece));
        }
    }
    if (count < 1 || count > mostPieces) {
        throw Error(Text::tr("%1 pieces cannot be packed; choose 1 to %2 pieces")
                        .arg(count)
                        .arg(mostPieces),
                    QStringLiteral("copies"));
    }
}

namespace {

// Returns the part of the film where pieces may lie, in pixels.
QRect roomOf(const PackingFilm& film, QSize size, DotsPerInch resolution) {
    const Pixels pixels(resolution);
    return QRect({0, 0}, size)
        .adjusted(pixels.of(film.edges.left()), pixels.of(film.edges.top()),
                  -pixels.of(film.edges.right()), -pixels.of(film.edges.bottom()));
}

void refuseLarge(const PieceToPack& piece, QSize size, const QRect& room, bool isRoll) {
    const double unit = Pixels(piece.sheet.settings.resolution).unit();
    const auto mm = [unit](int pixels) { return QString::number(pixels / unit, 'f', 1); };
    const QString reason =
        isRoll ? Text::tr("With its marks, this job's sheet needs %1 × %2 mm, but the roll has "
                          "only %3 × %4 mm inside its edges; use a larger roll or a smaller film")
               : Text::tr("With its marks, this job's sheet needs %1 × %2 mm, but the film has "
                          "only %3 × %4 mm inside its edges; use a larger film");
    throw Error(
        reason.arg(mm(size.width()), mm(size.height()), mm(room.width()), mm(room.height())),
        nameOf(piece));
}

// Throws Error if the cut contour or its bleed leaves a whole sheet. There, the next sheet or the
// cut marks may be.
void refuseCutPastSheet(const PieceToPack& piece) {
    const Sheet& sheet = piece.sheet;
    const double reach = cutReach(sheet.settings);
    const QRect inked = reach > 0 ? inkedBox(sheet) : QRect();
    const int pixels = Pixels(sheet.settings.resolution).of(reach);
    if (!inked.isEmpty() &&
        !sheet.image.rect().contains(inked.adjusted(-pixels, -pixels, pixels, pixels))) {
        throw Error(Text::tr("The cut contour with its bleed reaches %1 mm from the ink, past the "
                             "edge of this job's sheet; choose a smaller distance or bleed, or a "
                             "cut contour along the film's edge")
                        .arg(QLocale().toString(reach)),
                    nameOf(piece));
    }
}

PlannedFilm plannedFilm(const std::vector<PackPlace>& places,
                        const std::vector<std::pair<std::size_t, int>>& copies, const QRect& room) {
    PlannedFilm film;
    for (const PackPlace& place : places) {
        const auto [piece, copy] = copies[place.item];
        film.pieces.push_back({piece, copy, place.box.translated(room.topLeft()), place.turned});
    }
    std::sort(
        film.pieces.begin(), film.pieces.end(), [](const PlannedPiece& a, const PlannedPiece& b) {
            return std::tuple(a.box.top(), a.box.left()) < std::tuple(b.box.top(), b.box.left());
        });
    return film;
}

// Sets the film's size and used share. A roll is cut off after its last piece.
void finish(PlannedFilm& planned, const PackingFilm& film, QSize most, DotsPerInch resolution) {
    const Pixels pixels(resolution);
    planned.pixels = most;
    planned.size = film.size;
    double area = 0;
    int bottom = 0;
    for (const PlannedPiece& piece : planned.pieces) {
        area += double(piece.box.width()) * piece.box.height();
        bottom = std::max(bottom, piece.box.bottom() + 1);
    }
    if (film.isRoll) {
        planned.pixels.setHeight(std::min(most.height(), bottom + pixels.of(film.edges.bottom())));
        planned.size.setHeight(planned.pixels.height() / pixels.unit());
    }
    planned.used = area / (double(planned.pixels.width()) * planned.pixels.height());
}

// Moves a box from the upright piece to the page.
QRect onPage(const QRect& box, const PlannedPiece& piece) {
    return (piece.turned
                ? QRect(piece.box.width() - box.bottom() - 1, box.left(), box.height(), box.width())
                : box)
        .translated(piece.box.topLeft());
}

// Returns what is printed around the film of a whole sheet. The job line has room for the digits
// that a printer's profile adds to the job number later.
std::shared_ptr<const SheetLayout> ownLayout(const Sheet& sheet) {
    const QString digits = QStringLiteral("-000000");
    Sheet film = sheet;
    film.settings.paper = QStringLiteral("film");
    film.job.hash += digits;
    SheetLayout layout = sheetLayout(film);
    layout.jobLineText.replaceInStrings(digits, QString());
    return std::make_shared<const SheetLayout>(layout);
}

SheetPiece sheetPiece(const PieceToPack& piece, const PlannedPiece& planned,
                      const PieceLayout& layout, const QRect& inked, QPointF pixel) {
    const double unit = Pixels(piece.sheet.settings.resolution).unit();
    const QPointF ownMiddle(piece.sheet.image.width() / 2.0 - inked.left(),
                            piece.sheet.image.height() / 2.0 - inked.top());
    SheetPiece result;
    result.corner = {planned.box.left() * pixel.x(), planned.box.top() * pixel.y()};
    result.size = QSizeF(layout.size) / unit;
    result.picture = {QPointF(layout.picture.topLeft()) / unit,
                      QSizeF(layout.picture.size()) / unit};
    result.middle = (QPointF(layout.picture.topLeft()) + ownMiddle) / unit;
    result.turned = planned.turned;
    result.job = piece.sheet.job;
    result.dip = piece.dip;
    result.copy = planned.copy;
    result.marks = piece.sheet.settings.marks;
    result.jobLine = piece.sheet.settings.jobLine;
    result.cutReach = cutReach(piece.sheet.settings);
    return result;
}

// Returns the film's job line, which describes its pieces.
JobLine filmJob(const Sheet& sheet, const PlannedFilm& film, std::size_t number,
                std::size_t count) {
    QStringList projects, jobs;
    for (std::size_t i = 0; i < sheet.pieces.size(); ++i) {
        const SheetPiece& piece = sheet.pieces[i];
        const PlannedPiece& planned = film.pieces[i];
        if (!projects.contains(piece.job.project)) {
            projects << piece.job.project;
        }
        jobs << QStringLiteral("%1@%2;%3%4")
                    .arg(pieceCode(piece))
                    .arg(planned.box.left())
                    .arg(planned.box.top())
                    .arg(planned.turned ? QStringLiteral("t") : QString());
    }
    const auto mm = [](double length) { return QString::number(length, 'f', 0); };
    return {projects.join(QStringLiteral(", ")),
            jobs.size() == 1
                ? Text::tr("Film %1 of %2, 1 piece").arg(number + 1).arg(count)
                : Text::tr("Film %1 of %2, %3 pieces").arg(number + 1).arg(count).arg(jobs.size()),
            sheet.pieces.front().job.date,
            Text::tr("%1 × %2 mm").arg(mm(film.size.width()), mm(film.size.height())),
            QStringLiteral("1:1"),
            hashOfJobs(jobs)};
}

} // namespace

FilmPlan planFilms(const std::vector<PieceToPack>& pieces, const PackingFilm& film) {
    checkSettings(pieces);
    refuseMixedWhite(pieces);
    const DotsPerInch resolution = pieces.front().sheet.settings.resolution;
    const Pixels pixels(resolution);
    const QSize most = filmSizeInPixels(film.size, resolution);
    const QRect room = roomOf(film, most, resolution);
    const int spacing = pixels.of(film.spacing.value());
    const QSize between(spacing, spacing); // added to each piece, and once to the room
    FilmPlan plan;
    std::vector<PackItem> items;
    std::vector<std::pair<std::size_t, int>> copies;
    std::map<DipKey, int> lastCopies;
    for (std::size_t number = 0; number < pieces.size(); ++number) {
        const PieceToPack& piece = pieces[number];
        if (film.wholeSheets) {
            refuseCutPastSheet(piece);
        }
        const QRect inked = film.wholeSheets ? piece.sheet.image.rect() : inkedBox(piece.sheet);
        if (inked.isEmpty()) {
            throw Error(Text::tr("This job's sheet contains no ink; remove the job from the film"),
                        nameOf(piece));
        }
        plan.inked.push_back(inked);
        const QSize size = layoutOf(piece, inked.size(), film).size;
        if (!fits({size, piece.turning}, room.size())) {
            refuseLarge(piece, size, room, film.isRoll);
        }
        int& copy = lastCopies[keyOf(piece)];
        for (int i = 0; i < piece.copies; ++i) {
            items.push_back({size + between, piece.turning});
            copies.emplace_back(number, ++copy);
        }
    }
    for (std::vector<PackPlace>& places : packed(items, room.size() + between)) {
        for (PackPlace& place : places) {
            place.box.setSize(place.box.size() - between);
        }
        plan.films.push_back(plannedFilm(places, copies, room));
        finish(plan.films.back(), film, most, resolution);
    }
    if (plan.films.size() > std::size_t(mostFilms)) {
        throw Error(
            Text::tr("The copies need %1 films, more than the limit of %2; choose fewer copies")
                .arg(plan.films.size())
                .arg(mostFilms),
            QStringLiteral("copies"));
    }
    return plan;
}

namespace {

// Returns the first piece with amounts of ink (base/InkPicture.h); null if none has any.
const WantedInk* firstInks(const std::vector<PieceToPack>& pieces) {
    const auto found = std::find_if(pieces.begin(), pieces.end(), [](const PieceToPack& piece) {
        return piece.sheet.wanted && !piece.sheet.wanted->inks.isNull();
    });
    return found == pieces.end() ? nullptr : &*found->sheet.wanted;
}

// Returns the settings without the tone curve, which the wanted colours have already.
InkSettings untoned(InkSettings ink) {
    ink.densest = leastLightening;
    return ink;
}

// Returns the ink settings that all pieces share, for CMYK printers; none if the pieces differ. If
// a piece has amounts of ink, its settings count, and pieces without wanted colours fit to them if
// there is one pass. With more, their pictures have the ink of one pass already.
std::optional<InkSettings> commonInk(const std::vector<PieceToPack>& pieces) {
    const std::optional<WantedInk>& front = pieces.front().sheet.wanted;
    const WantedInk* const inks = firstInks(pieces);
    const WantedInk* const first = inks ? inks : front ? &*front : nullptr;
    const bool isCommon =
        first && std::all_of(pieces.begin(), pieces.end(), [&](const PieceToPack& piece) {
            return piece.sheet.wanted
                       ? untoned(piece.sheet.wanted->settings) == untoned(first->settings)
                       : inks != nullptr && first->settings.printedPasses() == 1;
        });
    return isCommon ? std::optional(first->settings) : std::nullopt;
}

// A piece's pictures as they lie on the film: cut out, turned and in the film's format.
struct LaidPictures {
    QImage colours;
    std::vector<QImage> tints; // one per plate of the film; null: the piece does not have the plate
    QImage wanted, stretch;    // null if the film has no wanted colours
    InkPlanes inks;            // null if the piece has no amounts of ink in the film's space
};

// Copies the rows of a picture that lie on the rows of a film that begin with row `first`.
void layRows(QImage& rows, int first, QPoint place, const QImage& picture) {
    const qsizetype bytes = rows.depth() / 8;
    const int from = std::max(place.y(), first);
    const int end = std::min(place.y() + picture.height(), first + rows.height());
    for (int y = from; y < end; ++y) {
        std::memcpy(rows.scanLine(y - first) + place.x() * bytes,
                    picture.constScanLine(y - place.y()), std::size_t(picture.width() * bytes));
    }
}

// Makes rows of a film from the pictures of its pieces. Const members may be used from several
// threads.
class FilmPictures {
public:
    // `blank` is the film without pictures; its plates have names, and its wanted colours settings.
    FilmPictures(const Sheet& blank, QSize pixels, bool wide)
        : blank_(blank), pixels_(pixels),
          format_(wide ? QImage::Format_RGBA64 : QImage::Format_RGBA8888) {}

    void setColours(const QColorSpace& colours) { colours_ = colours; }
    // Adds the part `inked` of a sheet at a place on the film, turned or not.
    void add(const Sheet& sheet, const QRect& inked, bool turned, QPoint place) {
        const auto key = std::pair(&sheet, turned);
        if (!laid_.contains(key)) {
            laid_[key] = laidPictures(sheet, inked, turned);
        }
        places_.emplace_back(place, &laid_.at(key));
    }

    // Returns the film's pictures in the rows first … end - 1.
    Sheet rows(int first, int end) const {
        const QSize size(pixels_.width(), end - first);
        Sheet sheet = blank_;
        const auto blankColours = [&] {
            QImage image = blankImage(size, format_);
            image.setColorSpace(colours_);
            return image;
        };
        sheet.image = blankColours();
        for (SheetPlate& plate : sheet.plates) {
            plate.tint = blankImage(size, QImage::Format_Grayscale8);
        }
        if (sheet.wanted) {
            sheet.wanted->image = blankColours();
            sheet.wanted->stretch = unstretched(size);
            if (!sheet.wanted->inks.space.isEmpty()) {
                const QImage plane = blankImage(size, QImage::Format_RGBA8888);
                sheet.wanted->inks = {plane, plane, sheet.wanted->inks.space};
            }
        }
        for (const auto& [place, pictures] : places_) {
            if (place.y() >= end || place.y() + pictures->colours.height() <= first) {
                continue;
            }
            layRows(sheet.image, first, place, pictures->colours);
            for (std::size_t plate = 0; plate < sheet.plates.size(); ++plate) {
                if (!pictures->tints[plate].isNull()) {
                    layRows(sheet.plates[plate].tint, first, place, pictures->tints[plate]);
                }
            }
            if (sheet.wanted) {
                layRows(sheet.wanted->image, first, place, pictures->wanted);
                layRows(sheet.wanted->stretch, first, place, pictures->stretch);
            }
            if (!pictures->inks.isNull()) {
                layRows(sheet.wanted->inks.colours, first, place, pictures->inks.colours);
                layRows(sheet.wanted->inks.black, first, place, pictures->inks.black);
            }
        }
        return sheet;
    }

private:
    LaidPictures laidPictures(const Sheet& sheet, const QRect& inked, bool turned) const {
        const auto cut = [&](const QImage& picture, QImage::Format format) {
            const QImage part = picture.copy(inked);
            return (turned ? part.transformed(QTransform().rotate(90)) : part)
                .convertToFormat(format);
        };
        const auto colours = [&](const QImage& picture) {
            return cut(format_ == QImage::Format_RGBA64 ? inWide(picture) : picture, format_);
        };
        LaidPictures laid{colours(sheet.image), {}, {}, {}, {}};
        for (const SheetPlate& plate : blank_.plates) {
            const auto own =
                std::find_if(sheet.plates.begin(), sheet.plates.end(),
                             [&](const SheetPlate& other) { return other.name == plate.name; });
            laid.tints.push_back(
                own == sheet.plates.end() ? QImage() : cut(own->tint, QImage::Format_Grayscale8));
        }
        if (blank_.wanted && !sheet.wanted) { // compensated already, or not to be
            laid.wanted = laid.colours;
            laid.stretch = unstretched(laid.colours.size());
        } else if (blank_.wanted) {
            laid.wanted = colours(sheet.wanted->image);
            laid.stretch = cut(sheet.wanted->stretch, QImage::Format_Grayscale16);
            if (sheet.wanted->inks.space == blank_.wanted->inks.space) {
                laid.inks = sheet.wanted->inks.each(
                    [&](const QImage& plane) { return cut(plane, QImage::Format_RGBA8888); });
            }
        }
        return laid;
    }

    Sheet blank_;
    QSize pixels_;
    QImage::Format format_;
    QColorSpace colours_;
    std::map<std::pair<const Sheet*, bool>, LaidPictures> laid_;
    std::vector<std::pair<QPoint, const LaidPictures*>> places_;
};

} // namespace

bool losesInks(const std::vector<PieceToPack>& pieces) {
    const bool isCommon = commonInk(pieces).has_value();
    const WantedInk* const first = firstInks(pieces);
    return std::any_of(pieces.begin(), pieces.end(), [&](const PieceToPack& piece) {
        const std::optional<WantedInk>& wanted = piece.sheet.wanted;
        return wanted &&
               (!isCommon || (!wanted->inks.isNull() && wanted->inks.space != first->inks.space));
    });
}

Sheet filmSheet(const std::vector<PieceToPack>& pieces, const PackingFilm& film,
                const FilmPlan& plan, std::size_t number, qint64 mostKeptPixels) {
    const PlannedFilm& planned = plan.films[number];
    const bool wide = std::any_of(pieces.begin(), pieces.end(), [](const PieceToPack& piece) {
        return isWide(piece.sheet.image);
    });
    Sheet sheet;
    sheet.filmWidth = Millimetres(planned.size.width());
    sheet.filmHeight = Millimetres(planned.size.height());
    sheet.settings = pieces.front().sheet.settings; // checkSettings() compares what must be equal
    sheet.passes = pieces.front().sheet.passes;
    sheet.settings.paper = QStringLiteral("film");
    sheet.settings.landscape = false;
    sheet.settings.ruler = sheet.settings.ruler && !film.wholeSheets; // they have their own
    for (const PieceToPack& piece : pieces) {
        if (piece.sheet.settings.white != WhiteLayer::None) {
            sheet.settings.white = piece.sheet.settings.white;
            sheet.settings.whiteName = piece.sheet.settings.whiteName;
        }
    }
    sheet.plates = platesOf(pieces);
    if (const std::optional<InkSettings> ink = commonInk(pieces)) {
        sheet.wanted = WantedInk{{}, {}, *ink};
        if (const WantedInk* const inks = firstInks(pieces)) {
            sheet.wanted->inks.space = inks->inks.space; // their pictures come with the rows
        }
    }
    const auto pictures = std::make_shared<FilmPictures>(sheet, planned.pixels, wide);
    pictures->setColours(wide ? wideSpace() : pieces.front().sheet.image.colorSpace());
    std::map<std::size_t, std::shared_ptr<const SheetLayout>> layouts; // of whole sheets
    const QPointF pixel(planned.size.width() / planned.pixels.width(),
                        planned.size.height() / planned.pixels.height());
    for (const PlannedPiece& one : planned.pieces) {
        const PieceToPack& piece = pieces[one.piece];
        const QRect& inked = plan.inked[one.piece];
        const PieceLayout layout = layoutOf(piece, inked.size(), film);
        pictures->add(piece.sheet, inked, one.turned, onPage(layout.picture, one).topLeft());
        sheet.pieces.push_back(sheetPiece(piece, one, layout, inked, pixel));
        sheet.pieces.back().copies = copiesOf(keyOf(piece), pieces);
        if (film.wholeSheets) {
            std::shared_ptr<const SheetLayout>& own = layouts[one.piece];
            own = own ? own : ownLayout(piece.sheet);
            sheet.pieces.back().whole = own;
            sheet.pieces.back().gap = film.spacing.value();
        }
    }
    sheet.job = filmJob(sheet, planned, number, plan.films.size());
    if (qint64(planned.pixels.width()) * planned.pixels.height() > mostKeptPixels) {
        sheet.rows = std::make_shared<const FilmRows>(FilmRows{
            planned.pixels, [pictures](int first, int end) { return pictures->rows(first, end); }});
        return sheet;
    }
    Sheet whole = pictures->rows(0, planned.pixels.height());
    sheet.image = std::move(whole.image);
    sheet.plates = std::move(whole.plates);
    sheet.wanted = std::move(whole.wanted);
    return sheet;
}

} // namespace dipwright
