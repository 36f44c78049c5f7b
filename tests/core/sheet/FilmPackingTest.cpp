// Tests several jobs packed on one film, compared with each job alone.
#include "PaperMeasure.h"
#include "TestProfiles.h"

#include "base/Bytes.h"
#include "base/Error.h"
#include "sheet/packing/FilmPacking.h"
#include "sheet/page/CutContour.h"
#include "sheet/page/InkedPixels.h"
#include "sheet/page/SheetRows.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/Separation.h"
#include "sheet/prepress/SheetFiles.h"
#include "texture/StretchPlane.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTransform>
#include <QtTest>

#include <algorithm>
#include <cstdint>
#include <random>
#include <tiffio.h>

using namespace dipwright;

namespace {

// Returns a job number that begins with ff, which fonts may draw as a ligature.
QString jobNumber(const QString& name) {
    constexpr int letters = 12;
    const QByteArray hash = QCryptographicHash::hash(name.toUtf8(), QCryptographicHash::Md5);
    return (QStringLiteral("ff") + QString::fromLatin1(hash.toHex())).left(letters);
}

// Returns a piece on an A4 film with ink in the rectangle `inked` (mm). Each pixel differs from its
// neighbours, also in opacity.
PieceToPack part(const QString& name, QRectF inked, int copies = 1) {
    PieceToPack piece;
    Sheet& sheet = piece.sheet;
    sheet.image = QImage(sheetPixels(sheet.filmWidth, sheet.filmHeight, sheet.settings.resolution),
                         QImage::Format_RGBA8888);
    sheet.image.fill(Qt::transparent);
    const double unit = sheet.image.width() / sheet.filmWidth.value();
    const QRect box = QRectF(inked.topLeft() * unit, inked.size() * unit).toRect();
    for (int y = box.top(); y <= box.bottom(); ++y) {
        for (int x = box.left(); x <= box.right(); ++x) {
            sheet.image.setPixel(
                x, y, qRgba(x % 251, y % 241, (x + y + name.size()) % 239, 100 + (x * y) % 156));
        }
    }
    sheet.job = {name,
                 QStringLiteral("Top"),
                 QStringLiteral("2026-03-01"),
                 QStringLiteral("A4 210 × 297 mm"),
                 QStringLiteral("1:1"),
                 jobNumber(name)};
    piece.copies = copies;
    return piece;
}

std::vector<PieceToPack> nineParts() {
    std::vector<PieceToPack> parts;
    for (int number = 0; number < 9; ++number) {
        parts.push_back(part(QStringLiteral("Part %1").arg(number + 1),
                             {20.0 + 11 * number, 30.0 + 17 * number, 30.0 + 2 * (number % 4),
                              35.0 + 3 * (number % 5)}));
    }
    return parts;
}

QRect inkedBox(const QImage& image) {
    QRect box;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (qAlpha(image.pixel(x, y)) > 0) {
                box |= QRect(x, y, 1, 1);
            }
        }
    }
    return box;
}

// Returns the place of a piece's picture on the film, in pixels.
QRect pictureBox(const Sheet& sheet, const SheetPiece& piece) {
    const double unit = sheet.image.width() / sheet.filmWidth.value();
    const QRectF own = piece.picture;
    const QRectF box = piece.turned ? QRectF(piece.size.height() - own.bottom(), own.left(),
                                             own.height(), own.width())
                                    : own;
    const QRectF page = box.translated(piece.corner);
    return {(page.topLeft() * unit).toPoint(), (page.size() * unit).toSize()};
}

QByteArray pdfOf(const Sheet& sheet) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writeSheetPdf(sheet, buffer);
    return buffer.data();
}

} // namespace

class FilmPackingTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString save(const QByteArray& bytes, const QString& name) {
        QFile file(folder_.filePath(name));
        if (!file.open(QIODevice::WriteOnly)) {
            qFatal("cannot write %s", qPrintable(file.fileName()));
        }
        file.write(bytes);
        return file.fileName();
    }

private slots:
    void packed_rectangles_neitherOverlapNorLeaveTheBin() {
        std::mt19937 random(5);
        std::vector<PackItem> items;
        for (int number = 0; number < 300; ++number) {
            items.push_back(
                {QSize(int(20 + random() % 180), int(20 + random() % 180)), Turning(random() % 3)});
        }
        const QSize bin(600, 800);
        const auto bins = packed(items, bin);
        std::vector<int> seen(items.size(), 0);
        double area = 0;
        for (const auto& places : bins) {
            for (std::size_t i = 0; i < places.size(); ++i) {
                const PackPlace& place = places[i];
                const PackItem& item = items[place.item];
                ++seen[place.item];
                area += double(place.box.width()) * place.box.height();
                QVERIFY(QRect({0, 0}, bin).contains(place.box));
                QCOMPARE(place.box.size(), place.turned ? item.size.transposed() : item.size);
                QVERIFY(item.turning == Turning::Allowed ||
                        place.turned == (item.turning == Turning::Always));
                for (std::size_t j = 0; j < i; ++j) {
                    QVERIFY(!place.box.intersects(places[j].box));
                }
            }
        }
        QCOMPARE(std::count(seen.begin(), seen.end(), 1), std::ptrdiff_t(items.size()));
        // At most one bin more than 1.5 times the number of bins that the area alone would need.
        QVERIFY2(double(bins.size()) <= 1 + 1.5 * area / (bin.width() * bin.height()),
                 qPrintable(QStringLiteral("%1 bins").arg(bins.size())));
    }

    void planFilms_nineSmallParts_fitOnOneA4() {
        const std::vector<PieceToPack> parts = nineParts();
        PackingFilm film;
        const FilmPlan plan = planFilms(parts, film);
        QCOMPARE(plan.films.size(), std::size_t(1));
        const Sheet sheet = filmSheet(parts, film, plan, 0);
        QCOMPARE(sheet.image.size(), QSize(2480, 3508));
        QCOMPARE(sheet.pieces.size(), std::size_t(9));
        const double spacing = film.spacing.value() - 0.001;
        QSet<QString> names;
        for (const SheetPiece& piece : sheet.pieces) {
            names.insert(piece.job.project);
            QVERIFY(QRectF(5, 5, 200, 282).contains(piece.box()));
            for (const SheetPiece& other : sheet.pieces) {
                QVERIFY(&other == &piece || !piece.box()
                                                 .adjusted(-spacing, -spacing, spacing, spacing)
                                                 .intersects(other.box()));
            }
        }
        QCOMPARE(names.size(), 9);
    }

    void filmSheet_pieces_equalTheirSheetsPixelByPixel() {
        const std::vector<PieceToPack> parts = nineParts();
        const FilmPlan plan = planFilms(parts, {});
        const Sheet sheet = filmSheet(parts, {}, plan, 0);
        const QImage film = flattened(sheet.image);
        qsizetype inked = 0;
        for (const SheetPiece& piece : sheet.pieces) {
            const PieceToPack& own =
                *std::find_if(parts.begin(), parts.end(), [&](const PieceToPack& candidate) {
                    return candidate.sheet.job.project == piece.job.project;
                });
            const QRect box = inkedBox(own.sheet.image);
            const QRect place = pictureBox(sheet, piece);
            QCOMPARE(place.size(), box.size());
            QCOMPARE(sheet.image.copy(place), own.sheet.image.copy(box));
            QCOMPARE(film.copy(place), flattened(own.sheet.image).copy(box));
            inked += qsizetype(box.width()) * box.height();
            // The ticks mark the middle of the piece's own film.
            const QPointF middle = piece.middle - piece.picture.topLeft();
            QVERIFY(std::abs(middle.x() - (105 - box.left() * 210 / 2480.0)) < 0.1);
            QVERIFY(std::abs(middle.y() - (148.5 - box.top() * 297 / 3508.0)) < 0.1);
        }
        qsizetype all = 0;
        for (int y = 0; y < sheet.image.height(); ++y) {
            for (int x = 0; x < sheet.image.width(); ++x) {
                all += qAlpha(sheet.image.pixel(x, y)) > 0;
            }
        }
        QCOMPARE(all, inked); // nothing else is inked
    }

    void filmSheet_turnedPiece_isTurnedExactly() {
        std::vector<PieceToPack> parts{part("Turned", {40, 50, 30, 60})};
        parts[0].turning = Turning::Always;
        const FilmPlan plan = planFilms(parts, {});
        const Sheet sheet = filmSheet(parts, {}, plan, 0);
        QVERIFY(sheet.pieces[0].turned);
        const QImage own = parts[0].sheet.image.copy(inkedBox(parts[0].sheet.image));
        QCOMPARE(sheet.image.copy(inkedBox(sheet.image)), own.transformed(QTransform().rotate(90)));
        QCOMPARE(pictureBox(sheet, sheet.pieces[0]), inkedBox(sheet.image));
    }

    void filmSheet_white_staysWithItsPicture() {
        std::vector<PieceToPack> parts{part("Plain", {40, 50, 30, 40}),
                                       part("White", {60, 70, 30, 40})};
        Sheet& own = parts[1].sheet;
        own.settings.white = WhiteLayer::Last;
        QImage white(own.image.size(), QImage::Format_Grayscale8);
        white.fill(0);
        for (int y = 700; y < 1500; ++y) { // white extends past the colour, as on a dark part
            white.scanLine(y)[800] = uchar(1 + y % 255);
        }
        own.plates = {{own.settings.whiteName, white}};
        const FilmPlan plan = planFilms(parts, {});
        const Sheet sheet = filmSheet(parts, {}, plan, 0);
        QCOMPARE(sheet.settings.white, WhiteLayer::Last);
        QCOMPARE(sheet.plates.size(), std::size_t(1));
        QCOMPARE(sheet.plates[0].name, own.settings.whiteName);
        QCOMPARE(sheet.plates[0].tint.size(), sheet.image.size());
        const SheetPiece& piece = sheet.pieces[sheet.pieces[0].job.project == "White" ? 0 : 1];
        const QRect box = inkedBox(own.image) | QRect(800, 700, 1, 800);
        QCOMPARE(sheet.plates[0].tint.copy(pictureBox(sheet, piece)), white.copy(box));
        QCOMPARE(sheet.image.copy(pictureBox(sheet, piece)), own.image.copy(box));
        parts[0].sheet.plates = own.plates;
        parts[0].sheet.settings.white = WhiteLayer::First;
        QVERIFY_EXCEPTION_THROWN(planFilms(parts, {}), Error);
        // A spot ink with the name of the other job's white would share its plate.
        parts[0].sheet.settings.white = WhiteLayer::None;
        parts[0].sheet.plates[0].name = own.settings.whiteName.toLower();
        QVERIFY_EXCEPTION_THROWN(filmSheet(parts, {}, planFilms(parts, {}), 0), Error);
    }

    void filmSheet_wantedInk_staysWithItsPicture() {
        std::vector<PieceToPack> parts{part("One", {40, 50, 30, 40}),
                                       part("Two", {60, 70, 30, 40})};
        InkSettings ink;
        ink.law.exponents[0] = 0.5;
        for (PieceToPack& piece : parts) {
            QImage stretch = unstretched(piece.sheet.image.size());
            for (int y = 0; y < stretch.height(); ++y) {
                std::fill_n(reinterpret_cast<std::uint16_t*>(stretch.scanLine(y)), stretch.width(),
                            std::uint16_t(30'000 + y));
            }
            piece.sheet.wanted = WantedInk{piece.sheet.image, stretch, ink};
        }
        const Sheet sheet = filmSheet(parts, {}, planFilms(parts, {}), 0);
        QVERIFY(sheet.wanted && sheet.wanted->settings == ink);
        for (const SheetPiece& piece : sheet.pieces) {
            const Sheet& own = parts[piece.job.project == "One" ? 0 : 1].sheet;
            const QRect box = inkedBox(own.image);
            QCOMPARE(sheet.wanted->image.copy(pictureBox(sheet, piece)), own.image.copy(box));
            QCOMPARE(sheet.wanted->stretch.copy(pictureBox(sheet, piece)),
                     own.wanted->stretch.copy(box));
        }
        parts[1].sheet.wanted->settings.law.exponents[0] = 0.6; // the pieces' laws differ
        QVERIFY(!filmSheet(parts, {}, planFilms(parts, {}), 0).wanted);
    }

    void filmSheet_passes_areThoseOfItsPieces() {
        std::vector<PieceToPack> parts{part("One", {40, 50, 30, 40}),
                                       part("Two", {60, 70, 30, 40})};
        parts[0].sheet.passes = parts[1].sheet.passes = 2;
        QCOMPARE(filmSheet(parts, {}, planFilms(parts, {}), 0).passes, 2);
    }

    void filmSheet_amountsOfInk_areKeptOnlyWithTheSameInk() {
        std::vector<PieceToPack> parts{part("Inks", {40, 50, 30, 40}),
                                       part("Also", {60, 70, 30, 40})};
        const QSize size = parts[0].sheet.image.size();
        const QImage plane(size, QImage::Format_RGBA8888);
        const WantedInk inks{parts[0].sheet.image, unstretched(size), {}, {plane, plane, "press"}};
        parts[0].sheet.wanted = parts[1].sheet.wanted = inks;
        parts[1].sheet.wanted->settings.densest = 1.2; // in the wanted colours already
        const auto film = [&] { return filmSheet(parts, {}, planFilms(parts, {}), 0); };
        const std::optional<WantedInk> kept = film().wanted;
        QVERIFY(kept && !kept->inks.isNull() && !losesInks(parts));
        parts[1].sheet.wanted->settings.limit = 1;
        QVERIFY(losesInks(parts));
        parts[1].sheet.wanted = inks;
        parts[1].sheet.wanted->inks.space = QStringLiteral("other");
        QVERIFY(losesInks(parts));
        // A picture without wanted colours is compensated already, for one pass of several.
        parts[1].sheet.wanted.reset();
        QVERIFY(!losesInks(parts));
        parts[0].sheet.wanted->settings.passes = 2;
        parts[0].sheet.passes = parts[1].sheet.passes = 2;
        QVERIFY(!film().wanted && losesInks(parts));
    }

    void planFilms_copies_areInRows() {
        const std::vector<PieceToPack> parts{part("Button", {90, 120, 30, 30}, 12)};
        const FilmPlan plan = planFilms(parts, {});
        QCOMPARE(plan.films.size(), std::size_t(1));
        QSet<int> lefts, tops, copies;
        for (const PlannedPiece& piece : plan.films[0].pieces) {
            lefts.insert(piece.box.left());
            tops.insert(piece.box.top());
            copies.insert(piece.copy);
        }
        QCOMPARE(lefts.size(), 4);
        QCOMPARE(tops.size(), 3);
        QCOMPARE(copies.size(), 12);
    }

    // Two pieces with the same code could not be told apart.
    void filmSheet_jobGivenTwice_numbersItsCopiesThrough() {
        std::vector<PieceToPack> parts{
            part("A", {90, 120, 30, 30}, 2), part("B", {90, 120, 30, 30}),
            part("A", {90, 120, 30, 30}, 2), part("A", {90, 120, 30, 30})};
        parts[3].dip = 2;
        const Sheet sheet = filmSheet(parts, {}, planFilms(parts, {}), 0);
        QStringList names;
        for (const SheetPiece& piece : sheet.pieces) {
            names << QStringLiteral("%1 dip %2: %3 of %4")
                         .arg(piece.job.project)
                         .arg(piece.dip)
                         .arg(piece.copy)
                         .arg(piece.copies);
        }
        names.sort();
        QCOMPARE(names, QStringList({"A dip 1: 1 of 4", "A dip 1: 2 of 4", "A dip 1: 3 of 4",
                                     "A dip 1: 4 of 4", "A dip 2: 1 of 1", "B dip 1: 1 of 1"}));
    }

    void planFilms_tooManyCopies_continueOnTheNextFilm() {
        const std::vector<PieceToPack> parts{part("Button", {90, 120, 30, 30}, 50)};
        const FilmPlan plan = planFilms(parts, {});
        QCOMPARE(plan.films.size(), std::size_t(4));
        std::size_t count = 0;
        for (const PlannedFilm& film : plan.films) {
            count += film.pieces.size();
        }
        QCOMPARE(count, std::size_t(50));
    }

    void filmSheet_roll_endsAfterTheLastPiece() {
        PackingFilm roll;
        roll.isRoll = true;
        roll.size = {610, 2000};
        const std::vector<PieceToPack> parts{part("Button", {90, 120, 30, 30}, 20)};
        const FilmPlan plan = planFilms(parts, roll);
        QCOMPARE(plan.films.size(), std::size_t(1));
        const Sheet sheet = filmSheet(parts, roll, plan, 0);
        // Two rows of 56 mm, the spacing between them, and the edges.
        QVERIFY2(std::abs(sheet.filmHeight.value() - (5 + 56 + 3 + 56 + 10)) < 0.5,
                 qPrintable(QStringLiteral("the film is %1 mm long, expected 130 mm")
                                .arg(sheet.filmHeight.value())));
        QCOMPARE(sheetPixels(sheet.filmWidth, sheet.filmHeight, sheet.settings.resolution),
                 sheet.image.size());
    }

    void planFilms_sheetTooLargeForRoll_namesTheRollAndTheJob() {
        PackingFilm roll;
        roll.isRoll = roll.wholeSheets = true;
        roll.size = {100, 2000};
        try {
            planFilms({part("Button", {90, 120, 30, 30})}, roll);
            QFAIL("the sheet was not refused");
        } catch (const Error& error) {
            QVERIFY2(error.sentence().contains("the roll has only"), qPrintable(error.sentence()));
            QVERIFY2(error.where().contains("Button"), qPrintable(error.where()));
        }
    }

    // A film that is too large for memory gives the same files as a film in memory.
    void filmSheet_madeInRows_givesTheSameFiles() {
        std::vector<PieceToPack> parts{part("Turned", {40, 50, 20, 30}),
                                       part("Upright", {60, 70, 30, 20}, 2)};
        parts[0].turning = Turning::Always;
        PackingFilm film;
        film.size = {120, 150};
        for (PieceToPack& piece : parts) {
            Sheet& own = piece.sheet;
            own.settings.white = WhiteLayer::Last;
            own.settings.cutLine = CutLine::Ink;
            QImage white = own.image.convertToFormat(QImage::Format_Grayscale8);
            own.plates = {{own.settings.whiteName, white}};
        }
        const FilmPlan plan = planFilms(parts, film);
        const Sheet whole = filmSheet(parts, film, plan, 0);
        const Sheet rows = filmSheet(parts, film, plan, 0, 0);
        QVERIFY(!whole.rows && rows.rows && rows.image.isNull());
        QCOMPARE(filmPixels(rows), whole.image.size());
        QCOMPARE(sheetRows(rows, 500, 900).image,
                 whole.image.copy(0, 500, whole.image.width(), 400));
        const PrinterColour inks(simpleCmykProfile(0.002), RenderingIntent::RelativeColorimetric,
                                 false, "inks.icc");
        for (const PrinterColour* colour : {static_cast<const PrinterColour*>(nullptr), &inks}) {
            const PrintCorrection correction{.scaleX = 0.97, .scaleY = 1.02, .colour = colour};
            for (const auto& write : {writeSheetPdf, writeSheetTiff}) {
                const QByteArray bytes =
                    bytesOf([&](QIODevice& device) { write(whole, device, correction); });
                QVERIFY(bytes.size() > 10'000);
                QVERIFY(bytes ==
                        bytesOf([&](QIODevice& device) { write(rows, device, correction); }));
            }
        }
    }

    // 3 m at 600 dpi have 70 866 rows, more than an image in memory may have.
    void filmSheet_longRoll_isOneFilm() {
        PieceToPack piece;
        Sheet& own = piece.sheet;
        own.filmWidth = own.filmHeight = Millimetres(30);
        own.settings.resolution = DotsPerInch(600);
        own.settings.jobLine = false;
        own.image = QImage(709, 709, QImage::Format_RGBA8888);
        own.image.fill(Qt::transparent);
        for (int y = 100; y < 500; ++y) {
            for (int x = 200; x < 600; ++x) {
                own.image.setPixel(x, y, qRgb(x % 251, y % 241, (x + y) % 239));
            }
        }
        piece.copies = 85;
        PackingFilm roll;
        roll.isRoll = true;
        roll.size = {50, 3000};
        const FilmPlan plan = planFilms({piece}, roll);
        QCOMPARE(plan.films.size(), std::size_t(1));
        const Sheet sheet = filmSheet({piece}, roll, plan, 0);
        QVERIFY2(sheet.filmHeight.value() > 2900, qPrintable(sheet.job.film));
        const QString path =
            save(bytesOf([&](QIODevice& device) { writeSheetTiff(sheet, device); }), "roll.tif");
        TIFF* tiff = TIFFOpen(qPrintable(path), "r");
        QVERIFY(tiff);
        const auto close = qScopeGuard([&] { TIFFClose(tiff); });
        std::uint32_t width = 0, height = 0;
        TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &width);
        TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &height);
        QCOMPARE(int(width), 1181);
        QCOMPARE(int(height), int(std::lround(sheet.filmHeight.value() * 600 / 25.4)));
        // The last copy has the pixels of its own sheet.
        const QPoint corner =
            (sheet.pieces.back().pictureOnPage().topLeft() * 600 / 25.4).toPoint();
        std::vector<uchar> row(std::size_t(TIFFScanlineSize(tiff)));
        for (int y = 0; y < 400; y += 57) {
            for (int line = y == 0 ? 0 : corner.y() + y - 56; line <= corner.y() + y; ++line) {
                QCOMPARE(TIFFReadScanline(tiff, row.data(), std::uint32_t(line)), 1);
            }
            for (int x = 0; x < 400; x += 31) {
                const uchar* pixel = row.data() + 3 * (corner.x() + x);
                QCOMPARE(qRgb(pixel[0], pixel[1], pixel[2]), own.image.pixel(200 + x, 100 + y));
            }
        }
    }

    // Whole sheets keep their size and their own marks. Cut marks stand in the gap between them.
    void filmSheet_wholeSheets_haveCutMarksInTheirGaps() {
        PackingFilm roll;
        roll.isRoll = roll.wholeSheets = true;
        roll.size = {300, 3000};
        roll.spacing = Millimetres(10);
        const std::vector<PieceToPack> parts{part("Shell", {40, 50, 30, 40}, 3)};
        const FilmPlan plan = planFilms(parts, roll);
        QCOMPARE(plan.films.size(), std::size_t(1));
        const Sheet sheet = filmSheet(parts, roll, plan, 0);
        QVERIFY(std::abs(sheet.filmHeight.value() - (5 + 3 * 297 + 2 * 10 + 10)) < 0.5);
        for (const SheetPiece& piece : sheet.pieces) {
            QVERIFY(std::abs(piece.box().width() - 210) < 0.1);
            QVERIFY(std::abs(piece.box().height() - 297) < 0.1);
        }
        const QString path = save(pdfOf(sheet), QStringLiteral("series.pdf"));
        const QString words = pdfWords(path);
        QCOMPARE(words.count("Job " + jobNumber("Shell")), 6); // on each sheet, and in each gap
        QVERIFY2(words.contains("copy 2 of 3"), qPrintable(words));
        // Across the gap after the first sheet, a mark at its lower edge and one at the next.
        const QRectF first = sheet.pieces[0].box();
        constexpr int dpi = 600;
        const QImage gap =
            renderedPage(path, dpi, QRectF(first.left() - 3, first.bottom() - 5, 2.3, 20));
        const std::vector<double> lines = darkMiddles(gap, false, gap.width() / 2);
        QCOMPARE(lines.size(), std::size_t(2));
        QVERIFY2(std::abs((lines[1] - lines[0]) * 25.4 / dpi - 10) < 0.1,
                 qPrintable(QString::number((lines[1] - lines[0]) * 25.4 / dpi)));
        QVERIFY(std::abs(lines[0] * 25.4 / dpi - 5) < 0.1);
    }

    void writeSheetPdf_packedSquares_measure17mm() {
        PieceToPack chess = part("Chess", {}, 2);
        QPainter painter(&chess.sheet.image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(2480 / 210.0, 3508 / 297.0);
        for (int column = 0; column < 5; ++column) {
            painter.fillRect(QRectF(60 + 17 * column, 60, 8.5, 30), Qt::black);
        }
        painter.end();
        const FilmPlan plan = planFilms({chess}, {});
        const Sheet sheet = filmSheet({chess}, {}, plan, 0);
        const QString path = save(pdfOf(sheet), QStringLiteral("chess.pdf"));
        QCOMPARE(pdfPage(path).toSize(), QSize(210, 297));
        constexpr int dpi = 1200;
        for (const SheetPiece& piece : sheet.pieces) {
            const QRectF picture = piece.picture.translated(piece.corner);
            const QImage grey = renderedPage(path, dpi, picture.adjusted(-2, 5, 2, -5));
            const std::vector<double> middles = darkMiddles(grey, true, grey.height() / 2);
            QCOMPARE(middles.size(), std::size_t(5));
            for (std::size_t i = 1; i < middles.size(); ++i) {
                const double pitch = (middles[i] - middles[0]) / double(i) * 25.4 / dpi;
                QVERIFY2(std::abs(pitch - 17) < 0.02,
                         qPrintable(
                             QStringLiteral("a square measures %1 mm, expected 17 mm").arg(pitch)));
            }
        }
    }

    void writeSheetPdf_pieces_haveTextAndCode() {
        std::vector<PieceToPack> parts = nineParts();
        parts.resize(3);
        parts[1].copies = 2;
        parts[2].dip = 2;
        parts[2].turning = Turning::Always;
        const FilmPlan plan = planFilms(parts, {});
        const QString path =
            save(pdfOf(filmSheet(parts, {}, plan, 0)), QStringLiteral("words.pdf"));
        const QString words = pdfWords(path).simplified();
        QStringList codes = QString::fromUtf8(output("sh", {"-c",
                                                            "pdftoppm -r 400 -png \"$1\" \"$2\" && "
                                                            "zbarimg --quiet --raw \"$2\"*.png",
                                                            "-", path, folder_.filePath("codes")}))
                                .split('\n', Qt::SkipEmptyParts);
        codes.sort();
        QStringList expected;
        for (const PieceToPack& piece : parts) {
            for (int copy = 1; copy <= piece.copies; ++copy) {
                expected << QStringLiteral("%1/%2/%3")
                                .arg(piece.sheet.job.hash)
                                .arg(piece.dip)
                                .arg(copy);
            }
            QVERIFY2(words.contains("Job " + piece.sheet.job.hash), qPrintable(words));
        }
        expected.sort();
        QCOMPARE(codes, expected);
        QVERIFY2(words.contains("Dip 1, copy 2 of 2"), qPrintable(words));
    }

    void writeSheetPdf_samePieces_giveTheSameBytes() {
        const std::vector<PieceToPack> parts = nineParts();
        const auto once = [&] { return pdfOf(filmSheet(parts, {}, planFilms(parts, {}), 0)); };
        QCOMPARE(once(), once());
    }

    void planFilms_unpackablePieces_areRefused() {
        const auto refused = [](const std::vector<PieceToPack>& parts, const char* words) {
            try {
                planFilms(parts, {});
                qWarning("packed, expected a refusal");
                return false;
            } catch (const Error& error) {
                return error.sentence().contains(QLatin1String(words));
            }
        };
        QVERIFY(refused({part("Large", {1, 1, 205, 290})}, "use a larger film"));
        QVERIFY(refused({part("Blank", {})}, "no ink"));
        QVERIFY(refused({}, "1 to"));
        QVERIFY(refused({part("Many", {90, 120, 30, 30}, 2001)}, "1 to"));
        std::vector<PieceToPack> mixed{part("A", {90, 120, 30, 30}), part("B", {90, 120, 30, 30})};
        mixed[1].sheet.settings.resolution = DotsPerInch(600);
        QVERIFY(refused(mixed, "same resolution"));
        mixed[1].sheet.settings.resolution = mixed[0].sheet.settings.resolution;
        mixed[1].sheet.passes = 2;
        QVERIFY(refused(mixed, "same number of passes"));
    }

    // The bleed leaves the marks, the job line and the next piece free. Each piece has one contour.
    void filmSheet_cutContourAndBleed_endBeforeMarksAndNextPiece() {
        std::vector<PieceToPack> parts{part("A", {90, 120, 30, 20}, 2),
                                       part("B", {60, 70, 20, 30})};
        parts[1].turning = Turning::Always;
        for (PieceToPack& piece : parts) {
            SheetSettings& settings = piece.sheet.settings;
            settings.cutLine = CutLine::Ink;
            settings.cutDistance = Millimetres(4);
            settings.cutBleed = Millimetres(2);
        }
        PackingFilm film;
        film.size = {192, 75};
        film.spacing = Millimetres(0);
        const FilmPlan plan = planFilms(parts, film);
        QCOMPARE(plan.films.size(), std::size_t(1));
        const Sheet sheet = filmSheet(parts, film, plan, 0);
        QCOMPARE(sheet.pieces.size(), std::size_t(3));
        const PrinterColour inks(simpleCmykProfile(0.002), RenderingIntent::RelativeColorimetric,
                                 false, "inks.icc");
        const PrintCorrection correction{.colour = &inks};
        const double unit = sheet.image.width() / sheet.filmWidth.value();
        const auto grown = [](const QRectF& box, double by) {
            return box.adjusted(-by, -by, by, by);
        };
        const Plates plates = separate(sheet, correction);
        QImage inked(plates.size, QImage::Format_Grayscale8);
        for (int y = 0; y < inked.height(); ++y) {
            for (int x = 0; x < inked.width(); ++x) {
                const char* pixel = plates.cmyk.constData() + 4 * (y * inked.width() + x);
                inked.scanLine(y)[x] = std::any_of(pixel, pixel + 4, [](char ink) { return ink; });
            }
        }
        QImage outside = inked;
        const auto contours = cutContour(sheet, sheetLayout(sheet)).toSubpathPolygons();
        QCOMPARE(contours.size(), 3);
        for (const SheetPiece& piece : sheet.pieces) {
            const QRectF printed = grown(piece.pictureOnPage(), 4 + 2);
            QVERIFY(piece.box().contains(grown(printed, leastPieceMargin - 0.1)));
            const QRect pixels =
                QRectF(printed.topLeft() * unit, printed.size() * unit).toAlignedRect();
            const QRect reached = markedBox(inked.copy(pixels));
            QVERIFY(pixels.width() - reached.width() < 5 && pixels.height() - reached.height() < 5);
            QPainter(&outside).fillRect(pixels.adjusted(-2, -2, 2, 2), Qt::black);
            QCOMPARE(
                std::count_if(contours.begin(), contours.end(),
                              [&](const QPolygonF& contour) {
                                  return grown(printed, -2 + 0.2).contains(contour.boundingRect());
                              }),
                1);
        }
        QVERIFY(markedBox(outside).isEmpty()); // no ink elsewhere
        // The upper right mark of the piece that is not turned stands past the bleed.
        const SheetPiece& upright = *std::find_if(sheet.pieces.begin(), sheet.pieces.end(),
                                                  [](const auto& one) { return !one.turned; });
        const QPointF centre = grown(upright.pictureOnPage(), 4 + 2 + 3.5).topRight();
        constexpr int dpi = 600;
        const QImage mark = renderedPage(save(pdfOf(sheet), QStringLiteral("bleed.pdf")), dpi,
                                         {centre - QPointF(2.5, 2.5), QSizeF(5, 5)});
        const std::vector<double> lines = darkMiddles(mark, true, mark.height() / 4);
        QVERIFY(std::any_of(lines.begin(), lines.end(), [&](double at) {
            return std::abs(at - mark.width() / 2.0) < 0.1 / 25.4 * dpi;
        }));
    }

    void planFilms_cutContourPastAWholeSheet_isRefused() {
        PackingFilm roll;
        roll.isRoll = roll.wholeSheets = true;
        roll.size = {300, 2000};
        std::vector<PieceToPack> parts{part("Shell", {5, 50, 30, 40})};
        SheetSettings& settings = parts[0].sheet.settings;
        settings.cutLine = CutLine::Ink;
        settings.cutDistance = Millimetres(3);
        settings.cutBleed = Millimetres(1);
        planFilms(parts, roll);
        settings.cutBleed = Millimetres(3);
        try {
            planFilms(parts, roll);
            QFAIL("the contour was not refused");
        } catch (const Error& error) {
            QVERIFY2(error.sentence().contains("reaches 6 mm from the ink, past the edge"),
                     qPrintable(error.sentence()));
        }
    }

    // One film has one cut contour. The order of the jobs must not decide which.
    void checkSettings_differentCutContours_areRefused() {
        const auto refusal = [](const auto& change, CutLine line) {
            std::vector<PieceToPack> parts{part("A", {}), part("B", {}), part("C", {})};
            for (PieceToPack& piece : parts) {
                piece.sheet.settings.cutLine = line;
            }
            change(parts[2].sheet.settings);
            try {
                checkSettings(parts);
                return QString();
            } catch (const Error& error) {
                return error.sentence();
            }
        };
        const auto line = [](SheetSettings& s) { s.cutLine = CutLine::Ink; };
        const auto name = [](SheetSettings& s) { s.cutName = QStringLiteral("Knife"); };
        const auto distance = [](SheetSettings& s) { s.cutDistance = Millimetres(4); };
        const auto bleed = [](SheetSettings& s) { s.cutBleed = Millimetres(1); };
        QCOMPARE(refusal(line, CutLine::None),
                 QStringLiteral("The setting “Cut contour” differs between this job and A, Top; "
                                "give both the same value (C, Top)"));
        QVERIFY(refusal(line, CutLine::Film).contains("“Cut contour”"));
        QVERIFY(refusal(name, CutLine::Film).contains("“Name of the cut contour”"));
        QVERIFY(refusal(distance, CutLine::Ink).contains("“Distance of the cut contour”"));
        QVERIFY(refusal(bleed, CutLine::Ink).contains("“Bleed at the cut contour”"));
        // Values without effect may differ.
        QCOMPARE(refusal(name, CutLine::None), QString());
        QCOMPARE(refusal(distance, CutLine::Film), QString());
        QCOMPARE(refusal(bleed, CutLine::Film), QString());
        QCOMPARE(refusal([](SheetSettings& s) { s.bleed = Millimetres(5); }, CutLine::Ink),
                 QString());
    }
};

QTEST_MAIN(FilmPackingTest)
#include "FilmPackingTest.moc"
